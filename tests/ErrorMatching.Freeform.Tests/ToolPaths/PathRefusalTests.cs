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
        var surface = new PartSurface("late", new(KnotVector.Clamped(2, [0, 0.5, 1]), KnotVector.Clamped(1, [0, 1]), poles), SurfaceRegion.Whole, 1);
        Refused(Plans.Of(surface, Plans.Passes(0.01, 0.01)), "no-normal", "at u 0, v", "(X0.000 Y0.000 Z0.000)", "Repair the surface, or trim it there");
    }

    [Fact]
    public void A_path_of_far_too_many_points_is_given_up_soon() =>
        Refused(Plans.Of(Shapes.Plane(1, 1e8), Plans.Passes(0.001, 0.001)), "path-too-long", "E+9 points", "at most 50000000", "Check the units of the surface");

    // The bottom is narrower than the ball by 0.2 mm: too little to raise it, as gouges of twice the chordal error are allowed, but where the center turns back on itself more is left than the scallop.
    [Fact]
    public void A_tolerance_that_cannot_be_kept_however_close_the_points_are_laid_is_refused() =>
        Refused(Plans.Of(Shapes.Graph((x, _) => 0.1785 * (x - 10) * (x - 10), 20, 4), Plans.Passes(0.01, 0.01)), "tolerance-not-reached", "X11.9", "the scallop is 0.012", "more than 0.01 mm, however close the points are laid", "Allow more");

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

        var surface = new PartSurface("staircase", new(KnotVector.Clamped(2, [.. Enumerable.Range(0, Quarters + 1).Select(k => (double)k)], 2), KnotVector.Clamped(1, [0, 1]), [.. poles], [.. weights]), SurfaceRegion.Whole, -1);
        Refused(Plans.Of(surface, Plans.Passes(0.05, 0.05)), "no-way-out", "the tool cannot go up without touching the surface", "Trim the surface there, or turn the part");
    }

    private static void Refused(ToolPathResult result, string code, params string[] said)
    {
        Assert.Equal(code, result.Refusal?.Code);
        Assert.All(said, s => Assert.Contains(s, result.Refusal!.Message, StringComparison.Ordinal));
    }
}
