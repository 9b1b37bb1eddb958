using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>A program is written only if its verdict says to cut it, or if somebody accepts that verdict. By feedback, point 2 of the
/// sample stays outside its limits: it is at a corner that the tool leaves round.</summary>
public sealed class ObeyVerdictTests
{
    private static readonly string[] Reports = ["report.html", "report.json"];

    [Fact]
    public void A_match_that_is_not_to_cut_writes_its_reports_alone()
    {
        using var folder = new TemporaryFolder();
        string[] match = [
            "match", Feedback(folder), "--out", folder["out"], "--wish", folder["out/wish.json"],
            "--certificate", folder["out/proof.json"]];

        var (exit, output, error) = Shell.Run(match);

        Assert.Equal(2, exit);
        Assert.Equal(Reports, Written(folder));
        Assert.Contains("Do not cut it unless that is acceptable there.", output.Split('\n')[0], StringComparison.Ordinal);
        Assert.Contains(
            $"Wrote {Slashed(folder, "out/report.html")} and {Slashed(folder, "out/report.json")}.", output, StringComparison.Ordinal);
        Assert.Contains("points will be outside", error, StringComparison.Ordinal);
        Assert.Contains("No program is written", error, StringComparison.Ordinal);
        Assert.Contains("--accept outside-limits", error, StringComparison.Ordinal);

        var report = Report(folder);
        Assert.Equal(JsonValueKind.Null, report.GetProperty("accepted").ValueKind);
        Assert.False(report.GetProperty("verdict").GetProperty("cut").GetBoolean());
        Assert.Equal("outside-limits", report.GetProperty("withheld").Text("code"));
        Assert.Contains("--accept outside-limits", report.GetProperty("withheld").Text("sentence"), StringComparison.Ordinal);
        Assert.Contains("No program is written", File.ReadAllText(folder["out/report.html"]), StringComparison.Ordinal);
    }

    [Fact]
    public void The_document_of_such_a_match_has_the_report_and_the_reason()
    {
        using var folder = new TemporaryFolder();
        var json = Shell.Json(2, "errormatch/match/1", "match", Feedback(folder));

        Assert.Equal(2, json.GetProperty("exit").GetInt32());
        Assert.Equal("not-to-cut", json.GetProperty("errors")[0].Text("code"));
        Assert.Equal("outside-limits", json.GetProperty("verdict").Text("code"));
    }

    [Theory]
    [InlineData("outside-limits")]
    [InlineData("any")]
    [InlineData("not-accepted", "outside-limits")]
    public void An_accepted_verdict_writes_the_program_and_is_recorded(params string[] codes)
    {
        using var folder = new TemporaryFolder();
        string[] match = ["match", Feedback(folder), "--out", folder["out"], .. codes.SelectMany(c => new[] { "--accept", c })];

        var (exit, output, error) = Shell.Run(match);

        Assert.Equal((0, ""), (exit, error));
        Assert.Equal(["counterpart.nc", .. Reports], Written(folder));
        Assert.Contains("The program is written all the same: the verdict outside-limits was accepted.", output, StringComparison.Ordinal);
        Assert.Equal("outside-limits", Report(folder).Text("accepted"));
        Assert.Equal(JsonValueKind.Null, Report(folder).GetProperty("withheld").ValueKind);
        Assert.Contains("was accepted", File.ReadAllText(folder["out/report.html"]), StringComparison.Ordinal);
    }

    [Fact]
    public void To_accept_another_verdict_changes_nothing()
    {
        using var folder = new TemporaryFolder();
        Assert.Equal(2, Shell.Run("match", Feedback(folder), "--out", folder["out"], "--accept", "not-accepted").Exit);
        Assert.Equal(Reports, Written(folder));
    }

    [Fact]
    public void Nothing_is_accepted_where_the_verdict_says_to_cut()
    {
        using var folder = new TemporaryFolder();
        Assert.Equal(0, Shell.Run("match", Sample("complex-mating", "job.json"), "--out", folder["out"], "--accept", "any").Exit);
        Assert.Equal(JsonValueKind.Null, Report(folder).GetProperty("accepted").ValueKind);
    }

    [Theory]
    [InlineData("match", "outside", "Did you mean outside-limits?")]
    [InlineData("match", "not-acepted", "Did you mean not-accepted?")]
    [InlineData("match", "proof-fails", "expected any, not-accepted,")]
    [InlineData("surface", "outside-limits", "Did you mean outside?")]
    public void A_code_that_is_no_verdict_is_named_with_those_that_are(string verb, string code, string expected)
    {
        string[] command = verb == "match" ? [verb, "job.json"] : [verb, "compensate", "job.json", "--measured", "measured.csv"];
        var error = Shell.Error(1, [.. command, "--accept", code]);
        Assert.Equal("command-line", error.Text("code"));
        Assert.Contains($"--accept is {code}", error.Text("message"), StringComparison.Ordinal);
        Assert.Contains(expected, error.Text("message"), StringComparison.Ordinal);
    }

