using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>
/// The error of a way of fitting where the true surface is unknown: each inner line of the grid, in both directions, is left out as a whole and its points are compared with the surface fitted without it.
/// Leaving out single points is blind on grids, where the neighbors of the point still tell its line's shape.
/// </summary>
internal static class LineOutError
{
    /// <summary>Mean distance in millimetres along the fitted surfaces' normals; NaN if no direction has an inner line.</summary>
    /// <param name="grid">The points.</param>
    /// <param name="parameters">The same with parameters, near which the feet lie.</param>
    /// <param name="lay">Lays a surface over the parameters 0 to 1 through a part of the points.</param>
    public static double Mean(PointGrid grid, FitGrid parameters, Func<PointGrid, SplineSurface> lay)
    {
        var (sum, count) = (0.0, 0);
        for (var j = 1; j < grid.Curves.Count - 1; j++)
        {
            var left = j;
            LeaveOut((curve, _) => curve == left, new([.. grid.Curves.Where((_, k) => k != left)]));
        }

        foreach (var number in grid.Points.Select(p => p.I).Distinct().Order())
        {
            // The ends of every curve stay: beyond them no fit is asked for.
            bool IsOut(int curve, int k) => grid.Curves[curve][k].I == number && k > 0 && k < grid.Curves[curve].Count - 1;
            LeaveOut(IsOut, new([.. grid.Curves.Select((c, j) => (IReadOnlyList<GridPoint>)[.. c.Where((_, k) => !IsOut(j, k))])]));
        }

        return count == 0 ? double.NaN : sum / count;

        void LeaveOut(Func<int, int, bool> isOut, PointGrid rest)
        {
            SurfaceDistance? distances = null;
            for (var j = 0; j < grid.Curves.Count; j++)
            {
                for (var k = 0; k < grid.Curves[j].Count; k++)
                {
                    if (isOut(j, k))
                    {
                        distances ??= new(lay(rest));
                        sum += Math.Abs(distances.To(grid.Curves[j][k].Position, parameters.CurveUs[j][k], parameters.Vs[j]));
                        count++;
                    }
                }
            }
        }
    }
}
