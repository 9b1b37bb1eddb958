using System.Globalization;
using System.Text;
using System.Text.Json.Nodes;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Reporting;
using ErrorMatching.Testing;

namespace ErrorMatching.Mating.Tests;

/// <summary>The pair of a match: signs, frames, blocks and words.</summary>
public sealed class PairMatchTests
{
    private const string Head = "%\nO1000\nN10 G21 G90 G17\n", Tail = "N90 M30\n%\n", Wide = """ "toleranceMm": [-1, 1] """;

    /// <summary>A boss of diameter 40 about (50, 30).</summary>
    private const string Boss = Head + "N20 G0 X80. Y30.\nN40 G1 X73. F300\nN50 G2 X27. I-23. J0.\nN60 X73. I23. J0.\nN70 G1 X80.\n" + Tail;

    /// <summary>A bore of the same size.</summary>
    private const string Bore = Head + "N20 G0 X50. Y30.\nN40 G1 X67. F300\nN50 G3 X33. I-17. J0.\nN60 X67. I17. J0.\nN70 G1 X50.\n" + Tail;

    /// <summary>A slot of 20 mm width and 60 mm length about (0, 0) along x.</summary>
    private const string Slot = Head
        + "N20 G0 X0. Y0.\nN30 G1 Y-7. F300\nN40 X20.\nN50 G3 Y7. I0. J7.\nN60 G1 X-20.\nN70 G3 Y-7. I0. J-7.\nN80 G1 X0.\nN85 Y0.\n"
        + Tail;

    [Theory]
    [InlineData(Boss, 0.03, 0.03)]
    [InlineData(Boss, -0.02, -0.02)]
    [InlineData(Bore, -0.03, 0.03)]
    [InlineData(Bore, 0.02, -0.02)]
    public void A_bore_that_is_larger_than_its_boss_leaves_air(string program, double growth, double air)
    {
        var pair = Circle(program, growth, new(0.01, -0.04)).Match().Pair!;
        Assert.Equal(air > 0, pair.Assembles);
        Assert.Equal(air > 0 ? 1 : 0, pair.Probability);
        Assert.Equal(air, pair.TightestMm!.Value, 1e-4);
        Assert.All(pair.Contacts, c => Assert.Equal(("B1", true), (c.Feature, c.Block is "N50" or "N60")));
        Assert.Equal(72, pair.Gaps.Count);
        Assert.All(pair.Gaps, g => Assert.Equal(air, g.GapMm, 1e-4));
        Assert.Null(pair.Play?.TurnDeg);
        if (air > 0)
        {
            // The part is aside by (0.01, -0.04): a bore over a boss goes back by that much, and by the air.
            AssertRange(-0.01 - air, -0.01 + air, pair.Play!.XMm);
            AssertRange(0.04 - air, 0.04 + air, pair.Play.YMm);
        }
    }

    [Fact]
    public void The_play_is_in_the_part_s_frame()
    {
        // The program is turned by 90 degrees against the part: the part's x is the program's y.
        var turned = Circle(Boss, 0.03, new(0.01, -0.04), toPart: p => new(p.Y, -p.X)) with { Frame = """{ "rotateDeg": 90 }""" };
        var pair = turned.Match().Pair!;
        AssertRange(0.04 - 0.03, 0.04 + 0.03, pair.Play!.XMm);
        AssertRange(0.01 - 0.03, 0.01 + 0.03, pair.Play.YMm);
        Assert.All(pair.Contacts, c => Assert.Equal(20, c.Place.DistanceTo(new(30, -50)), 0.1));
    }

    [Theory]
    [InlineData(0.02, 0.05)]
    [InlineData(0.06, 0.01)]
    public void A_key_is_held_by_its_flanks_and_its_ends(double flank, double end)
    {
        // The part is a key that is narrower by the flank's air, and shorter: its ends leave the flanks' air and the ends'.
        Point2[] places = [
            new(-10, -10), new(10, -10), At(20, -30), At(20, 30), new(10, 10), new(-10, 10), At(-20, 150), At(-20, 210)];
        Point2[] part = [
            .. places.Select((p, i) => i % 4 < 2
                ? p - new Vector2(0, Math.Sign(p.Y) * flank)
                : p - ((p - new Point2(Math.Sign(p.X) * 20, 0)).Normalize() * flank) - new Vector2(Math.Sign(p.X) * end, 0))];
        var pair = new MatchCase(Slot)
        {
            Theoretical = Label(places),
            Part = Label(part),
            Features = [MatchCase.Feature(
                "slot", "S1", "N40..N80", """[["1", "2"], ["3", "4"], ["5", "6"], ["7", "8"]]""", Wide)],
        }.Match().Pair!;
        Assert.True(pair.Assembles);
        Assert.Equal(flank, pair.TightestMm!.Value, 1e-4);
        // The compared places are 2 mm apart, so none is quite at the tip of an end.
        AssertRange(-flank - end, flank + end, pair.Play!.XMm, 5e-4);
        AssertRange(-flank, flank, pair.Play.YMm, 2e-4);
    }

