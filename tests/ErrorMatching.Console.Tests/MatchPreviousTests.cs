using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>Counterparts that are corrected one after the other by feedback, each time from the report before.</summary>
public sealed class MatchPreviousTests
{
    [Fact]
    public void The_correction_goes_on_from_the_report_before()
    {
        using var folder = new TemporaryFolder();
        var job = First(folder);

        var second = Shell.Json(
            0,
            "errormatch/match/1",
            [.. Second(folder, job, "out/report.json"), "--out", folder["second"], "--accept", "outside-limits"]);

        var lot = second.GetProperty("lot");
        Assert.Equal(2, lot.GetProperty("pieces").GetArrayLength());

        // Both counterparts show the same process, so the correction stays what it is. Points 2 and 4 lie at corners that the tool leaves
        // round, so no program puts the boundary where they want it.
        var before = JsonDocument.Parse(File.ReadAllText(folder["out/report.json"])).RootElement.GetProperty("lot");
        var labels = lot.GetProperty("points").EnumerateArray().Select(p => p.GetString()!).ToList();
        foreach (var i in Enumerable.Range(0, labels.Count).Where(i => labels[i] is not ("2" or "4")))
        {
            Assert.Equal(before.GetProperty("correctionsUm")[i].GetDouble(), lot.GetProperty("correctionsUm")[i].GetDouble(), 6.0);
        }
        Assert.Equal(
            ["theoretical", "part", "counterpart", "program", "previous"],
            second.GetProperty("inputs").EnumerateArray().Select(i => i.GetProperty("role").GetString()));
        var page = File.ReadAllText(folder["second/report.html"]);
        Assert.Contains("The pieces so far", page, StringComparison.Ordinal);
        Assert.Contains("--previous", page, StringComparison.Ordinal);

        // The third piece goes on from both.
        var third = Shell.Json(
            0,
            "errormatch/match/1",
            "match",
            job,
            "--counterpart",
            Next(folder, "second/report.json", "third.csv"),
            "--program",
            folder["second/counterpart.nc"],
            "--previous",
            folder["second/report.json"],
            "--accept",
            "outside-limits");
        Assert.Equal(3, third.GetProperty("lot").GetProperty("pieces").GetArrayLength());
    }

    // While the first counterpart was measured, the second one was cut with the same nominal program, and the third one while the
    // second one was measured.
    [Fact]
    public void Counterparts_may_be_measured_late()
    {
        using var folder = new TemporaryFolder();
        var job = First(folder);
        folder.File("second.csv", File.ReadAllText(folder["counterpart.csv"]) + "\n");
        var second = Shell.Json(
            0,
            "errormatch/match/1",
            "match", job, "--counterpart", folder["second.csv"], "--latest", folder["out/report.json"],
            "--out", folder["second"], "--accept", "any");
        Assert.Equal(2, Pieces(second));
        Assert.Equal(
            ["theoretical", "part", "counterpart", "program", "latest"],
            second.GetProperty("inputs").EnumerateArray().Select(i => i.GetProperty("role").GetString()));
        Assert.Contains("--latest", File.ReadAllText(folder["second/report.html"]), StringComparison.Ordinal);

        string[] third = [
            "match", job, "--counterpart", Next(folder, "out/report.json", "third.csv"), "--program", folder["out/counterpart.nc"],
            "--previous", folder["out/report.json"], "--latest"];
        var made = Shell.Json(0, "errormatch/match/1", [.. third, folder["second/report.json"], "--accept", "any"]);
        Assert.Equal(3, Pieces(made));

        // The third piece is what its own program corrects, and no more: the process that it shows is that of the first.
        var pieces = made.GetProperty("lot").GetProperty("pieces");
        Assert.NotEqual(0, pieces[2].GetProperty("correctionsUm")[0].GetDouble());
        Assert.Equal(0, pieces[1].GetProperty("correctionsUm")[0].GetDouble());

        folder.File("other.csv", File.ReadAllText(folder["counterpart.csv"]) + "\n\n");
        Shell.Json(
            0, "errormatch/match/1", "match", job, "--counterpart", folder["other.csv"], "--out", folder["other"], "--accept", "any");
        Assert.Equal("other-lot", Shell.Error(1, [.. third, folder["other/report.json"]]).Text("code"));

        // Without its report, nobody knows what the program corrects.
        Assert.Equal(
            "previous-missing",
            Shell.Error(
                1, "match", job, "--counterpart", folder["third.csv"], "--program", folder["out/counterpart.nc"],
                "--latest", folder["second/report.json"]).Text("code"));
        Assert.Equal(
            "previous-not-feedback",
            Shell.Error(1, "match", Sample("job.json"), "--latest", folder["out/report.json"]).Text("code"));

        static int Pieces(JsonElement match) => match.GetProperty("lot").GetProperty("pieces").GetArrayLength();
    }

