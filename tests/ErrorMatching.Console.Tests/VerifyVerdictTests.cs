using System.Globalization;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>The verdict on a counterpart that is cut and measured. The paper's is up to 0.35 mm off at limits of 0.05.</summary>
public sealed class VerifyVerdictTests
{
    [Fact]
    public void A_piece_outside_its_limits_says_so_first()
    {
        var (exit, output, error) = Shell.Run(Verify("counterpart-after.csv"));

        Assert.Equal((0, ""), (exit, error));
        Assert.Matches(@"^\d+ of 16 points are outside ±0\.05: points .+ the furthest, by 0\.\d+ ± 0\.0150?\.", output.Split('\n')[0]);
        Assert.StartsWith("Risk that a point is outside its limits: more than 99.9 %.", output.Split('\n')[1], StringComparison.Ordinal);

        var verdict = Shell.Json(0, "errormatch/verify/1", Verify("counterpart-after.csv")).GetProperty("verdict");
        Assert.Equal("outside-limits", verdict.Text("code"));
        Assert.False(verdict.GetProperty("inTolerance").GetBoolean());
        Assert.Contains("4", verdict.GetProperty("outside").EnumerateArray().Select(p => p.GetString()));
        Assert.Equal(output.Split('\n')[0], verdict.Text("sentence"));
    }

    [Fact]
    public void A_required_tolerance_is_exit_2_with_all_files()
    {
        using var folder = new TemporaryFolder();
        string[] verify = [.. Verify("counterpart-after.csv"), "--require-in-tolerance", "--out", folder["out"]];

        var (exit, output, error) = Shell.Run(verify);

        Assert.Equal(2, exit);
        Assert.Contains("counterpart-after.csv: " + output.Split('\n')[0], error, StringComparison.Ordinal);
        Assert.Equal(4, Directory.GetFiles(folder["out"]).Length);
        var page = File.ReadAllText(folder["out/verify.html"]);
        Assert.Contains("<p id=\"verdict\" class=\"verdict fails\"><strong>✗ ", page, StringComparison.Ordinal);

        var json = Shell.Json(2, "errormatch/verify/1", [.. Verify("counterpart-after.csv"), "--require-in-tolerance"]);
        Assert.Equal(2, json.GetProperty("exit").GetInt32());
        Assert.Equal("out-of-tolerance", json.GetProperty("errors")[0].Text("code"));
    }

    [Fact]
    public void A_piece_within_its_limits_passes()
    {
        using var folder = new TemporaryFolder();
        var like = folder.File("like.csv", File.ReadAllText(Sample("part.csv")) + "\n");

        var (exit, output, _) = Shell.Run([.. Verify(like), "--require-in-tolerance"]);

        Assert.Equal(0, exit);
        Assert.StartsWith("16 of 16 points are within ±0.05 (worst 0.000 ± 0.015).", output, StringComparison.Ordinal);
        Assert.Equal(
            "within-limits", Shell.Json(0, "errormatch/verify/1", Verify(like)).GetProperty("verdict").Text("code"));
    }

    // The same as if the designed points had been measured as the counterpart before.
    [Fact]
    public void Without_a_counterpart_before_it_is_the_one_as_designed()
    {
        using var folder = new TemporaryFolder();
        var designed = folder.File("designed.csv", File.ReadAllText(Sample("theoretical.csv")));
        string[] alone = ["verify", Sample("job.json"), "--after", Sample("counterpart-after.csv")];

        var (one, other) = (
            Shell.Json(0, "errormatch/verify/1", alone),
            Shell.Json(0, "errormatch/verify/1", [.. alone, "--before", designed]));

        Assert.False(one.GetProperty("beforeMeasured").GetBoolean());
        Assert.Equal(other.GetProperty("points").GetRawText(), one.GetProperty("points").GetRawText());
        Assert.InRange(one.GetProperty("maxBeforeMm").GetDouble(), 0.05, 1);
        var said = Shell.Run(alone);
        Assert.Equal(0, said.Exit);
        Assert.Contains(
            "the largest mating error is 0.3496 mm; of the counterpart as designed it would be 0.", said.Output, StringComparison.Ordinal);
        Assert.Contains("No counterpart that was cut without compensation is measured", said.Output + said.Error, StringComparison.Ordinal);

        // How much better that is than an uncompensated counterpart, nobody knows.
        var table = said.Output.Split("better by")[1].Split("Lengths in mm")[0];
        Assert.DoesNotContain("%", table, StringComparison.Ordinal);
    }

    [Fact]
    public void Without_limits_none_can_be_required()
    {
        using var folder = new TemporaryFolder();
        var job = Job(folder, text => text.Replace("[-0.05, 0.05]", "[0, 0]", StringComparison.Ordinal));
        string[] verify = ["verify", job, "--before", Sample("counterpart.csv"), "--after", Sample("counterpart-after.csv")];

        Assert.Equal("no-limits", Shell.Json(0, "errormatch/verify/1", verify).GetProperty("verdict").Text("code"));
        Assert.Equal("tolerance-missing", Shell.Error(1, [.. verify, "--require-in-tolerance"]).Text("code"));
    }

    [Fact]
    public void A_guard_band_that_does_not_accept_a_point_is_not_in_tolerance()
    {
        using var folder = new TemporaryFolder();
        var job = Job(folder, text => text.Replace(
            "\"features\"", "\"decision\": { \"rule\": \"guard-band\", \"riskPercent\": 5 },\n  \"features\"", StringComparison.Ordinal));

        // Limits of ±0.05 less 1.645 * 0.0054 * √2.
        var after = folder.File("after.csv", Moved(0.0376));
        string[] verify = ["verify", job, "--before", Sample("counterpart.csv"), "--after", after, "--require-in-tolerance"];

        var verdict = Shell.Json(2, "errormatch/verify/1", verify).GetProperty("verdict");
        Assert.Equal("within-limits", verdict.Text("code"));
        Assert.Equal(["1"], verdict.GetProperty("notAccepted").EnumerateArray().Select(p => p.GetString()));
        Assert.False(verdict.GetProperty("inTolerance").GetBoolean());

        folder.File("after.csv", Moved(0.0373));
        Assert.Equal(0, Shell.Run(verify).Exit);
    }

    // The part itself, with point 1 moved towards the tool, in -x.
    private static string Moved(double mm)
    {
        var lines = File.ReadAllLines(Sample("part.csv"));
        var at = Array.FindIndex(lines, l => l.StartsWith("1,", StringComparison.Ordinal));
        var cells = lines[at].Split(',');
        var x = double.Parse(cells[1], CultureInfo.InvariantCulture) - mm;
        lines[at] = FormattableString.Invariant($"1,{x:0.0000},{cells[2]}");
        return string.Join('\n', lines) + "\n";
    }

    private static string[] Verify(string after) =>
        ["verify", Sample("job.json"), "--before", Sample("counterpart.csv"), "--after", Path.IsPathRooted(after) ? after : Sample(after)];

    private static string Job(TemporaryFolder folder, Func<string, string> change)
    {
        foreach (var name in new[] { "theoretical.csv", "part.csv", "counterpart.csv", "counterpart.nc" })
        {
            File.Copy(Sample(name), folder[name]);
        }

        return folder.File("job.json", change(File.ReadAllText(Sample("job.json"))));
    }

    private static string Sample(string name) => Repository.PathTo("samples", "complex-mating", name);
}