    [Fact]
    public void A_rail_is_free_along_itself_and_says_where_it_overlaps()
    {
        var pair = Rail(-0.03, -0.02, 0.0001).Pair!;
        Assert.False(pair.Assembles);
        Assert.Equal(-0.025, pair.TightestMm!.Value, 1e-3);
        Assert.InRange(pair.Probability, 0, 1e-9);
        Assert.Equal(["N50", "N70"], pair.Contacts.Select(c => c.Block).Distinct().Order(StringComparer.Ordinal));
        Assert.Null(PairWords.Play(pair));

        var loose = Rail(0.03, 0.02, 0.0001).Pair!;
        Assert.Null(loose.Play!.XMm);
        AssertRange(-0.03, 0.02, loose.Play.YMm, 1e-3);
        Assert.Contains("Play: x free, y -0.030 to +0.020 mm, turn ", PairWords.Play(loose), StringComparison.Ordinal);
    }

    [Fact]
    public void A_coarse_gauge_leaves_it_open()
    {
        var pair = Rail(0.004, 0.004, 0.005).Pair!;
        Assert.InRange(pair.Probability, 0.2, 0.9);
        Assert.True(pair.Interval95Mm!.Value.From < 0 && pair.Interval95Mm.Value.To > 0);
        Assert.True(pair.Interval95Mm.Value.From < pair.TightestMm && pair.TightestMm < pair.Interval95Mm.Value.To);
    }

    // A boss and a bore that are round at their points, with 20 um of air. What the job says of their form decides: with waves of 20 um in
    // all directions, a pair goes together in 23 % of cases (600 boundaries, drawn and fitted by another program).
    [Theory]
    [InlineData("", 0.99, 1)]
    [InlineData(""", "formMm": 0.002 """, 0.99, 1)]
    [InlineData(""", "formMm": 0.02 """, 0.18, 0.28)]
    public void A_stated_form_error_takes_the_air(string form, double from, double to)
    {
        var report = Circle(Boss, 0.02, new(0, 0), form: form).Report();
        Assert.InRange(report.Pair!.Probability, from, to);
    }

    [Fact]
    public void One_straight_line_says_nothing() => Assert.Null(new MatchCase(Programs.ToolBelow).Match().Pair);

    [Fact]
    public void A_notch_can_be_lifted_off()
    {
        var pair = new MatchCase(Programs.Notch)
        {
            Theoretical = "1 3 -4; 2 12 -16; 3 18 -16; 4 27 -4",
            Part = "1 3 -4.01; 2 12 -16.01; 3 18 -16.01; 4 27 -4.01",
            Features = [MatchCase.Feature("triangle", "T1", "N50..N60", """[["1", "2"], ["3", "4"]]""", Wide)],
        }.Match().Pair!;
        Assert.Equal((true, 1, null, null), (pair.Assembles, pair.Probability, pair.TightestMm, pair.Interval95Mm));
        Assert.Equal(["N50", "N60"], pair.Contacts.Select(c => c.Block).Distinct().Order(StringComparer.Ordinal));
        Assert.Null(pair.Play!.YMm);
    }

