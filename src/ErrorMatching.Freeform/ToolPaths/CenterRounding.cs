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

    private readonly double _scale;
    private readonly double _tipBelow;
    private readonly double _good;

    /// <param name="decimals">Decimals of the program's coordinates.</param>
    /// <param name="tipBelowMm">Distance of the programmed point below the center: the radius, or 0.</param>
    /// <param name="finestMm">The smallest tolerance for rounded places.</param>
    public CenterRounding(int decimals, double tipBelowMm, double finestMm)
    {
        (_scale, _tipBelow) = (Math.Pow(10, decimals), tipBelowMm);
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

        // Coordinates side by side: this is asked at every point of a path.
        var exact = Vector256.Create(p.X, p.Y, p.Z, 0);
        var direction = Vector256.Create(along.X, along.Y, along.Z, 0);
        var below = Vector256.Create(0, 0, _tipBelow, 0);
        var cost = Cost(best - p, acrossMm, normal);
        for (var i = 1; i < Places && cost > _good; i++)
        {
            var shift = ((i & 1) == 0 ? i : -i) * Slide * IncrementMm;
            var other = (Vector256.Round((exact + (direction * shift) - below) * _scale) / _scale) + below;
            var off = other - exact;
            var offMm = new Vector3(off[0], off[1], off[2]);
            // Most places are worse along the normal, which takes no root.
            if (Outward(offMm, normal) >= cost)
            {
                continue;
            }

            var across = Across(offMm, along);
            var its = Cost(offMm, across, normal);
            if (its < cost)
            {
                (best, cost, acrossMm) = (new(other[0], other[1], other[2]), its, across);
            }
        }

        return best;
    }

    public static double Across(Vector3 off, Vector3 along)
    {
        var forward = off.Dot(along);
        return Math.Sqrt(Math.Max(0, off.Dot(off) - (forward * forward)));
    }

    private static double Cost(Vector3 off, double across, Vector3 normal) => Math.Max(across, Outward(off, normal));

    // A deviation out of the material is weighted more, because it adds to the ridge between two passes.
    private static double Outward(Vector3 off, Vector3 normal) => 1.5 * off.Dot(normal);
}
