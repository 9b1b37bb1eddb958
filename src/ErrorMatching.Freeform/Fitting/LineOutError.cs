using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>
/// The error of a way of fitting where the true surface is unknown: each inner line of the grid, in both directions, is left out as a whole and its points are compared with the surface fitted without it.
/// Leaving out single points is blind on grids, where the neighbors of the line still tell its shape.
/// </summary>
internal static class LineOutError
{
    /// <summary>Mean distance in millimetres along the fitted surfaces' normals; NaN if no direction has an inner line.</summary>
    /// <param name="grid">The points.</param>
    /// <param name="lay">Lays a surface through a part of them.</param>
    public static double Mean(PointGrid grid, Func<PointGrid, SplineSurface> lay)
    {
        var (sum, count) = (0.0, 0);
        for (var j = 1; j < grid.Curves.Count - 1; j++)
        {
            Add(grid.Curves[j], new([.. grid.Curves.Where((_, k) => k != j)]));
        }

        var numbers = grid.Points.Select(p => p.I).Distinct().Order().ToArray();
        foreach (var i in numbers)
        {
            // The ends of every curve stay: beyond them no fit is asked for.
            bool IsOut(IReadOnlyList<GridPoint> curve, int k) => curve[k].I == i && k > 0 && k < curve.Count - 1;
            GridPoint[] left = [.. grid.Curves.SelectMany(c => c.Where((_, k) => IsOut(c, k)))];
            if (left.Length > 0)
            {
                Add(left, new([.. grid.Curves.Select(c => (IReadOnlyList<GridPoint>)[.. c.Where((_, k) => !IsOut(c, k))])]));
            }
        }

        return count == 0 ? double.NaN : sum / count;

        void Add(IReadOnlyList<GridPoint> left, PointGrid rest)
        {
            var distances = new SurfaceDistance(lay(rest));
            foreach (var point in left)
            {
                sum += Math.Abs(distances.To(point.Position));
                count++;
            }
        }
    }
}
