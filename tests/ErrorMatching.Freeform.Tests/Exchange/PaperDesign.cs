using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>The three designs of the second paper as exact one-piece B-splines:
/// 75 x 63 mm, quadratic profiles, x = 75 u, y = 63 v.</summary>
internal static class PaperDesign
{
    /// <summary>Identical quadratics along u, straight along v: z = 30 - 0.004 x^2.</summary>
    public static PartSurface One { get; } = new("SURFACE1", Surface(2, 1, [30, 30, 30, 30, 7.5, 7.5]), SurfaceRegion.Whole, 1);

    /// <summary>Straight along u with varying slope, quadratic along v from convex to concave:
    /// z = 24 + 0.004 (y - 31.5)^2 (2x/75 - 1).</summary>
    public static PartSurface Two { get; } = new(
        "SURFACE2", Surface(1, 2, [20.031, 27.969, 20.031, 27.969, 20.031, 27.969]), SurfaceRegion.Whole, 1);

    /// <summary>Quadratic both ways: z = 24 + 0.004 [(y - 31.5)^2 (2x/75 - 1) + (x - 37.5)^2 (2y/63 - 1)].</summary>
    public static PartSurface Three { get; } = new(
        "SURFACE3", Surface(2, 2, [14.406, 27.969, 25.656, 29.625, 24, 18.375, 22.344, 20.031, 33.594]), SurfaceRegion.Whole, 1);

    /// <summary>The height of a design at a place, by its formula.</summary>
    public static double Height(int number, double x, double y) => number switch
    {
        1 => 30 - (0.004 * x * x),
        2 => 24 + (0.004 * (y - 31.5) * (y - 31.5) * ((2 * x / 75) - 1)),
        _ => 24 + (0.004 * (((y - 31.5) * (y - 31.5) * ((2 * x / 75) - 1)) + ((x - 37.5) * (x - 37.5) * ((2 * y / 63) - 1)))),
    };

    private static SplineSurface Surface(int degreeU, int degreeV, double[] heights)
    {
        var poles = heights.Select((z, n) => new Point3(75.0 * (n / (degreeV + 1)) / degreeU, 63.0 * (n % (degreeV + 1)) / degreeV, z));
        return new(KnotVector.Clamped(degreeU, [0, 1]), KnotVector.Clamped(degreeV, [0, 1]), [.. poles]);
    }
}
