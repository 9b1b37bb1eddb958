using System.Globalization;
using System.Text;
using ErrorMatching.Nc;
using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Mating.Tests;

/// <summary>What must hold for any deviation.</summary>
public sealed class MatchLaws
{
    /// <summary>A line, a notch with a fillet and a hill in one contour under G41; the tool is above.</summary>
    private const string Contour =
        "%\nO1000\nN10 G21 G90 G17\nN20 G0 X-20. Y20.\nN30 G1 G41 D1 Y0. F300\nN40 X0.\nN50 X12.6 Y-16.8\nN55 G3 X17.4 Y-16.8 I2.4 "
            + "J1.8\nN60 G1 X30. Y0.\nN70 X50.\nN80 G2 X70. Y0. I10. J0.\nN90 G1 X90.\nN100 G40 Y20.\nN110 M30\n%\n";

    private static readonly (string Label, double X, double Y, double NormalX, double NormalY)[] Places =
    [
        ("1", -15, 0, 0, 1), ("2", -5, 0, 0, 1),
        ("3", 3, -4, 0.8, 0.6), ("4", 9, -12, 0.8, 0.6), ("5", 21, -12, -0.8, 0.6), ("6", 27, -4, -0.8, 0.6),
        .. Enumerable.Range(0, 6)
            .Select(i => (i + 7, Angle: (160 - (28 * i)) * Math.PI / 180))
            .Select(
                p => (
                    p.Item1.ToString(CultureInfo.InvariantCulture),
                    60 + (10 * Math.Cos(p.Angle)),
                    10 * Math.Sin(p.Angle),
                    Math.Cos(p.Angle),
                    Math.Sin(p.Angle))),
    ];

    private static readonly string[] Features =
    [
        MatchCase.Line("L1", "N40", "1", "2"),
        MatchCase.Feature("triangle", "T1", "N50..N60", """[["3", "4"], ["5", "6"]]"""),
        MatchCase.Feature("curve", "C1", "N80", """["7..12"]"""),
    ];

    /// <summary>Deviations of the twelve points in micrometers, neighbors alike enough for the contour to follow.</summary>
    private static readonly Arbitrary<int[]> Deviations = Gen.ArrayOf(Gen.Choose(-40, 40), Places.Length).ToArbitrary();

    [Fact]
    public void The_order_of_lines_and_features_does_not_matter() => Check(Deviations, d =>
    {
        var match = Case(d, 1);
        var shuffled = match with
        {
            Theoretical = Reverse(match.Theoretical),
            Part = Reverse(match.Part),
            Features = [.. Features.Reverse()]
        };

        Assert.Equal(match.Rewritten(), shuffled.Rewritten());
    });

    [Fact]
    public void Scaled_deviations_are_the_deviations_with_a_gain() => Check(Deviations, d =>
    {
        var (scaled, gained) = (Case(d, 0.5).Match().After, (Case(d, 1) with { Compensation = """{ "gain": 0.5 }""" }).Match().After);
        for (var i = 0; i < scaled.Motions.Length; i++)
        {
            // A coordinate half way between two increments may round to either.
            Assert.InRange((scaled.Motions[i].End - gained.Motions[i].End).Length, 0, 0.0015);
        }
    });

    [Fact]
    public void A_part_without_deviation_leaves_every_byte() => Assert.Equal(Contour, Case(new int[Places.Length], 1).Rewritten());

    [Fact]
    public void What_has_been_matched_is_not_matched_again() => Check(Deviations, d =>
    {
        var match = Case(d, 1);
        if (match.Match().Marker is not null)
        {
            Assert.Equal(
                Marker.AlreadyCompensated, (match with { Program = Encoding.ASCII.GetString(match.Match().Program.Span) }).Refusal().Code);
        }
    });

    [Fact]
    public void Feedback_from_a_nominal_counterpart_is_feed_forward() => Check(Deviations, d =>
        Assert.Equal(
            Case(d, 1).Rewritten(),
            (
                Case(d, 1) with { Counterpart = Points(new int[Places.Length], 1), Compensation = """{ "from": "counterpart" }""" })
                .Rewritten()));

    // Two points determine a line or flank, so only the rounding of the program is left there.
    [Fact]
    public void Lines_and_flanks_leave_nothing_but_rounding() => Check(Deviations, d =>
    {
        var report = Case(d, 1).Report();
        Assert.All(report.KeyPoints.Where(p => p.Feature != "C1"), p => Assert.InRange(p.PredictedMm, -0.0015, 0.0015));
    });

    [Fact]
    public void Neither_culture_nor_repetition_changes_a_byte()
    {
        var match = Case([12, 34, -5, 6, 21, 8, -9, 10, 11, 12, -13, 14], 1);
        var (program, report) = (match.Match().Program.ToArray(), MatchReportJson.Write(match.Report()));
        var culture = CultureInfo.CurrentCulture;
        try
        {
            foreach (var (decimals, groups, minus) in new[] { (",", ".", "-"), (".", ",", "\u2212"), ("\u066B", "\u066C", "\u200E-") })
            {
                var other = (CultureInfo)CultureInfo.InvariantCulture.Clone();
                (
                    other.NumberFormat.NumberDecimalSeparator,
                    other.NumberFormat.NumberGroupSeparator,
                    other.NumberFormat.NegativeSign) = (decimals, groups, minus);
                CultureInfo.CurrentCulture = other;

                Assert.Equal(program, match.Match().Program.ToArray());
                Assert.Equal(report, MatchReportJson.Write(match.Report()));
            }
        }
        finally
        {
            CultureInfo.CurrentCulture = culture;
        }
    }

    [Fact]
    public void Threads_do_not_disturb_each_other()
    {
        var match = Case([12, 34, -5, 6, 21, 8, -9, 10, 11, 12, -13, 14], 1);
        var input = match.Input;
        var programs = new byte[16][];
        Parallel.For(0, programs.Length, i => programs[i] = Matcher.Match(input).Result!.Program.ToArray());

        Assert.All(programs, p => Assert.Equal(programs[0], p));
    }

    private static void Check(Arbitrary<int[]> deviations, Action<int[]> law) =>
        FsCheck.Check.One(Config.QuickThrowOnFailure.WithMaxTest(Depth.Of(30, 100)), Prop.ForAll(deviations, law));

    private static MatchCase Case(int[] micrometers, double scale) =>
        new(Contour) { Theoretical = Points(new int[Places.Length], 1), Part = Points(micrometers, scale), Features = Features };

    private static string Points(int[] micrometers, double scale) => string.Join(
        "; ",
        Places.Select(
            (p, i) => string.Create(
                CultureInfo.InvariantCulture,
                $"{p.Label} {p.X + (p.NormalX * micrometers[i] * scale / 1000):0.000000000} "
                    + $"{p.Y + (p.NormalY * micrometers[i] * scale / 1000):0.000000000}")));

    private static string Reverse(string points) => string.Join("; ", points.Split("; ").Reverse());
}