    [Fact]
    public void A_program_of_an_earlier_run_is_named_as_such()
    {
        using var folder = new TemporaryFolder();
        var job = Feedback(folder);
        Assert.Equal(0, Shell.Run("match", job, "--out", folder["out"], "--accept", "any").Exit);
        var before = File.ReadAllBytes(folder["out/counterpart.nc"]);

        var (exit, _, error) = Shell.Run("match", job, "--out", folder["out"]);

        Assert.Equal(2, exit);
        Assert.Equal(before, File.ReadAllBytes(folder["out/counterpart.nc"]));
        Assert.Contains("counterpart.nc: was there before this run", error.Replace('\\', '/'), StringComparison.Ordinal);
    }

    [Fact]
    public void The_original_in_the_same_folder_is_no_earlier_program()
    {
        using var folder = new TemporaryFolder();
        var (exit, _, error) = Shell.Run("match", Feedback(folder), "--out", folder[""]);
        Assert.Equal(2, exit);
        Assert.DoesNotContain("was there before", error, StringComparison.Ordinal);
    }

    [Fact]
    public void A_surface_that_is_not_to_cut_gets_its_reports_alone()
    {
        using var folder = new TemporaryFolder();
        string[] compensate = [
            "surface", "compensate", Surface(folder), "--measured", Sample("surface-one", "measured.csv"), "--out", folder["out"]];

        var (exit, output, error) = Shell.Run(compensate);

        Assert.Equal(2, exit);
        Assert.Equal(Reports, Written(folder));
        Assert.StartsWith("Not sure to be in tolerance", output, StringComparison.Ordinal);
        Assert.Contains("--accept not-accepted", error, StringComparison.Ordinal);
        Assert.Equal("not-accepted", Report(folder).GetProperty("withheld").Text("code"));
        Assert.False(Report(folder).GetProperty("verdict").GetProperty("cut").GetBoolean());
        Assert.Contains("No program is written", File.ReadAllText(folder["out/report.html"]), StringComparison.Ordinal);

        Assert.Equal(2, Shell.Run([.. compensate, "--accept", "outside"]).Exit);
        Assert.Equal(0, Shell.Run([.. compensate, "--accept", "not-accepted"]).Exit);
        Assert.Equal(
            ["compensation.csv", "finishing.nc", .. Reports, "surface.igs", "surface.stp"],
            Written(folder));
        Assert.Equal("not-accepted", Report(folder).Text("accepted"));
    }

    [Fact]
    public void A_displaced_program_of_such_a_surface_is_not_written()
    {
        using var folder = new TemporaryFolder();
        string[] displace = [
            "surface", "displace", Surface(folder), "--measured", Sample("surface-one", "measured.csv"),
            "--program", Sample("surface-one", "cam.nc"), "--out", folder["out"]];

        var json = Shell.Json(2, "errormatch/surface-displace/1", displace);

        Assert.Equal("not-to-cut", json.GetProperty("errors")[0].Text("code"));
        Assert.False(Directory.Exists(folder["out"]));
        Assert.Equal("not-accepted", Shell.Json(0, "errormatch/surface-displace/1", [.. displace, "--accept", "any"]).Text("accepted"));
        Assert.Equal(["cam.nc"], Written(folder));
    }

    private static string[] Written(TemporaryFolder folder) =>
        [.. Directory.GetFiles(folder["out"]).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal)];

    private static JsonElement Report(TemporaryFolder folder)
    {
        using var document = JsonDocument.Parse(File.ReadAllBytes(folder["out/report.json"]));
        return document.RootElement.Clone();
    }

    private static string Slashed(TemporaryFolder folder, string name) => folder[name].Replace('\\', '/');

    private static string Feedback(TemporaryFolder folder)
    {
        foreach (var name in new[] { "theoretical.csv", "part.csv", "counterpart.csv", "counterpart.nc" })
        {
            File.Copy(Sample("complex-mating", name), folder[name]);
        }

        return folder.File(
            "job.json",
            File.ReadAllText(Sample("complex-mating", "job.json"))
                .Replace("\"from\": \"part\"", "\"from\": \"counterpart\"", StringComparison.Ordinal)
                .Replace("\"mapMm\": 0.5", "\"mapMm\": 3", StringComparison.Ordinal));
    }

    private static string Surface(TemporaryFolder folder) => folder.File(
        "job.json",
        File.ReadAllText(Sample("surface-one", "job.json"))
            .Replace("surface.igs", Sample("surface-one", "surface.igs").Replace('\\', '/'), StringComparison.Ordinal)
            .Replace("\"profileToleranceMm\": 0.02", "\"profileToleranceMm\": 0.004", StringComparison.Ordinal));

    private static string Sample(params string[] names) => Repository.PathTo(["samples", .. names]);
}
