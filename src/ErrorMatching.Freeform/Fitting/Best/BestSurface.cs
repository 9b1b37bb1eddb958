using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Lays a surface through a grid of points that is known by nothing else, by the rule that fits error fields: polynomials of few terms with breaks of the curvature, Gaussian processes for waves, cubic splines as last resort.</summary>
/// <remarks>
/// A grid over a parallelogram of a coordinate plane, or of its own mean plane, is fitted as height over it, so that a quadratic height is met exactly; the parameters are then lengths along the sides of the parallelogram. Any other grid is fitted
/// in x, y and z over its mean chord lengths from 0 to 1.
/// A break of the curvature is found only along grid lines, with two lines at least on each side. One that runs obliquely to the grid is rounded off; so is a break too faint for the noise.
/// Waves take a Gaussian process; beyond some 300 points it needs a grid of straight lines, else the cubic spline stands in for it.
/// </remarks>
public static class BestSurface
{
    /// <summary>The surface, with its breaks and its error when whole grid lines are left out.</summary>
    /// <param name="grid">At least two curves of at least two points each; curves may have different numbers of points.</param>
    /// <exception cref="FreeformException"><c>too-few-points</c>; <c>too-many-points</c>; <c>not-finite</c>.</exception>
    /// <exception cref="GeometryException">Neighboring points coincide, so that they span no surface.</exception>
    public static FittedSurface Fit(PointGrid grid)
    {
        ArgumentNullException.ThrowIfNull(grid);
        Check(grid);
        var placed = PlacedGrid.Of(grid);
        var models = Array.ConvertAll(placed.Values, ModelChoice.Best);
        var surface = ModelSurface.Of(placed, models);
        return new(
            FitMethod.Best,
            surface,
            [.. models.SelectMany(m => m.BreaksU).Select(placed.U.FromUnit).Distinct().Order()],
            [.. models.SelectMany(m => m.BreaksV).Select(placed.V.FromUnit).Distinct().Order()],
            LeaveLineOut(placed, models, surface));
    }

    /// <summary>Mean distance of left-out points along the surface's normal.</summary>
    private static double LeaveLineOut(PlacedGrid placed, FieldModel[] models, SplineSurface surface)
    {
        var (sum, count) = (0.0, 0);
        var differences = Array.ConvertAll(models, m => m.LeaveLinesOut());
        for (var k = 0; k < differences[0].Count; k++)
        {
            var number = differences[0][k].Number;
            var missed = Vector3.Zero;
            for (var c = 0; c < models.Length; c++)
            {
                missed += placed.Directions[c] * differences[c][k].Difference;
            }

            var data = models[0].Data;
            sum += Math.Abs(missed.Dot(surface.At(placed.U.FromUnit(data.U[number]), placed.V.FromUnit(data.V[number])).Normal));
            count++;
        }

        return count > 0 ? sum / count : double.NaN;
    }

    /// <summary>Refuses a grid that no surface is laid through, as of <see cref="Fit"/>.</summary>
    internal static void Check(PointGrid grid)
    {
        var count = grid.Curves.Sum(c => (long)c.Count);
        if (grid.Curves.Count < 2 || grid.Curves.Any(c => c.Count < 2))
        {
            throw new FreeformException("too-few-points", "grid of points", string.Create(CultureInfo.InvariantCulture, $"{grid.Curves.Count} curves with {count} points; a surface needs at least two curves of at least two points each"));
        }

        if (count > FieldFit.MostSamples)
        {
            throw new FreeformException("too-many-points", "grid of points", string.Create(CultureInfo.InvariantCulture, $"{count} points; at most {FieldFit.MostSamples} are taken"));
        }

        foreach (var point in grid.Points)
        {
            if (!point.Position.IsFinite)
            {
                throw new FreeformException("not-finite", "grid of points", string.Create(CultureInfo.InvariantCulture, $"the point i = {point.I}, j = {point.J} has a coordinate that is no finite number"));
            }
        }
    }
}
