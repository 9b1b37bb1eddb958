using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A net of places on a surface, for drawing: the cells between them, and which cells belong to the piece.</summary>
/// <param name="CountU">Number of places along u.</param>
/// <param name="CountV">Number of places along v.</param>
/// <param name="Places">The places in millimeters, v varying fastest.</param>
/// <param name="Outside">Indices of cells outside the piece, ascending; cell (i, j) is i * (<paramref name="CountV"/> - 1) + j.</param>
public sealed record SurfaceNet(int CountU, int CountV, IReadOnlyList<Point3> Places, IReadOnlyList<int> Outside)
{
    private const int CellsU = 24, CellsV = 20;

    /// <summary>The net of a surface.</summary>
    public static SurfaceNet Of(PartSurface surface) => Of(surface, CellsU, CellsV);

    /// <summary>The net of a surface with a number of cells.</summary>
    internal static SurfaceNet Of(PartSurface surface, int cellsU, int cellsV)
    {
        ArgumentNullException.ThrowIfNull(surface);
        return new(
            cellsU + 1,
            cellsV + 1,
            [.. Parameters(surface, cellsU, cellsV).Select(p => surface.Spline.PointAt(p.U, p.V))],
            [
                .. Enumerable.Range(0, cellsU * cellsV).Where(
                    c => !surface.Region.Contains(
                        At(surface.Spline.KnotsU, (c / cellsV) + 0.5, cellsU), At(surface.Spline.KnotsV, (c % cellsV) + 0.5, cellsV)))]);
    }

    /// <summary>Indices of the places whose neighboring cells all belong to the piece, ascending.</summary>
    public IEnumerable<int> Inside()
    {
        var outside = Outside.ToHashSet();
        return Enumerable.Range(0, CountU * CountV).Where(p => Around(p / CountV, p % CountV).All(c => !outside.Contains(c)));

        IEnumerable<int> Around(int i, int j) =>
            from a in new[] { i - 1, i }
            from b in new[] { j - 1, j }
            where a >= 0 && b >= 0 && a < CountU - 1 && b < CountV - 1
            select (a * (CountV - 1)) + b;
    }

    /// <summary>The parameters of the net's places, in order.</summary>
    internal static IEnumerable<(double U, double V)> Parameters(PartSurface surface, int cellsU = CellsU, int cellsV = CellsV) =>
        from i in Enumerable.Range(0, cellsU + 1)
        from j in Enumerable.Range(0, cellsV + 1)
        select (At(surface.Spline.KnotsU, i, cellsU), At(surface.Spline.KnotsV, j, cellsV));

    private static double At(KnotVector knots, double cell, int cells) => knots.Start + ((knots.End - knots.Start) * cell / cells);
}
