using System.Text;

namespace ErrorMatching.Mating.Tests;

/// <summary>A verification from files to report, on points worked out by hand.</summary>
public sealed class VerifyRunTests
{
    // Part at 0.1, counterparts at 0 and 0.09. The counterpart's material is above: at 0 it overlaps the part by 0.1, at 0.09 by 0.01.
    [Theory]
    [InlineData(Programs.ToolBelow, 0.1, 0.01)]
    [InlineData(Programs.ToolAbove, -0.1, -0.01)]
    public void Positive_is_an_overlap_and_negative_a_gap(string program, double before, double after)
    {
        var report = Report(new MatchCase(program), "1 10 0; 2 40 0", "1 10 0.09; 2 40 0.09");

        Assert.All(
            report.Result.Points,
            p => Assert.Equal((before, after), (Math.Round(p.BeforeError.NormalMm, 9), Math.Round(p.AfterError.NormalMm, 9))));
        Assert.All(
            report.Result.Points,
            p => Assert.Equal((0, -0.1), (Math.Round(p.BeforeError.Vector.X, 9), Math.Round(p.BeforeError.Vector.Y, 9))));
        Assert.Equal((0.1, 0.01), (Math.Round(report.Result.MaxBeforeMm, 9), Math.Round(report.Result.MaxAfterMm, 9)));
        Assert.Equal(90, report.Result.Features[0].ImprovementPercent!.Value, 6);
    }

    [Fact]
    public void A_counterpart_that_is_cut_as_predicted_has_the_predicted_error()
    {
        var match = new MatchCase(Programs.ToolBelow) { Compensation = """{ "gain": 0.5 }""" };
        var report = Report(match, "1 10 0; 2 40 0", "1 10 0.05; 2 40 0.05");

        Assert.Equal(match.Report().KeyPoints[0].PredictedMm, report.Result.Points[0].AfterError.NormalMm, 6);
    }

    [Fact]
    public void Balls_and_alignments_are_those_of_the_job()
    {
        var match = new MatchCase(Programs.ToolBelow)
        {
            Gauge = """ "uncertaintyMm": 0, "reports": "stylus-center", "stylusDiameterMm": 2 """,
            Theoretical = "1 10 0; 2 40 0; O 0 0; D 50 0",
            Part = "1 12 1.1; 2 42 1.1; O 2 0; D 52 0",
            More = """ "alignment": { "kind": "datum", "origin": "O", "direction": "D" }, """,
        };
        var report = Report(match, "1 10 -1; 2 40 -1; O 0 0; D 50 0", "1 10 -0.9; 2 40 -0.9; O 0 0; D 50 0");

        Assert.All(
            report.Result.Points,
            p => Assert.Equal((0.1, 0), (Math.Round(p.BeforeError.NormalMm, 9), Math.Round(p.AfterError.NormalMm, 9))));
    }

    [Fact]
    public void A_counterpart_that_nobody_measured_is_taken_as_designed()
    {
        // The ball's radius belongs to what was measured, and not to what is designed.
        var match = new MatchCase(Programs.ToolBelow)
        {
            Gauge = """ "uncertaintyMm": 0, "reports": "stylus-center", "stylusDiameterMm": 2 """,
            Part = "1 10 1.1; 2 40 1.1"
        };
        var report = VerifyRun.Report(Input(match, "1 10 0; 2 40 0", "1 10 -0.91; 2 40 -0.91") with { Before = null }, out _)!;

        Assert.All(
            report.Result.Points,
            p => Assert.Equal((0.1, 0.01), (Math.Round(p.BeforeError.NormalMm, 9), Math.Round(p.AfterError.NormalMm, 9))));
        Assert.False(report.IsBeforeMeasured);
        Assert.Equal(["theoretical", "part", "counterpart-after", "program"], report.Inputs.Select(i => i.Role));
        Assert.StartsWith(
            "No counterpart that was cut without compensation is measured", report.Warnings.Single(), StringComparison.Ordinal);
    }

    [Fact]
    public void A_boundary_has_its_points_and_limits_and_what_the_program_cuts()
    {
        var boundary = Report(new MatchCase(Programs.ToolBelow), "1 10 0; 2 40 0", "1 10 0.09; 2 40 0.09").Result.Boundaries.Single();

        Assert.Equal([("1", 10.0, 0.0), ("2", 40.0, 0.0)], boundary.Points.Select(p => (p.Label, p.Theoretical.X, p.Theoretical.Y)));
        Assert.All(boundary.Outline, p => Assert.Equal(0, p.Y, 9));
        Assert.True(boundary.Outline.Max(p => p.X) - boundary.Outline.Min(p => p.X) >= 30);
    }

    [Fact]
    public void Inputs_are_named_with_their_hashes()
    {
        var match = new MatchCase(Programs.ToolBelow);
        var report = Report(match, "1 10 0; 2 40 0", "1 10 0.09; 2 40 0.09");

        Assert.Equal(["theoretical", "part", "counterpart", "counterpart-after", "program"], report.Inputs.Select(i => i.Role));
        Assert.Equal(match.Input.ProgramSha256, report.Inputs[^1].Sha256);
    }

    [Theory]
    [InlineData(true, FeatureMapper.PointOffPath)]
    [InlineData(false, OriginCheck.OriginOff)]
    public void What_cannot_be_compared_is_refused(bool wrongFrame, string code)
    {
        var match = new MatchCase(Programs.ToolBelow)
        {
            Theoretical = "1 10 0; 2 40 0; O 0 0",
            Part = "1 10 0.1; 2 40 0.1; O 0 0",
            Frame = wrongFrame ? """{ "translateMm": [0, 1] }""" : "{}",
            More = """ "originCheck": { "point": "O", "limitMm": 0.01 }, """,
        };

        Assert.Null(VerifyRun.Report(
            Input(match, "1 10 0; 2 40 0; O 0 0", "1 10 0; 2 40 0; O 0 " + (wrongFrame ? "0.009" : "0.011")), out var refusals));
        Assert.Equal(code, Assert.Single(refusals).Code);
    }

    private static VerifyReport Report(MatchCase match, string before, string after)
    {
        var report = VerifyRun.Report(Input(match, before, after), out var refusals);
        Assert.Empty(refusals);
        Assert.Equal(["1", "2"], report!.Result.Points.Select(p => p.Label).Order(StringComparer.Ordinal));
        return report;
    }

    private static VerifyInput Input(MatchCase match, string before, string after) => new(
        match.Job,
        MatchCase.Points("theoretical.csv", match.Theoretical),
        MatchCase.Points("part.csv", match.Part),
        MatchCase.Points("counterpart.csv", before),
        MatchCase.Points("counterpart-after.csv", after),
        "counterpart.nc",
        Encoding.ASCII.GetBytes(match.Program));
}
