using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>
/// The error of a way of fitting where the true surface is unknown: each inner line of the grid, in both directions, is left out as a whole and its points are compared with the surface fitted without it.
/// Leaving out single points is blind on grids, where the neighbors of the point still tell its line's shape.
/// </summary>
internal static class LineOutError
{
    /// <summary>Lines of one direction that are left out at most, evenly chosen: more hardly change the mean, only the time.</summary>
    private const int MostLines = 50;

    private const int MostLinesOfMany = 12;

    /// <summary>From so many points on, every line holds enough of them for fewer lines to tell the mean.</summary>
    private const int ManyPoints = 1000;

    /// <summary>Mean distance in millimetres along the fitted surfaces' normals; NaN if no direction has an inner line.</summary>
    /// <param name="grid">The points.</param>
    /// <param name="parameters">The same with parameters, near which the feet lie.</param>
    /// <param name="lay">Lays a surface over the parameters 0 to 1 through a part of the points.</param>
    public static double Mean(PointGrid grid, FitGrid parameters, Func<PointGrid, SplineSurface> lay)
    {
        var (sum, count) = (0.0, 0);
        var mostLines = grid.Curves.Sum(c => c.Count) > ManyPoints ? MostLinesOfMany : MostLines;
        foreach (var left in Chosen(Enumerable.Range(1, grid.Curves.Count - 2)))
        {
            LeaveOut((curve, _) => curve == left, new([.. grid.Curves.Where((_, k) => k != left)]));
        }

        foreach (var number in Chosen(grid.Curves.SelectMany(c => c.Skip(1).SkipLast(1)).Select(p => p.I).Distinct().Order()))
        {
            // The ends of every curve stay: beyond them no fit is asked for.
            bool IsOut(int curve, int k) => grid.Curves[curve][k].I == number && k > 0 && k < grid.Curves[curve].Count - 1;
            LeaveOut(IsOut, new([.. grid.Curves.Select((c, j) => (IReadOnlyList<GridPoint>)[.. c.Where((_, k) => !IsOut(j, k))])]));
        }

        return count == 0 ? double.NaN : sum / count;

        IEnumerable<int> Chosen(IEnumerable<int> lines)
        {
            var all = lines.ToArray();
            var most = Math.Min(all.Length, mostLines);
            return Enumerable.Range(0, most).Select(k => all[(int)(((2L * k) + 1) * all.Length / (2 * most))]);
        }

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
