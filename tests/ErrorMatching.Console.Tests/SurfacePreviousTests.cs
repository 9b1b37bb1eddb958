using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>A surface that is compensated piece by piece, each time from the report before.</summary>
public sealed class SurfacePreviousTests
{
    [Fact]
    public void The_correction_goes_on_from_the_report_before()
    {
        using var folder = new TemporaryFolder();
        var finished = First(folder);

        var second = Shell.Json(
            0,
            "errormatch/surface-compensate/1",
            "surface",
            "compensate",
            finished,
            "--measured",
            Sample("after.csv"),
            "--previous",
            folder["out/report.json"],
            "--cut-by",
            folder["out/finishing.nc"],
            "--out",
            folder["second"]);

        // The piece is off by 1 um, but the surface stays moved by what its program had corrected, and a little more.
        Assert.InRange(second.GetProperty("compensation").GetProperty("largestMoveUm").GetDouble(), 20, 30);
        Assert.Equal(2, second.GetProperty("lot").GetProperty("pieces").GetArrayLength());
        Assert.Equal(folder["out/report.json"], second.GetProperty("cutBy").GetProperty("previous").GetString());
        var page = File.ReadAllText(folder["second/report.html"]);
        Assert.Contains("The pieces so far", page, StringComparison.Ordinal);
        Assert.Contains("--previous", page, StringComparison.Ordinal);

        // The shop's own program is displaced from the nominal one by the whole correction.
        var displaced = Shell.Json(
            0,
            "errormatch/surface-displace/1",
            "surface",
            "displace",
            finished,
            "--measured",
            Sample("after.csv"),
            "--previous",
            folder["out/report.json"],
            "--program",
            Sample("cam.nc"));
        Assert.InRange(displaced.GetProperty("largestMoveMm").GetDouble(), 0.020, 0.030);
    }

    [Fact]
    public void A_report_that_does_not_belong_to_the_piece_is_refused()
    {
        using var folder = new TemporaryFolder();
        var finished = First(folder);
        Assert.Equal("same-measurement", Refused(2, "out/report.json", Sample("measured.csv"), Later(finished)));
        Assert.Equal("previous-differs", Refused(2, "out/report.json", Sample("after.csv"), finished, "--cut-by", Sample("cam.nc")));
        var other = folder.File("other.nc", File.ReadAllText(folder["out/finishing.nc"]).Replace(
            "MEASUREMENT=", "MEASUREMENT=0", StringComparison.Ordinal));
        Assert.Equal("previous-differs", Refused(2, "out/report.json", Sample("after.csv"), finished, "--cut-by", other));

        Assert.Equal("not-a-compensation", Refused(1, "finished.json", Sample("after.csv"), finished));
        var report = File.ReadAllText(folder["out/report.json"]);
        folder.File("old.json", report.Replace("\"lot\"", "\"none\"", StringComparison.Ordinal));
        Assert.Equal("lot-missing", Refused(1, "old.json", Sample("after.csv"), finished));
        Assert.Contains("\"withheld\": null", report, StringComparison.Ordinal);
        folder.File(
            "withheld.json",
            report.Replace("\"withheld\": null", "\"withheld\": { \"code\": \"outside\" }", StringComparison.Ordinal));
        Assert.Equal("previous-withheld", Refused(1, "withheld.json", Sample("after.csv"), finished));
        folder.File("surface.json", report.Replace("\"role\": \"surface\"", "\"role\": \"another\"", StringComparison.Ordinal));
        Assert.Equal("other-surface", Refused(1, "surface.json", Sample("after.csv"), finished));

        string Refused(int exit, string previous, string measured, string job, params string[] more) => Shell.Error(
            exit, ["surface", "compensate", job, "--measured", measured, "--previous", folder[previous], .. more]).Text("code")!;
    }

    // The same measurement again, as that of a piece with stock.
    private static string Later(string finished) => finished.Replace("finished.json", "job.json", StringComparison.Ordinal);

    // Compensates the first piece, and writes the job for finished pieces.
    private static string First(TemporaryFolder folder)
    {
        File.Copy(Sample("surface.igs"), folder["surface.igs"]);
        var job = folder.File("job.json", File.ReadAllText(Sample("job.json")).Replace(
            "\"scallopMm\": 0.001, \"chordMm\": 0.001", "\"scallopMm\": 0.05, \"chordMm\": 0.01", StringComparison.Ordinal));
        Assert.Equal(0, Shell.Run(["surface", "compensate", job, "--measured", Sample("measured.csv"), "--out", folder["out"]]).Exit);
        return folder.File(
            "finished.json", File.ReadAllText(job).Replace("\"semi-finishing\"", "\"finishing\"", StringComparison.Ordinal));
    }

    private static string Sample(string file) => Repository.PathTo("samples", "surface-one", file);
}
