using System.Runtime.Intrinsics;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Rounds centers to the resolution of the program.</summary>
/// <remarks>A point of a polyline may be anywhere along the curve, so a coarse increment need not cause half of it as error across.
/// Several places near the wanted one are rounded, and the one nearest to the curve is selected, preferring the material side.</remarks>
internal sealed class CenterRounding
{
    // Golden section: places that no increment repeats.
    private const double Slide = 0.618;
    private const int Places = 20;

    // A deviation out of the material is weighted more, because it adds to the ridge between two passes.
    private const double OutwardWeight = 1.5;

    private readonly double _scale;
    private readonly double _tipBelow;
    private readonly double _good;

    /// <param name="decimals">Decimals of the program's coordinates.</param>
    /// <param name="tipBelowMm">Distance of the programmed point below the center: the radius, or 0.</param>
    /// <param name="finestMm">The smallest tolerance for rounded places.</param>
    public CenterRounding(int decimals, double tipBelowMm, double finestMm)
    {
        (_scale, _tipBelow) = (Elementary.Pow(10, decimals), tipBelowMm);
        IncrementMm = 1 / _scale;
        _good = finestMm / 5;
    }

    public double IncrementMm { get; }

    /// <summary>The expected rounding error across the curve.</summary>
    public double ReserveMm => Math.Min(_good, 0.87 * IncrementMm);

    public Point3 Nearest(Point3 p) => new(
        Math.Round(p.X * _scale) / _scale,
        Math.Round(p.Y * _scale) / _scale,
        (Math.Round((p.Z - _tipBelow) * _scale) / _scale) + _tipBelow);

    /// <summary>The lowest height of a center in the program that is not below a given one.</summary>
    // A billionth of an increment is the error of the sum, not a height.
    public double Up(double z) => (Math.Ceiling(((z - _tipBelow) * _scale) - 1e-9) / _scale) + _tipBelow;

    /// <summary>Rounds a point, allowing a shift along the curve.</summary>
    /// <param name="p">The exact place.</param>
    /// <param name="along">Unit direction of the curve.</param>
    /// <param name="normal">Unit normal out of the material.</param>
    /// <param name="acrossMm">Distance of the rounded point from the curve.</param>
    public Point3 Along(Point3 p, Vector3 along, Vector3 normal, out double acrossMm)
    {
        var best = Nearest(p);
        acrossMm = Across(best - p, along);
        if (0.87 * IncrementMm <= _good)
        {
            return best;
        }

        // Four places at a time: this is asked at every point of a path.
        var exact = FourVectors.Of(new(p.X, p.Y, p.Z));
        var (direction, outward) = (FourVectors.Of(along), FourVectors.Of(normal));
        var cost = Math.Max(acrossMm, OutwardWeight * (best - p).Dot(normal));
        for (var i = 1; i < Places && cost > _good; i += Vector256<double>.Count)
        {
            var others = Nearest(exact + (direction * (Vector256.Create(-i, i + 1.0, -(i + 2), i + 3) * Slide * IncrementMm)));
            var off = others - exact;
            var forward = off.Dot(direction);
            var across = Vector256.Sqrt(Vector256.Max(Vector256<double>.Zero, off.Dot(off) - (forward * forward)));
            var costs = Vector256.Max(across, off.Dot(outward) * OutwardWeight);
            for (var k = 0; k < Vector256<double>.Count && i + k < Places && cost > _good; k++)
            {
                if (costs[k] < cost)
                {
                    (best, cost, acrossMm) = (new(others.X[k], others.Y[k], others.Z[k]), costs[k], across[k]);
                }
            }
        }

        return best;
    }

    private FourVectors Nearest(in FourVectors p)
    {
        var (scale, below) = (Vector256.Create(_scale), Vector256.Create(_tipBelow));
        return new(
            Vector256.Round(p.X * scale) / scale,
            Vector256.Round(p.Y * scale) / scale,
            (Vector256.Round((p.Z - below) * scale) / scale) + below);
    }

    public static double Across(Vector3 off, Vector3 along)
    {
        var forward = off.Dot(along);
        return Math.Sqrt(Math.Max(0, off.Dot(off) - (forward * forward)));
    }
}