    [Fact]
    public void Words_name_probability_air_and_places()
    {
        var pair = new PairAssembly
        {
            Assembles = true,
            Probability = 0.992,
            TightestMm = 0.012,
            Interval95Mm = new(0.002, 0.022),
            Contacts = [new(default, "L1", "N130")],
        };
        Assert.Equal("It goes together (99.2 %), with 0.012 ± 0.010 mm of air at the tightest place, N130.", PairWords.Of(pair));
        var not = pair with
        {
            Assembles = false,
            Probability = 0.03,
            TightestMm = -0.118,
            Contacts = [new(default, "L1", "N140"), new(default, "L1", "N150"), new(default, "L1", "N150")],
        };
        Assert.Equal("It does not go together (3.0 %): 0.118 ± 0.010 mm overlap at N140 and N150.", PairWords.Of(not));
        Assert.StartsWith(
            "It does not go together (less than 0.1 %): ", PairWords.Of(not with { Probability = 0.0009 }), StringComparison.Ordinal);
        Assert.StartsWith(
            "It goes together: the part can be lifted off. Pressed home, it rests on N50 and N60",
            PairWords.Of(pair with
            {
                Probability = 1,
                TightestMm = null,
                Interval95Mm = null,
                Contacts = [new(default, "T1", "N50"), new(default, "T1", "N60")],
            }),
            StringComparison.Ordinal);
    }

    [Fact]
    public void The_report_has_the_keys_of_the_pair()
    {
        var report = Circle(Boss, 0.03, new(0.01, -0.04)).Report();
        var json = MatchReportJson.Write(report);
        var pair = JsonNode.Parse(json)!["pair"]!;
        Assert.Equal("free", pair["play"]!["turnDeg"]!.GetValue<string>());
        Assert.Equal(2, pair["play"]!["xMm"]!.AsArray().Count);
        Assert.Equal(2, pair["interval95Mm"]!.AsArray().Count);
        Assert.True(pair["assembles"]!.GetValue<bool>());
        Assert.Equal(1, pair["probability"]!.GetValue<double>());
        Assert.Equal("B1", pair["contacts"]![0]!["feature"]!.GetValue<string>());
        Assert.NotNull(pair["contacts"]![0]!["block"]);
        Assert.NotNull(pair["contacts"]![0]!["place"]!["x"]);
        var again = JsonNode.Parse(MatchReportJson.Write(MatchReportJson.Read(ReportReader.Document(json))))!["pair"]!;
        Assert.Equal(pair.ToJsonString(), again.ToJsonString());

        var html = Encoding.UTF8.GetString(MatchReportHtml.Write(report));
        Assert.Contains("<p id=\"pair-verdict\">It goes together (more than 99.9 %), with 0.03", html, StringComparison.Ordinal);
        Assert.Contains("drawing-pair-t", html, StringComparison.Ordinal);
    }

