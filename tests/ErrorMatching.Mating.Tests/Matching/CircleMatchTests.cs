using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Mating.Tests;

/// <summary>Bores and bosses by closed forms.</summary>
public sealed class CircleMatchTests
{
    private const string Head = "%\nO1000\nN10 G21 G90 G17\n", Tail = "N90 M30\n%\n";

    /// <summary>
    /// A bore of diameter 40 about (50, 30), by the center of a tool of 6 mm: in two halves, as one block, and in thirds by R.
    /// </summary>
    private const string TwoThreads = Head + "N20 G0 X50. Y30.\nN40 G1 X67. F300\nN50 G3 X33. I-17. J0.\nN60 X67. I17. J0.\nN70 G1 X50.\n"
        + Tail;

    private const string Whole = Head + "N20 G0 X50. Y30.\nN40 G1 X67. F300\nN50 G3 I-17. J0.\nN70 G1 X50.\n" + Tail;

    private const string Thirds = Head
        + "N20 G0 X50. Y30.\nN40 G1 X67. F300\nN50 G3 X41.5 Y44.722 R17.\nN55 X41.5 Y15.278 R17.\nN60 X67. Y30. R17.\nN70 G1 X50.\n" + Tail;

    /// <summary>The same bore under cutter compensation: the path is its boundary, the way in and out are tangent arcs.</summary>
    private const string Compensated = Head
        + "N20 G0 X50. Y30.\nN30 G1 G41 D1 X60. Y20. F300\nN40 G3 X70. Y30. R10.\nN50 I-20. J0.\nN60 X60. Y40. R10.\nN70 G1 G40 X50. Y30.\n"
        + Tail;

    /// <summary>A boss of diameter 40 about (50, 30), by the center of the tool, clockwise.</summary>
    private const string Boss = Head + "N20 G0 X80. Y30.\nN40 G1 X73. F300\nN50 G2 X27. I-23. J0.\nN60 X73. I23. J0.\nN70 G1 X80.\n" + Tail;

    private static readonly Point2 Center = new(50, 30);

    [Theory]
    [InlineData(TwoThreads, "N50..N60", 0.03, -0.02, 0.05)]
    [InlineData(TwoThreads, "N50..N60", 0, 0, -0.04)]
    [InlineData(Whole, "N50", 0.03, -0.02, 0.05)]
    [InlineData(Whole, "N50", 0, 0.04, 0)]
    [InlineData(Whole, "N50", 0, -0.04, 0.02)]
    [InlineData(Thirds, "N50..N60", 0.02, 0.03, 0.01)]
    [InlineData(Compensated, "N50", 0.03, -0.02, 0.05)]
    [InlineData(Compensated, "N50", 0, 0.04, 0)]
    [InlineData(Boss, "N50..N60", 0.03, -0.02, 0.05)]
    public void All_arcs_follow_the_center_and_the_radius_of_the_part(string program, string blocks, double x, double y, double growth)
    {
        var match = Circle(program, blocks, Around(8), Moved(x, y, growth, 8));
        var (before, after) = (Arcs(match.Match().Before, blocks), Arcs(match.Match().After, blocks));
        for (var i = 0; i < before.Length; i++)
        {
            Assert.InRange(after[i].Center.DistanceTo(Center + new Vector2(x, y)), 0, 0.0012);
            Assert.Equal(before[i].Radius + growth, after[i].Radius, 0.0012);
        }

        Assert.All(match.Report().KeyPoints, p => Assert.InRange(Math.Abs(p.PredictedMm), 0, 0.0012));
        AssertQuantity(match, "centerXMm", 50, 50 + x);
        AssertQuantity(match, "centerYMm", 30, 30 + y);
        AssertQuantity(match, "diameterMm", 40, 40 + (2 * growth));
        AssertQuantity(match, "roundnessMm", 0, 0);
    }

    [Theory]
    [InlineData("least-squares", 0)]
    [InlineData("inscribed", -0.02)]
    [InlineData("circumscribed", 0.02)]
    public void The_method_says_which_circle_of_a_lobed_part_is_met(string method, double growth)
    {
        // Three lobes: every other point 0.02 outside, the others 0.02 inside. Gauss finds neither; the circles inside and around touch
        // three of them.
        var lobed = Label(Enumerable.Range(0, 6).Select(i => At(60 * i, i % 2 == 0 ? 0.02 : -0.02)));
        var match = Circle(TwoThreads, "N50..N60", Around(6), lobed, method);
        Assert.Equal(17 + growth, Arcs(match.Match().After, "N50..N60")[0].Radius, 0.0011);
        AssertQuantity(match, "diameterMm", 40, 40 + (2 * growth));
        AssertQuantity(match, "roundnessMm", 0, 0.04);
        Assert.Equal(method, match.Job.Features[0] is CircleFeature { Method: var read } ? Word(read) : "");
    }

    [Fact]
    public void A_counterpart_that_came_out_too_large_is_cut_smaller()
    {
        // Feedback: the part's bore is as designed, the counterpart's boss is 0.03 too large in radius and 0.01 aside.
        var match = Circle(Boss, "N50..N60", Around(8), Around(8)) with
        {
            Counterpart = Moved(0.01, 0, 0.03, 8),
            Compensation = """{ "from": "counterpart" }"""
        };
        Assert.All(
            Arcs(match.Match().After, "N50..N60"), a => Assert.Equal((49.99, 22.97), (Math.Round(a.Center.X, 3), Math.Round(a.Radius, 3))));
    }

