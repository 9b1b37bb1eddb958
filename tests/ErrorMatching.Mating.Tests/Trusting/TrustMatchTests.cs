using System.Globalization;
using System.Text;
using ErrorMatching.Measurement;

namespace ErrorMatching.Mating.Tests;

/// <summary>What a match says of readings that are wrong, on the paper's part.</summary>
public sealed class TrustMatchTests
{
    // Dust of 0.2 mm under one point of the curve: the program follows it, and the verdict does not say to cut.
    [Fact]
    public void A_point_that_stands_out_is_to_be_measured_again()
    {
        var report = Match(Samples.Job("complex-mating"), (label, x, y) => label == "9" ? (x + 0.2, y) : (x, y));
        var suspect = Assert.Single(report.Trust!.Suspects);
        Assert.Equal(("9", "C1"), (suspect.Point, suspect.Feature));
        Assert.Equal(0.2, Math.Abs(suspect.StandsOutMm), 0.02);
        Assert.Equal((VerdictCode.SuspectPoints, false), (report.Verdict.Code, report.Verdict.IsToCut));
    }

    [Fact]
    public void A_point_that_is_taken_out_counts_no_more_and_is_named()
    {
        var text = File.ReadAllText(Samples.Job("complex-mating").File);
        var job = MatingJob.Parse(
            Encoding.UTF8.GetBytes(text.Replace("\"gauge\"", "\"without\": [\"9\"], \"gauge\"", StringComparison.Ordinal)),
            Samples.Job("complex-mating").File);
        var report = Match(job, (label, x, y) => label == "9" ? (x + 0.2, y) : (x, y));
        Assert.Equal((VerdictCode.Within, 15), (report.Verdict.Code, report.Verdict.Points));
        Assert.Equal(["9"], report.Without);
    }

    [Theory]
    [InlineData("\"without\": [\"99\"]", "unknown-point")]
    [InlineData("\"commonMotionMm\": 0", "too-small")]
    public void A_key_that_is_wrong_is_named(string key, string code)
    {
        var text = File.ReadAllText(Samples.Job("complex-mating").File);
        var refused = Assert.Throws<Refusals.InputException>(() => MatingJob.Parse(
            Encoding.UTF8.GetBytes(text.Replace("\"gauge\"", key + ", \"gauge\"", StringComparison.Ordinal)), "job.json"));
        Assert.Equal(code, Assert.Single(refused.Refusals).Code);
    }

    // The nominal part, shifted: the same shift is in each reading. Deviations of half a millimeter at four points of L2L3 leave 0.052
    // possible between them.
    [Theory]
    [InlineData(null, VerdictCode.CheckOrigin)]
    [InlineData(0.6, VerdictCode.NotKnownBetween)]
    public void A_motion_that_explains_all_asks_for_the_origin(double? most, VerdictCode code)
    {
        var job = Samples.Job("complex-mating") with { CommonMotionMm = most };
        var designed = Samples.Points("complex-mating", "theoretical.csv");
        var report = Match(job, (label, _, _) => (designed[label].X + 0.3, designed[label].Y + 0.4));
        var motion = report.Trust!.Motion!;
        Assert.Equal((0.3, 0.4, 0), (Math.Round(motion.ShiftMm.X, 3), Math.Round(motion.ShiftMm.Y, 3), Math.Round(motion.TurnDeg, 3)));
        Assert.True(motion is { IsSignificant: true, Explains: > 0.9999 });
        Assert.Equal((code, true), (report.Verdict.Code, report.Verdict.IsToCut));
    }

    private static MatchReport Match(MatingJob job, Func<string, double, double, (double X, double Y)> measured)
    {
        var theoretical = MeasurementReader.Read(job.PathOf(job.Part.Theoretical), MeasurementFormat.Points);
        var rows = Samples.Points("complex-mating", "part.csv").Select(p => (p.Key, At: measured(p.Key, p.Value.X, p.Value.Y))).Select(
            p => string.Create(CultureInfo.InvariantCulture, $"{p.Key},{p.At.X:0.000000},{p.At.Y:0.000000}\n"));
        var part = MeasurementReader.Read(
            Encoding.UTF8.GetBytes("point,x_mm,y_mm\n" + string.Concat(rows)), "part.csv", MeasurementFormat.Points);
        var outcome = Matcher.Match(new(
            job, theoretical, part, null, "counterpart.nc", File.ReadAllBytes(job.PathOf(job.Counterpart.Program))));
        Assert.True(outcome.Result is not null, string.Join('\n', outcome.Refusals));
        return MatchReporter.Report(outcome.Result, "counterpart.nc", null);
    }
}