    // An outline that can be lifted off always goes together. The closed ones have no clearance: their parts meet as wide as they are.
    [Theory]
    [InlineData("complex-mating", true)]
    [InlineData("curve-mating", true)]
    [InlineData("circle-mating", false)]
    [InlineData("slot-mating", false)]
    [InlineData("dovetail", false)]
    public void A_sample_has_a_pair(string sample, bool liftsOff)
    {
        var input = Sample(sample);
        var pair = Matcher.Match(input).Result!.Pair!;
        var motions = new PairMotions(
            [.. pair.Gaps.Select(g => g.Place)], [.. pair.Gaps.Select(g => g.Normal)], pair.Gaps.Max(g => Math.Abs(g.GapMm)));
        double[] gaps = [.. pair.Gaps.Select(g => g.GapMm)];
        var factor = new JointFactor(
            0, [.. Enumerable.Range(1, 20).Select(c => gaps.Select((_, k) => 0.002 * Math.Sin(c * k * Math.PI / gaps.Length)).ToArray())]);
        var seat = PairSeat.Find(motions, gaps);
        var ways = liftsOff ? 1 : PairDraws.Draw(motions, gaps, [factor]).Probability;
        var drawing = liftsOff ? 0 : ReadingCost.Seconds(() => PairDraws.Draw(motions, gaps, [factor]));
        var seating = ReadingCost.Seconds(() => PairSeat.Find(motions, gaps));
        TestContext.Current.TestOutputHelper?.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{sample}: {PairWords.Of(pair)} {PairWords.Play(pair)} {gaps.Length} places; of the processor, draws take "
                + $"{1000 * drawing:0.0} ms "
                + $"and the seat {1000 * seating:0.0} ms ({ways:0.000})"));
        Assert.Equal(liftsOff, pair.TightestMm is null);
        Assert.InRange(pair.Contacts.Count, 1, 4);
        Assert.Equal(seat.TightestMm is null, liftsOff);
    }

    private static MatchInput Sample(string sample)
    {
        var job = Samples.Job(sample);
        return new(
            job,
            Points("theoretical.csv"),
            Points("part.csv"),
            null,
            "counterpart.nc",
            File.ReadAllBytes(Repository.PathTo("samples", sample, job.Counterpart.Program)));

        MeasurementFile Points(string file) => MeasurementReader.Read(Repository.PathTo("samples", sample, file), MeasurementFormat.Points);
    }

    // Two lines that face each other, below y = 0 and above y = 20; the tool is between them.
    private static MatchResult Rail(double below, double above, double u, bool atEndsOnly = false)
    {
        var (low, high) = (below.ToString(CultureInfo.InvariantCulture), (20 - above).ToString(CultureInfo.InvariantCulture));
        return new MatchCase(
            Head + "N20 G0 X-10. Y3.\nN40 G1 X0. F300\nN50 X50.\nN60 Y17.\nN70 X0.\nN80 X-10.\n" + Tail)
        {
            Theoretical = "1 5 0; 2 25 0; 3 45 0; 4 45 20; 5 25 20; 6 5 20",
            Part = $"1 5 {low}; 2 25 {low}; 3 45 {low}; 4 45 {high}; 5 25 {high}; 6 5 {high}",
            Features = [
                MatchCase.Feature("line", "L1", "N50", atEndsOnly ? """["1", "3"]""" : """["1", "2", "3"]""", Wide),
                MatchCase.Feature("line", "L2", "N70", atEndsOnly ? """["4", "6"]""" : """["4", "5", "6"]""", Wide)],
            Gauge = string.Create(CultureInfo.InvariantCulture, $""" "uncertaintyMm": {u} """),
        }.Match();
    }

    private static MatchCase Circle(
        string program,
        double growth,
        Vector2 aside,
        Func<Point2, Point2>? toPart = null,
        string form = "",
        string points = """["1", "2", "3", "4", "5", "6", "7", "8"]""")
    {
        toPart ??= p => p;
        var rays = Enumerable.Range(0, 8).Select(i => Vector2.FromDirection(Angle.FromDegrees(45 * i))).ToArray();
        var center = new Point2(50, 30);
        return new(program)
        {
            Theoretical = Label([.. rays.Select(r => toPart(center + (r * 20)))]),
            Part = Label([.. rays.Select(r => toPart(center + (r * (20 + growth + r.Dot(aside)))))]),
            Features = [MatchCase.Feature("circle", "B1", "N50..N60", points, Wide + form)],
        };
    }

    // Four points do not tell whether a boss is round, and two points not whether a side is straight: the percentage is of a perfect form.
    [Theory]
    [InlineData("""["1", "3", "5", "7"]""", "", true)]
    [InlineData("""["1", "3", "5", "7"]""", ", \"formMm\": 0.005", false)]
    [InlineData("""["1", "2", "3", "4", "5", "6", "7", "8"]""", "", false)]
    public void What_nothing_is_known_of_is_a_condition(string points, string form, bool isCondition)
    {
        const string Condition = "It does so only if the form of B1 between the points is good enough: nothing is known of it.";
        var report = Circle(Boss, 0.03, new(0, 0), form: form, points: points).Report();
        Assert.Equal(isCondition ? ["B1"] : [], report.Pair!.UnknownForms);
        Assert.Equal(isCondition, PairWords.Of(report.Pair).EndsWith(Condition, StringComparison.Ordinal));

        Assert.Equal(["L1", "L2"], Rail(0.03, 0.02, 0.0001, atEndsOnly: true).Pair!.UnknownForms);
        Assert.Empty(Rail(0.03, 0.02, 0.0001).Pair!.UnknownForms);

        // It is no condition of an overlap, nor of a part that can be lifted off.
        Assert.DoesNotContain(Condition, PairWords.Of(report.Pair with { Assembles = false }), StringComparison.Ordinal);
        Assert.DoesNotContain(Condition, PairWords.Of(report.Pair with { TightestMm = null }), StringComparison.Ordinal);
    }

    private static Point2 At(double x, double degrees) => new Point2(x, 0) + (Vector2.FromDirection(Angle.FromDegrees(degrees)) * 10);

    private static string Label(IReadOnlyList<Point2> places) =>
        string.Join("; ", places.Select((p, i) => string.Create(CultureInfo.InvariantCulture, $"{i + 1} {p.X:R} {p.Y:R}")));

    private static void AssertRange(double from, double to, PlayRange? range, double near = 1e-4)
    {
        Assert.Equal(from, range!.Value.From, near);
        Assert.Equal(to, range.Value.To, near);
    }
}
