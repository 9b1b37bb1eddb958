using ErrorMatching.Measurement;

namespace ErrorMatching.Mating.Tests;

/// <summary>Counterparts cut and measured one after the other, each by the program that the one before it led to. The boundary is a line
/// that the tool follows above; the part is as designed.</summary>
public sealed class CounterpartLotTests(ITestOutputHelper output)
{
    private const double U = 0.001;

    // The machine scatters from piece to piece by more than the gauge.
    private const double ScatterMm = 0.003;

    [Fact]
    public void What_is_left_falls_below_the_scatter_of_one_counterpart()
    {
        var (single, lot) = (0.0, 0.0);
        for (var seed = 0; seed < 3; seed++)
        {
            single += Cost(Cut(20, _ => 0.03, seed, goesOn: false));
            lot += Cost(Cut(20, _ => 0.03, seed, goesOn: true));
        }

        // A program that corrects the last counterpart cuts its scatter into the next one. The mean of n counterparts has an nth of its
        // square; from the fifth to the twentieth, that is 0.09 on average.
        output.WriteLine($"{lot / single:0.000} of the squares of single corrections");
        Assert.InRange(lot / single, 0.05, 0.25);
    }

    [Fact]
    public void A_new_tool_is_followed_and_reported()
    {
        var made = Cut(12, k => k < 6 ? 0.02 : 0.05, 3, goesOn: true);

        Assert.Equal(LotEvent.Step, made[7].Match.Lot!.Next!.Pieces[6].Event);
        var warning = Assert.Single(
            MatchReporter.Report(made[7].Match, "out/counterpart.nc", null).Warnings, w => w.Code == LotWords.Moved.Name);
        Assert.Equal(["7", "8"], warning.Values.Take(2));

        // Of 30 um, no more is left than the scatter of the four pieces since.
        Assert.InRange(Math.Abs(made[9].LeftMm), 0, 2 * ScatterMm);
    }

    // Such a step waits for a second counterpart, because it may be a chip; a changed tool is believed at once.
    [Theory]
    [InlineData(false, -0.02, 0.004)]
    [InlineData(true, -0.05, 0.006)]
    public void A_changed_tool_is_believed_at_once(bool isAnnounced, double expected, double within)
    {
        var made = Cut(8, k => k < 7 ? 0.02 : 0.05, 3, goesOn: true, scatterMm: 0.001, toolChangedAt: isAnnounced ? 7 : -1);
        Assert.InRange(made[^1].Now, expected - within, expected + within);
        var report = MatchReporter.Report(made[^1].Match, "out/counterpart.nc", null);
        var read = MatchReportJson.Read(Reporting.ReportReader.Document(MatchReportJson.Write(report)));
        Assert.Equal(isAnnounced, read.Lot!.Pieces.Pieces[^1].Values.IsAfterToolChange);
        Assert.False(read.Lot.Pieces.Pieces[^2].Values.IsAfterToolChange);
    }

    // Left uncorrected, it adds 2 % to what cannot be known.
    [Fact]
    public void What_is_not_worth_a_correction_costs_two_percent()
    {
        var lot = Cut(6, _ => 0.02, 3, goesOn: true)[^1].Match.Lot!;
        var unknown = Math.Sqrt(lot.Next!.UncertaintyMm.Average(u => u * u));
        Assert.InRange(Math.Sqrt((unknown * unknown) + (lot.WorthMm!.Value * lot.WorthMm.Value)) / unknown, 1.0190, 1.0200);
    }

    // Each piece alone, and all of them in single steps, are below the noise of one measurement.
    [Fact]
    public void A_slow_drift_is_followed_before_one_piece_shows_it()
    {
        var made = Cut(22, k => 0.0002 * k, 17, goesOn: true, scatterMm: 0);
        Assert.All(made.Skip(12), m => Assert.InRange(Math.Abs(m.LeftMm), 0, 0.0012));
        Assert.InRange(made[^1].Now, -0.0052, -0.0036);
        Assert.Equal(Decision.NotSignificant, made[0].Match.Decision.Features[0].Decision);
    }

    // The part's own noise is the same for all counterparts: nothing is gained by following it.
    [Fact]
    public void What_the_part_may_only_seem_to_be_off_is_not_followed()
    {
        var outcome = Second("1 5 0.002; 2 15 0.001; 3 25 -0.001; 4 35 0.0015; 5 45 0.0005");
        Assert.Equal(Decision.NotSignificant, outcome.Decision.Features[0].Decision);
        Assert.All(outcome.Decision.Features[0].Points, p => Assert.InRange(Math.Abs(p.Point.FollowedMm), 0, 0.0005));

        // Its points are off by more than what is worth a correction: the report must not say the opposite.
        Assert.Contains(outcome.Decision.Features[0].Points, p => Math.Abs(p.Point.DecidedMm) > outcome.Decision.Features[0].SignificantMm);
        var page = System.Text.Encoding.UTF8.GetString(MatchReportHtml.Write(MatchReporter.Report(outcome, "out/counterpart.nc", null)));
        Assert.Contains("what the counterparts so far say of the next one", page, StringComparison.Ordinal);
        Assert.DoesNotContain("But none lies more than", page, StringComparison.Ordinal);

        // Five points that are off by 4 u are: no part without an error shows that.
        var off = Second("1 5 0.004; 2 15 0.004; 3 25 0.004; 4 35 0.004; 5 45 0.004");
        Assert.Equal(Decision.Compensated, off.Decision.Features[0].Decision);
        Assert.All(off.Prediction.Features[0].Points, p => Assert.InRange(Math.Abs(p.AfterMm), 0, 0.001));

        static MatchResult Second(string part)
        {
            var first = Case("1 5 0.0001; 2 15 -0.0002; 3 25 0; 4 35 0.0001; 5 45 0.0003", Programs.ToolAbove) with { Part = part };
            var lot = Matcher.Match(first.Input).Result!.Lot!.Pieces;
            var second = Case("1 5 -0.0001; 2 15 0.0002; 3 25 0.0002; 4 35 0; 5 45 0.0001", Programs.ToolAbove) with { Part = part };
            var previous = new PreviousMatch("report.json", "", lot with { CorrectionsMm = new double[5] });
            return Matcher.Match(second.Input with { Previous = previous }).Result!;
        }
    }