    [Fact]
    public void A_report_that_does_not_belong_to_the_counterpart_is_refused()
    {
        using var folder = new TemporaryFolder();
        var job = First(folder);
        var report = File.ReadAllText(folder["out/report.json"]);
        Assert.Equal("not-a-match", Refused("job.json"));
        Put("lot-less.json", "\"lot\"", "\"none\"");
        Assert.Equal("lot-missing", Refused("lot-less.json"));
        Put("withheld.json", "\"withheld\": null", "\"withheld\": { \"code\": \"outside-limits\", \"sentence\": \"\" }");
        Assert.Equal("previous-withheld", Refused("withheld.json"));
        Put("design.json", "\"role\": \"theoretical\"", "\"role\": \"another\"");
        Assert.Equal("other-points", Refused("design.json"));
        Assert.Equal(
            "other-program",
            Shell.Error(1, "match", job, "--counterpart", folder["second.csv"], "--previous", folder["out/report.json"])
                .Text("code"));
        Assert.Equal(
            "previous-not-feedback",
            Shell.Error(1, "match", Sample("job.json"), "--previous", folder["out/report.json"]).Text("code"));

        void Put(string name, string what, string with) => folder.File(name, report.Replace(what, with, StringComparison.Ordinal));
        string Refused(string previous) => Shell.Error(1, Second(folder, job, previous)).Text("code")!;
    }

    private static string[] Second(TemporaryFolder folder, string job, string previous) =>
        [
            "match", job, "--counterpart", Next(folder, "out/report.json", "second.csv"), "--program", folder["out/counterpart.nc"],
            "--previous", folder[previous],
        ];

    // The next counterpart of a program: as designed, moved by what the program corrects and by the error of the process.
    private static string Next(TemporaryFolder folder, string report, string file)
    {
        var json = JsonDocument.Parse(File.ReadAllText(folder[report])).RootElement;
        var lot = json.GetProperty("lot");
        var rows = json.GetProperty("keyPoints").EnumerateArray().Select((point, i) =>
        {
            var mm = (lot.GetProperty("correctionsUm")[i].GetDouble()
                + lot.GetProperty("pieces")[0].GetProperty("errorsUm")[i].GetDouble()) / 1000;
            return FormattableString.Invariant($"{point.Text("point")},{At("x"):0.0000},{At("y"):0.0000}");

            double At(string axis) => point.GetProperty("theoretical").Number(axis) + (mm * point.GetProperty("normal").Number(axis));
        });
        return folder.File(file, "point,x_mm,y_mm\n" + string.Join('\n', rows) + "\n");
    }

    private static string Sample(string name) => Repository.PathTo("samples", "complex-mating", name);

    // The sample by feedback, with its first counterpart corrected.
    private static string First(TemporaryFolder folder)
    {
        foreach (var name in new[] { "theoretical.csv", "part.csv", "counterpart.csv", "counterpart.nc" })
        {
            File.Copy(Sample(name), folder[name]);
        }

        var text = File.ReadAllText(Sample("job.json"));
        var job = folder.File(
            "job.json", text.Replace("\"from\": \"part\"", "\"from\": \"counterpart\"", StringComparison.Ordinal)
                .Replace("\"mapMm\": 0.5", "\"mapMm\": 3", StringComparison.Ordinal));
        Shell.Json(
            0,
            "errormatch/match/1",
            ["match", job, "--counterpart", folder["counterpart.csv"], "--out", folder["out"], "--accept", "outside-limits"]);
        return job;
    }
}
