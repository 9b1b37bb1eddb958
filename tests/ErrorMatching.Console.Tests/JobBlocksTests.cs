using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>What <c>errormatch job blocks</c> prints, writes and refuses.</summary>
public sealed class JobBlocksTests
{
    [Fact]
    public void Blocks_are_printed_by_feature_with_their_lines_and_nothing_is_written()
    {
        using var folder = Shop();
        var job = folder.File(
            "job.json",
            Regex.Replace(
                File.ReadAllText(folder["job.json"]), "\"blocks\": \\[\"N120\"\\], ", "", RegexOptions.None, TimeSpan.FromSeconds(1)));
        var before = State(folder);
        var (exit, output, error) = Shell.Run("job", "blocks", job);
        Assert.Equal((0, ""), (exit, error));

        // The lines are those of the program in an editor.
        Assert.Equal(
            [
                $"Complex mating: blocks of 3 of 3 features found in {folder["counterpart.nc"]} by their key points",
                "",
                "feature  kind      points  blocks         lines  in the job",
                "L1       line           2  N120              19  none",
                "L2L3     triangle       4  N130..N160    21..24  the same",
                "C1       curve         10  N170..N1190  26..128  the same",
                "",
                "A proposal by the distances of the points: look at the blocks before you use them, by errormatch nc locate.",
                "Nothing was written. Add --out FILE to write the job with these blocks.",
                "",
            ],
            output.Split('\n'));
        Assert.Equal(before, State(folder));
    }

    [Fact]
    public void The_document_has_blocks_lines_and_what_the_job_names_itself()
    {
        using var folder = Shop();
        var job = folder.File(
            "job.json", File.ReadAllText(folder["job.json"]).Replace("\"N130..N160\"", "\"N130\", \"N150\"", StringComparison.Ordinal));
        var document = Shell.Json(0, "errormatch/job-blocks/1", "job", "blocks", job, "--out", folder["new.json"]);
        Assert.Equal(
            (job, folder["counterpart.nc"], "delta-nc300", folder["new.json"]),
            (document.Text("job"), document.Text("program"), document.Text("dialect"), document.Text("written")));
        var features = document.GetProperty("features").EnumerateArray().ToArray();
        Assert.Equal(
            [
                "L1|line|1,2|N120|N120|True",
                "L2L3|triangle|2a,3a,3b,4|N130..N160|N130,N150|False",
                "C1|curve|5,6,7,8,9,10,11,12,13,14|N170..N1190|N170..N1190|True"],
            features.Select(f =>
            $"{f.Text("name")}|{f.Text("kind")}|{Texts(f, "points")}|{Texts(f, "blocks")}|{Texts(f, "inJob")}|"
                + $"{f.GetProperty("sameAsInJob").GetBoolean()}"));
        var pass = Assert.Single(features[1].GetProperty("passes").EnumerateArray());
        Assert.Equal(
            ("N130", 21.0, "N160", 24.0),
            (
                pass.GetProperty("first").Text("block"),
                pass.GetProperty("first").Number("line"),
                pass.GetProperty("last").Text("block"),
                pass.GetProperty("last").Number("line")));
        Assert.All(features, f => Assert.Equal((null, null), (f.Text("code"), f.Text("reason"))));

        // The job as it was before it was spoiled.
        Assert.Equal(File.ReadAllText(Repository.PathTo("samples", "complex-mating", "job.json")), File.ReadAllText(folder["new.json"]));
        Assert.StartsWith(
            $"{folder["new.json"]} is a valid mating job", Shell.Run("job", "check", folder["new.json"]).Output, StringComparison.Ordinal);

        static string Texts(System.Text.Json.JsonElement json, string name) =>
            string.Join(',', json.GetProperty(name).EnumerateArray().Select(t => t.GetString()));
    }

