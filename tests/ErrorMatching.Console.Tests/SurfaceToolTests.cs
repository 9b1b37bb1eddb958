using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>What the console says of the tool of a surface's programs, and of the program that cut the measured piece.</summary>
public sealed class SurfaceToolTests
{
    private const string Tool = ", \"tool\": { \"number\": 3, \"lengthOffset\": 1 } }";

    [Fact]
    public void Without_a_tool_nothing_but_the_verdict_precedes_the_alarm()
    {
        using var folder = new TemporaryFolder();
        var job = Job(folder, " }");
        foreach (var verb in (string[][])[["toolpath", job], ["compensate", job, "--measured", Sample("measured.csv")]])
        {
            var (exit, output, _) = Shell.Run(["surface", .. verb, "--out", folder["out"]]);
            Assert.Equal(0, exit);
            var lines = output.Split('\n');
            Assert.Equal(verb[0] == "compensate", lines[0].StartsWith("Expected in tolerance: ", StringComparison.Ordinal));
            Assert.Equal(
                $"Surface one: {folder["out/finishing.nc"]} has no tool call and stops with an alarm",
                lines[verb[0] == "compensate" ? 1 : 0]);
            Assert.DoesNotContain("cut with", output, StringComparison.Ordinal);
            Assert.Contains("toolpath.tool", output, StringComparison.Ordinal);
            Assert.Contains("\nM0\nSETAL(65000,", File.ReadAllText(folder["out/finishing.nc"]), StringComparison.Ordinal);
        }

        Assert.Contains("no-tool-call", File.ReadAllText(folder["out/report.json"]), StringComparison.Ordinal);

        // Nothing in the report looks like a program to cut with.
        var report = File.ReadAllText(folder["out/report.html"]);
        Assert.DoesNotContain("class=\"verdict holds\"", report, StringComparison.Ordinal);
        Assert.InRange(
            report.IndexOf("has no tool call", StringComparison.Ordinal), 0, report.IndexOf("moved by at most", StringComparison.Ordinal));

        Assert.Equal(
            0,
            Shell.Json(0, "errormatch/nc-check/1", "nc", "check", folder["out/finishing.nc"], "--dialect", "siemens-840d")
                .GetProperty("problems")
                .GetArrayLength());
        Assert.False(Shell.Json(0, "errormatch/surface-toolpath/1", "surface", "toolpath", job).GetProperty("toolCall").GetBoolean());
    }

    [Fact]
    public void With_a_tool_it_is_called_and_a_name_is_for_Siemens()
    {
        using var folder = new TemporaryFolder();
        var called = Job(folder, Tool);
        Assert.True(
            Shell.Json(0, "errormatch/surface-toolpath/1", "surface", "toolpath", called, "--out", folder["out"])
                .GetProperty("toolCall")
                .GetBoolean());
        Assert.Contains("\nT3\nM6\nD1\n", File.ReadAllText(folder["out/finishing.nc"]), StringComparison.Ordinal);
        var named = Job(folder, ", \"tool\": { \"name\": \"BALL6\", \"lengthOffset\": 1 } }", "fanuc");
        var error = Shell.Error(1, "surface", "toolpath", named);
        Assert.Equal(("tool-by-name", "$.toolpath.tool.name", named), (error.Text("code"), error.Text("path"), error.Text("file")));
        var away = Shell.Error(1, "surface", "toolpath", Job(folder, ", \"template\": \"away.txt\" }"));
        Assert.Equal(("file-unreadable", "$.toolpath.template"), (away.Text("code"), away.Text("path")));
        folder.File("own.txt", "@head\nG0 Z{travle}\n");
        var own = Shell.Error(1, "surface", "toolpath", Job(folder, ", \"template\": \"own.txt\" }"));
        Assert.Equal(("bad-template", 2), (own.Text("code"), own.GetProperty("line").GetInt32()));
    }

    [Fact]
    public void A_piece_that_a_compensated_program_cut_is_refused_and_evaluated()
    {
        using var folder = new TemporaryFolder();
        var job = Job(folder, Tool);
        Assert.Equal(0, Shell.Run(["surface", "compensate", job, "--measured", Sample("measured.csv"), "--out", folder["out"]]).Exit);
        var bytes = File.ReadAllBytes(folder["out/finishing.nc"]);
        var finished = folder.File(
            "finished.json", File.ReadAllText(job).Replace("\"semi-finishing\"", "\"finishing\"", StringComparison.Ordinal));
        foreach (var more in (string[][])[["--out", folder["out"]], ["--cut-by", folder["out/finishing.nc"], "--out", folder["other"]]])
        {
            var error = Shell.Error(2, ["surface", "compensate", finished, "--measured", Sample("after.csv"), .. more]);
            Assert.Equal(("piece-compensated", folder["out/finishing.nc"]), (error.Text("code"), error.Text("file")));
        }

        Assert.Equal(bytes, File.ReadAllBytes(folder["out/finishing.nc"]));
        Assert.False(Directory.Exists(folder["other"]));
        Assert.Equal(0, Shell.Run(["surface", "evaluate", finished, "--measured", Sample("after.csv"), "--out", folder["out"]]).Exit);
    }

    private static string Job(TemporaryFolder folder, string tool, string dialect = "siemens-840d")
    {
        var text = File.ReadAllText(Sample("job.json"));
        Assert.Contains(Tool, text, StringComparison.Ordinal);
        if (!File.Exists(folder["surface.igs"]))
        {
            File.Copy(Sample("surface.igs"), folder["surface.igs"]);
        }

        return folder.File("job.json", text
            .Replace(
                "\"scallopMm\": 0.001, \"chordMm\": 0.001, \"dialect\": \"siemens-840d\"" + Tool,
                $"\"scallopMm\": 0.05, \"chordMm\": 0.01, \"dialect\": \"{dialect}\"{tool}",
                StringComparison.Ordinal));
    }

    private static string Sample(string file) => Repository.PathTo("samples", "surface-one", file);
}
