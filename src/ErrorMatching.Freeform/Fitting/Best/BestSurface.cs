using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Fits a surface through a grid of points by the same method as error fields: sparse polynomials with breaks of the curvature,
/// Gaussian processes for waves, cubic splines as a last resort.</summary>
/// <remarks>A grid over a parallelogram in a coordinate plane, or in its own mean plane, is fitted as a height over it, so that a quadratic
/// height is reproduced exactly. The parameters are then lengths along the sides of the parallelogram. Any other grid is fitted in x, y and
/// z over its mean chord lengths from 0 to 1. Breaks of the curvature are found only along grid lines, with at least two lines on each
/// side. Oblique breaks, and breaks too faint for the noise, are rounded off. Waves need a Gaussian process. Beyond about 300 points it
/// requires a grid of straight lines; otherwise the cubic spline is used.</remarks>
internal static class BestSurface
{
    /// <summary>Returns the surface, with its breaks and its line-out error.</summary>
    /// <param name="grid">At least two curves of at least two points each; curves may have different numbers of points.</param>
    /// <exception cref="InputException"><c>too-few-points</c>; <c>too-many-points</c>; <c>not-finite</c>.</exception>
    /// <exception cref="GeometryException">Neighboring points coincide, so that they do not span a surface.</exception>
    public static FittedSurface Fit(PointGrid grid)
    {
        ArgumentNullException.ThrowIfNull(grid);
        Check(grid);
        var placed = PlacedGrid.Of(grid);
        var models = Array.ConvertAll(placed.Values, v => ModelChoice.Best(v, ModelChoice.FarWorseOnPoints));
        var surface = ModelSurface.Fit(placed, models);
        return new(
            FitMethod.Best,
            surface,
            [.. models.SelectMany(m => m.BreaksU).Select(placed.U.FromUnit).Distinct().Order()],
            [.. models.SelectMany(m => m.BreaksV).Select(placed.V.FromUnit).Distinct().Order()],
            LeaveLineOut(placed, models, surface))
        {
            MissedMm = Missed(models),
            IsThroughPoints = Array.Exists(models, m => m.Kind == FieldModelKind.Interpolant),
        };
    }

    /// <summary>What the smooth models miss, whether a spline through the values replaced them or not.</summary>
    private static double Missed(FieldModel[] models)
    {
        var sum = 0.0;
        foreach (var model in models)
        {
            var missed = model is SplineModel { Missed: > 0 and var left }
                ? left
                : ModelChoice.Misses(model) ? model.Residuals().Average(Math.Abs) : 0;
            sum += missed * missed;
        }

        return Math.Sqrt(sum);
    }

    /// <summary>Mean distance of left-out points along the surface normal.</summary>
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

    /// <summary>Throws for unusable grids, as for <see cref="Fit"/>.</summary>
    internal static void Check(PointGrid grid)
    {
        var count = grid.Curves.Sum(c => (long)c.Count);
        if (grid.Curves.Count < 2 || grid.Curves.Any(c => c.Count < 2))
        {
            throw InputException.At(
                "too-few-points",
                "grid of points",
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"{ReportNumber.Count(grid.Curves.Count, "curve")} with {count} {(count == 1 ? "point" : "points")}; "
                        + $"a surface needs at least two curves of at least two points each"));
        }

        if (count > FieldFit.MostSamples)
        {
            throw InputException.At(
                "too-many-points",
                "grid of points",
                string.Create(CultureInfo.InvariantCulture, $"{count} points; at most {FieldFit.MostSamples} are taken"));
        }

        foreach (var point in grid.Points)
        {
            if (!point.Position.IsFinite)
            {
                throw InputException.At(
                    "not-finite",
                    "grid of points",
                    string.Create(
                        CultureInfo.InvariantCulture, $"the point i = {point.I}, j = {point.J} has a coordinate that is no finite number"));
            }
        }
    }
}
