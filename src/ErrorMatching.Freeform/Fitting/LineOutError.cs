using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The error of a fit if the true surface is unknown. Each inner grid line in both directions is left out, and its points are
/// compared with the surface fitted without it. Leaving out single points reveals little on grids, because the neighbors still define the
/// shape of the line.</summary>
internal static class LineOutError
{
    /// <summary>Maximum number of lines left out in one direction, evenly chosen. More cost time and hardly change the mean.</summary>
    private const int MostLines = 50;

    private const int MostLinesOfMany = 12;

    /// <summary>From this number of points, each line has enough of them for fewer lines to give the mean.</summary>
    private const int ManyPoints = 1000;

    /// <summary>Returns the mean distance in millimeters along the fitted surfaces' normals; NaN if there is no inner line.</summary>
    /// <param name="grid">The points.</param>
    /// <param name="parameters">The same points with parameters, near which the feet are.</param>
    /// <param name="lay">Fits a surface over the parameters 0 to 1 to part of the points.</param>
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
            // The ends of every curve stay, so that no fit extrapolates.
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
