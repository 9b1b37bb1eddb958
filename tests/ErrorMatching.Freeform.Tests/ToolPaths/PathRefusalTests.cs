using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Paths that no tool could follow, and none that is what the job asks for.</summary>
public sealed class PathRefusalTests
{
    [Fact]
    public void A_place_without_a_normal_is_refused()
    {
        // Three rows of poles are one: up to u = 0.5 the surface stays on a line.
        Point3[] poles = [new(0, 0, 0), new(0, 8, 0), new(0, 0, 0), new(0, 8, 0), new(0, 0, 0), new(0, 8, 0), new(10, 0, 0), new(10, 8, 0)];
        var surface = new PartSurface(
            "late", new(KnotVector.Clamped(2, [0, 0.5, 1]), KnotVector.Clamped(1, [0, 1]), poles), SurfaceRegion.Whole, 1);
        Refused(
            Plans.Of(surface, Plans.Passes(0.01, 0.01)), "no-normal", "at u 0, v", "(X0 Y0 Z0)", "Repair the surface, or trim it there");
    }

    [Fact]
    public void A_path_of_far_too_many_points_is_given_up_soon() =>
        Refused(
            Plans.Of(Shapes.Plane(1, 1e8), Plans.Passes(0.001, 0.001)),
            "path-too-long",
            "E+9 points",
            "at most 50000000",
            "Check the units of the surface");

    // The bottom is narrower than the ball by 0.2 mm: too little to raise it, as gouges of twice the chordal error are allowed, but where
    // the center turns back on itself more is left than the scallop.
    [Fact]
    public void A_tolerance_that_cannot_be_kept_however_close_the_points_are_laid_is_refused() =>
        Refused(
            Plans.Of(Shapes.Graph((x, _) => 0.1785 * (x - 10) * (x - 10), 20, 4), Plans.Passes(0.01, 0.01)),
            "tolerance-not-reached",
            "X11.9",
            "the scallop is 0.012",
            "more than 0.01 mm, however close the points are laid",
            "Allow more");

    // One and a half turns of a spiral staircase: every place points up, but over the lower end is the upper floor.
    [Fact]
    public void A_place_with_the_surface_over_it_is_refused()
    {
        const int Quarters = 6;
        var (poles, weights) = (new List<Point3>(), new List<double>());
        for (var i = 0; i <= 2 * Quarters; i++)
        {
            var (angle, stretch) = (Math.PI / 4 * i, i % 2 == 1 ? Math.Sqrt(2) : 1);
            foreach (var radius in new[] { 12.0, 20 })
            {
                poles.Add(new(radius * stretch * Math.Cos(angle), radius * stretch * Math.Sin(angle), 2.5 * i));
                weights.Add(1 / stretch);
            }
        }

        var surface = new PartSurface(
            "staircase",
            new(
                KnotVector.Clamped(2, [.. Enumerable.Range(0, Quarters + 1).Select(k => (double)k)], 2),
                KnotVector.Clamped(1, [0, 1]),
                [.. poles],
                [.. weights]),
            SurfaceRegion.Whole,
            -1);
        Refused(
            Plans.Of(surface, Plans.Passes(0.05, 0.05)),
            "no-way-out",
            "the tool cannot go up without touching the surface",
            "Trim the surface there, or turn the part");
    }

    [Theory]
    [InlineData(0.2, 0.1, "chordMm is 0.1 mm", "0.2 mm of stock")]
    [InlineData(0.1, 0.06, "chordMm is 0.06 mm", "0.1 mm of stock")]
    public void A_chord_that_could_take_all_of_the_stock_is_refused(double stock, double chord, params string[] said) =>
        Refused(Plans.Of(Shapes.Plane(10, 10), Plans.Passes(0.1, chord), stock: stock), "chord-too-coarse", said);

    // A cylinder that falls to both sides: all chords lie inside, by more than the ridges are high.
    [Fact]
    public void Ridges_that_lie_below_the_surface_have_no_negative_height_and_are_not_said_to_be_no_gouge()
    {
        var certificate = Plans.Path(Shapes.Graph((x, _) => -0.01 * (x - 20) * (x - 20), 40, 2), Plans.Passes(0.001, 0.09)).Certificate;
        Assert.InRange(certificate.ChordMm, 0.02, 0.09);
        Assert.InRange(certificate.ScallopMm, 0, 0.001);
        Assert.False(certificate.HasNoGouge);
        Assert.True(Plans.Path(Shapes.Plane(10, 10), Plans.Passes(0.1, 0.01)).Certificate.HasNoGouge);
    }

    private static void Refused(ToolPathResult result, string code, params string[] said)
    {
        Assert.Equal(code, result.Refusal?.Code);
        Assert.All(said, s => Assert.Contains(s, result.Refusal!.Message, StringComparison.Ordinal));
    }
}