    [Fact]
    public void A_measurement_that_does_not_fit_hardly_counts()
    {
        var made = Cut(8, k => k == 6 ? 0.2 : 0.02, 5, goesOn: true);

        var warning = Assert.Single(
            MatchReporter.Report(made[6].Match, "out/counterpart.nc", null).Warnings, w => w.Code == LotWords.Outlier.Name);
        Assert.Equal("6", warning.Values[0]);
        Assert.InRange(Math.Abs(made[6].Now + 0.02), 0, ScatterMm);
    }

    [Fact]
    public void The_uncertainty_falls_with_the_pieces_to_that_of_the_part()
    {
        var made = Cut(15, _ => 0.02, 7, goesOn: true, scatterMm: 0);
        double Uncertainty(int k) => made[k].Match.Decision.Features[0].StandardUncertaintyMm;

        Assert.Equal(Math.Sqrt(2) * U, Uncertainty(0), 12);
        Assert.InRange(Uncertainty(14), U, 1.1 * U);
    }

    [Fact]
    public void A_report_carries_the_lot()
    {
        var made = Cut(3, _ => 0.02, 9, goesOn: true)[^1].Match;
        var report = MatchReporter.Report(made, "out/counterpart.nc", null);
        var read = MatchReportJson.Read(Reporting.ReportReader.Document(MatchReportJson.Write(report)));

        Assert.Equal(made.Input.Job.KeyPoints, read.Lot!.Pieces.Points);
        Assert.Equal(3, read.Lot.Pieces.Pieces.Count);
        Assert.Equal(3, read.Lot.Next!.Pieces.Count);
        Assert.Equal(
            made.Lot!.Pieces.CorrectionsMm.Select(c => Math.Round(c, 9)), read.Lot.Pieces.CorrectionsMm.Select(c => Math.Round(c, 9)));
        var page = System.Text.Encoding.UTF8.GetString(MatchReportHtml.Write(report));
        Assert.Contains("The pieces so far", page, StringComparison.Ordinal);

        // A counterpart follows its part, so what it is off its design is not what is left.
        Assert.Contains("Off its design, mean", page, StringComparison.Ordinal);
        Assert.Contains(report.Notes, n => n.StartsWith("The compensation follows 3 pieces.", StringComparison.Ordinal));
    }

    // The corrections of a program are where its boundary is, by the words that it contains.
    [Fact]
    public void The_corrections_are_those_of_the_program()
    {
        foreach (var made in Cut(4, k => 0.02 + (0.005 * k), 11, goesOn: true))
        {
            foreach (var correction in made.Match.Lot!.Pieces.CorrectionsMm)
            {
                Assert.Equal(made.Now, correction, 0.002);
            }
        }
    }

    [Fact]
    public void The_same_measurement_counts_once()
    {
        var first = Case(Line(0.03), Programs.ToolAbove).Match();
        var lot = first.Lot!.Pieces;
        var outcome = Matcher.Match(Case(Line(0.03), Programs.ToolAbove).Input with { Previous = new("report.json", "", lot) });

        Assert.Equal("same-measurement", outcome.Refusal!.Code);
    }

    private static List<(MatchResult Match, double LeftMm, double Now)> Cut(
        int pieces, Func<int, double> process, int seed, bool goesOn, double scatterMm = ScatterMm, int toolChangedAt = -1)
    {
        var random = new Random(seed);
        var made = new List<(MatchResult Match, double LeftMm, double Now)>();
        var series = new CounterpartSeries(U, goesOn);
        for (var k = 0; k < pieces; k++)
        {
            var shift = series.NowMm + process(k) + (scatterMm * Noise(random));
            var match = series.Measure(_ => shift + (U * Noise(random)), toolChanged: k == toolChangedAt);
            made.Add((match, series.NowMm + process(k + 1), series.NowMm));
        }

        return made;
    }

    private static double Cost(List<(MatchResult Match, double LeftMm, double Now)> made) => made.Skip(4).Sum(m => m.LeftMm * m.LeftMm);

    private static string Line(double y) => CounterpartSeries.Line(_ => y);

    private static MatchCase Case(string counterpart, string program) => CounterpartSeries.Case(counterpart, program, U);

    private static double Noise(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
}
