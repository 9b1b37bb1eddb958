using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// How far an end may go: 13 times the largest displacement asked for and two increments, 1.302 mm for 0.1 mm.
/// An end at (1.298, 0.1) from its old place went 1.30185 mm, one at (1.299, 0.1) went 1.30284 mm.
/// </summary>
public sealed class ReachTests
{
    // N20 rises by 0.01 in 1. Displaced by 0.1 and by (0.1 - 0.01 * 1.2985) / sqrt(1.0001) = 0.0870107 mm,
    // the two meet 1.2985 mm behind their corner.
    [Theory]
    [InlineData("X11.298", true)]
    [InlineData("X11.299", false)]
    public void A_corner_of_two_displaced_lines_goes_as_far_as_the_displacement_explains(string corner, bool holds)
    {
        const double Second = 0.0870107;
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nN20 X20. Y0.1\nG0 Z5.\n";
        var after = $"G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 {corner} Y0.1 F100\nN20 X19.999 Y0.187\nG0 Z5.\n";

        Assert.Equal(holds, Verdict.OnElements(Before, after, ("N10", 0.1), ("N20", Second)).Holds);
    }

    // The circle of radius 1 through the corner and the place between the two: its center is half way and 0.75712 mm to the right.
    // The line beside the arc goes far only at one end, so each end has a check of its own.
    [Theory]
    [InlineData("X11.298", true)]
    [InlineData("X11.299", false)]
    public void The_end_of_a_line_that_meets_a_circle_goes_no_further(string corner, bool holds)
    {
        var (x, y) = Center(1.2985);
        var center = new Point2(Math.Round(10 + x, 3), Math.Round(y, 3));
        var before = $"G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\n{Arc("G2", center, new(10, 0), End(center))}\nG0 Z5.\n";
        var now = new Point2(double.Parse(corner[1..], System.Globalization.CultureInfo.InvariantCulture), 0.1);
        var after = $"G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 {corner} Y0.1 F100\n{Arc("G2", center, now, End(center))}\nG0 Z5.\n";

        Assert.Equal(holds, Verdict.OnElements(before, after, ("N10", 0.1)).Holds);
    }

    // The same from its end to its start: the line runs back, and its displacement to the other side is the same place.
    [Theory]
    [InlineData("X11.298", true)]
    [InlineData("X11.299", false)]
    public void The_start_of_a_line_that_meets_a_circle_goes_no_further(string corner, bool holds)
    {
        var (x, y) = Center(1.2985);
        var center = new Point2(Math.Round(10 + x, 3), Math.Round(y, 3));
        var from = End(center);
        var now = new Point2(double.Parse(corner[1..], System.Globalization.CultureInfo.InvariantCulture), 0.1);
        var before = Text($"G90 G17\nG0 X{from.X:0.000} Y{from.Y:0.000} Z0.\nF100\n")
            + $"{Arc("G3", center, from, new(10, 0))}\nN10 G1 X0. Y0.\nG0 Z5.\n";
        var after = Text($"G90 G17\nG0 X{from.X:0.000} Y{from.Y:0.000} Z0.\nF100\n")
            + $"{Arc("G3", center, from, now)}\nN10 G1 X0. Y0.1\nG0 Z5.\n";

        Assert.Equal(holds, Verdict.OnElements(before, after, ("N10", -0.1)).Holds);
    }

    // Below the chord from (0, 0) to (x, 0.1), on the circle of radius 1.
    private static (double X, double Y) Center(double x)
    {
        var half = Math.Sqrt((x * x) + 0.01) / 2;
        var height = Math.Sqrt(1 - (half * half));
        return ((x / 2) + (0.1 / (2 * half) * height), 0.05 - (x / (2 * half) * height));
    }

    private static Point2 End(Point2 center) => new(center.X, Math.Round(center.Y - 1, 3));

    private static string Arc(string code, Point2 center, Point2 from, Point2 to) =>
        Text($"N20 {code} X{to.X:0.000} Y{to.Y:0.000} I{center.X - from.X:0.000} J{center.Y - from.Y:0.000}");

    private static string Text(FormattableString text) => FormattableString.Invariant(text);
}