    [Fact]
    public void A_feature_without_blocks_is_exit_2_with_its_reason_and_nothing_is_written()
    {
        using var folder = Shop();

        // The path leads from (-34.939, 80) to (-34.995, 59.757), at y = 63 through x = -34.986:
        // 1.638 mm from point 2, where a tool of 6 mm leaves 3.
        var points = File.ReadAllText(folder["theoretical.csv"]);
        folder.File("theoretical.csv", points.Replace("2,-32.348,58.346", "2,-33.348,63.000", StringComparison.Ordinal));
        var before = State(folder);
        string[] arguments = ["job", "blocks", folder["job.json"], "--out", folder["new.json"]];
        var (exit, output, error) = Shell.Run(arguments);
        Assert.Equal(2, exit);
        Assert.Contains("blocks of 2 of 3 features found", output, StringComparison.Ordinal);
        Assert.Contains("\nL1       line           2  not found             N120\n", output, StringComparison.Ordinal);
        Assert.EndsWith("\nNothing was written: a job needs blocks for each of its features.\n", output, StringComparison.Ordinal);
        Assert.StartsWith(
            $"{folder["counterpart.nc"]}:19: L1, N120: of all cuts this is the nearest, and the point 2 lies 1.638 mm from the path; "
                + $"expected 3 mm, one tool radius",
            error,
            StringComparison.Ordinal);

        var document = Shell.Json(2, "errormatch/job-blocks/1", arguments);
        Assert.Equal(2, document.GetProperty("exit").GetInt32());
        var item = Assert.Single(document.GetProperty("errors").EnumerateArray());
        Assert.Equal(("boundary-not-found", "N120", 19), (item.Text("code"), item.Text("block"), item.GetProperty("line").GetInt32()));
        var missed = document.GetProperty("features")[0];
        Assert.Equal(
            ("boundary-not-found", item.Text("message")),
            (missed.Text("code"), $"{folder["counterpart.nc"]}: {missed.Text("reason")}"));
        Assert.Null(document.Text("written"));
        Assert.Equal(before, State(folder));
    }

    [Fact]
    public void No_input_is_ever_replaced()
    {
        using var folder = Shop();
        var before = State(folder);
        foreach (var input in new[] { "job.json", "theoretical.csv", "counterpart.nc" })
        {
            Assert.Equal("output-is-input", Shell.Error(1, "job", "blocks", folder["job.json"], "--out", folder[input]).Text("code"));
        }

        Assert.Equal(before, State(folder));
    }

    [Fact]
    public void What_cannot_be_used_is_said_with_its_place()
    {
        using var folder = Shop();
        var text = File.ReadAllText(folder["job.json"]);

        // A free-form job has no blocks; a job that is wrong elsewhere is said to be; files that are not there are named.
        Assert.Equal(
            "$.kind",
            Shell.Json(1, "errormatch/error/1", "job", "blocks", Repository.PathTo("samples", "surface-one", "job.json"))
                .GetProperty("errors")
                .EnumerateArray()
                .First(e => e.Text("path") == "$.kind")
                .Text("path"));
        var error = Shell.Error(
            1,
            "job",
            "blocks",
            folder.File("bad.json", text.Replace("\"toolDiameterMm\": 6", "\"toolDiameterMm\": -6", StringComparison.Ordinal)));
        Assert.Equal(("too-small", "$.counterpart.toolDiameterMm"), (error.Text("code"), error.Text("path")));
        Assert.Equal(
            "file-unreadable",
            Shell.Error(
                1,
                "job",
                "blocks",
                folder.File("bad.json", text.Replace("\"counterpart.nc\"", "\"nope.nc\"", StringComparison.Ordinal))).Text("code"));
        Assert.Equal("file-unreadable", Shell.Error(1, "job", "blocks", folder["none.json"]).Text("code"));
    }

    private static IReadOnlyList<string> State(TemporaryFolder folder) =>
        [.. Directory.EnumerateFiles(folder.Path).Order(StringComparer.Ordinal).Select(f => f + File.ReadAllText(f))];

    private static TemporaryFolder Shop()
    {
        var folder = new TemporaryFolder();
        foreach (var file in new[] { "job.json", "theoretical.csv", "counterpart.nc" })
        {
            File.Copy(Repository.PathTo("samples", "complex-mating", file), folder[file]);
        }

        return folder;
    }
}