    [Theory]
    [InlineData(
        "least-squares",
        0,
        44,
        88,
        "angle-too-small: B1, N50: its key points cover 88 degrees of the circle; expected at least 90. Measure points further round.")]
    [InlineData(
        "inscribed",
        0,
        90,
        180,
        "angle-too-small: B1, N50: its key points cover 180 degrees of the circle; expected more than 180. Measure points further round.")]
    [InlineData(
        "circumscribed",
        0,
        60,
        120,
        "angle-too-small: B1, N50: its key points cover 120 degrees of the circle; expected more than 180. Measure points further round.")]
    public void Points_over_too_small_an_angle_are_refused(string method, double first, double second, double third, string refusal)
    {
        var places = Label([At(first, 0), At(second, 0), At(third, 0)]);
        Assert.Equal(refusal, Refused(Circle(TwoThreads, "N50..N60", places, places, method)));
    }

    [Theory]
    [InlineData("least-squares", 90)]
    [InlineData("inscribed", 182)]
    [InlineData("circumscribed", 182)]
    public void Points_over_a_little_more_are_enough(string method, double angle)
    {
        var places = Label([At(0, 0), At(angle / 2, 0), At(angle, 0)]);
        Assert.Empty(Circle(TwoThreads, "N50..N60", places, places, method).Outcome.Refusals);
    }

    [Fact]
    public void The_way_in_is_no_piece_of_the_circle()
    {
        Assert.Equal(
            "not-one-circle: B1, N40: it is no arc of the circle that the other blocks cut. Name the arcs of the circle alone, without "
                + "the way in and out.",
            Refused(Circle(TwoThreads, "N40..N60", Around(8), Around(8))));
        Assert.StartsWith(
            "not-one-circle: B1, N50", Refused(Circle(Compensated, "N40..N50", Around(8), Around(8))), StringComparison.Ordinal);
    }

    [Fact]
    public void A_bore_that_would_be_smaller_than_the_tool_is_refused()
    {
        // The tool runs on a circle of radius 0.05; 0.08 less is nothing.
        var tight = Head + "N20 G0 X50. Y30.\nN40 G1 X50.05 F300\nN50 G3 I-0.05 J0.\nN70 G1 X50.\n" + Tail;
        var (theoretical, part) = (
            Label(Enumerable.Range(0, 8).Select(i => At(45 * i, -16.95))), Label(Enumerable.Range(0, 8).Select(i => At(45 * i, -17.03))));
        Assert.Equal(
            "radius-vanishes: B1, N50: its radius would change by -0.080 mm to -0.030 mm, and no circle about its center would be left. "
                + "The tool is too large for this circle, or the points are wrong.",
            Refused(Circle(tight, "N50", theoretical, part)));
    }

    private static string Word(CircleMethod method) =>
        method switch { CircleMethod.Inscribed => "inscribed", CircleMethod.Circumscribed => "circumscribed", _ => "least-squares" };

    private static MatchCase Circle(string program, string blocks, string theoretical, string part, string method = "least-squares") =>
        new(program)
        {
            Theoretical = theoretical,
            Part = part,
            Features = [
            MatchCase.Feature(
                "circle",
                "B1",
                blocks,
                $"[\"1..{theoretical.Count(c => c == ';') + 1}\"]",
                $"\"toleranceMm\": [0, 0], \"method\": \"{method}\"")],
        };

    private static Point2 At(double degrees, double outward) => new Circle2(Center, 20 + outward).At(Angle.FromDegrees(degrees));

    private static string Around(int count) => Label(Enumerable.Range(0, count).Select(i => At(360.0 * i / count, 0)));

    // Where the rays of the old center meet the new circle: there the probe touches.
    private static string Moved(double x, double y, double growth, int count) => Label(Enumerable.Range(0, count).Select(i =>
    {
        var ray = Vector2.FromDirection(Angle.FromDegrees(360.0 * i / count));
        var (shift, across) = (new Vector2(x, y), new Vector2(x, y).Cross(ray));
        return Center + (ray * (shift.Dot(ray) + Math.Sqrt(((20 + growth) * (20 + growth)) - (across * across))));
    }));

    private static string Label(IEnumerable<Point2> places) =>
        string.Join("; ", places.Select((p, i) => string.Create(CultureInfo.InvariantCulture, $"{i + 1} {p.X:R} {p.Y:R}")));

    private static Arc2[] Arcs(Nc.NcPath path, string blocks) =>
        [
            .. Nc.BlockSelector.Select(path.Program, [Nc.BlockSelector.Parse(blocks)]).Result!
                .SelectMany(b => path.MotionsOf(b).ToArray())
                .Select(m => path.Motions[m].Arc)];

    private static string Refused(MatchCase match)
    {
        var refusal = Assert.Single(match.Outcome.Refusals);
        return $"{refusal.Code}: {refusal.Message}";
    }

    private static void AssertQuantity(MatchCase match, string name, double theoretical, double actual)
    {
        var quantity = match.Report().Features[0].Quantities.Single(q => q.Quantity.Name == name).Quantity;
        Assert.Equal(theoretical, quantity.Theoretical, 1e-6);
        Assert.Equal(actual, quantity.Actual, 2e-6);
    }
}
