using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Finds places where the curvature or direction of a curve jumps.</summary>
/// <remarks>There are two criteria. At a knot of multiplicity degree - 1 or more, the second derivative may jump, so both sides are
/// compared. A smooth spline fitted across a break (a surface from a grid of points) spreads it over a knot or two: the curvature changes
/// by most of its range within a fiftieth of the curve. Waves of a tenth of the curve or longer do not.</remarks>
internal static class CurvatureBreaks
{
    /// <summary>Number of parts into which a curve is divided.</summary>
    private const int Parts = 500;

    /// <summary>Number of parts within which a jump occurs.</summary>
    private const int Window = 10;

    /// <summary>Minimum jump at a knot as a share of the largest curvature, and minimum spread jump as a share of its range.</summary>
    private const double KnotShare = 0.1, SpreadShare = 0.5;

    /// <summary>Smallest significant jump of curvature (a radius of 100 m against a plane) and of direction (radians).</summary>
    private const double LeastCurvature = 1e-5, LeastAngle = 1e-4;

    /// <summary>Number of lines on which common breaks are searched.</summary>
    private const int Lines = 9;

    /// <summary>Breaks of a curve by ascending parameter; none at its ends.</summary>
    public static IReadOnlyList<double> On(IsoCurve curve)
    {
        var knots = curve.Knots;
        var step = (knots.End - knots.Start) / Parts;
        var bends = new Vector3[Parts + 1];
        var largest = 0.0;
        for (var i = 0; i <= Parts; i++)
        {
            bends[i] = curve.Curvature(curve.At(knots.Start + (i * step)));
            largest = Math.Max(largest, bends[i].Length);
        }

        var found = AtKnots(curve, largest);
        foreach (var t in Spread(bends, knots.Start, step))
        {
            if (!found.Exists(f => Math.Abs(f - t) < 2 * Window * step))
            {
                found.Add(t);
            }
        }

        found.Sort();
        return found;
    }

    /// <summary>Breaks that occur at the same place on at least half of the curves in a direction.</summary>
    public static IReadOnlyList<double> Common(PartSurface surface, bool alongU)
    {
        var across = alongU ? surface.Spline.KnotsV : surface.Spline.KnotsU;
        var along = alongU ? surface.Spline.KnotsU : surface.Spline.KnotsV;
        var all = new List<double>();
        for (var i = 0; i < Lines; i++)
        {
            all.AddRange(On(new(surface, alongU, across.Start + ((i + 0.5) / Lines * (across.End - across.Start)))));
        }

        all.Sort();
        var near = Same(along);
        var common = new List<double>();
        for (var i = 0; i < all.Count;)
        {
            var end = i;
            while (end < all.Count && all[end] - all[i] <= near)
            {
                end++;
            }

            if (2 * (end - i) >= Lines)
            {
                common.Add(all[(i + end - 1) / 2]);
            }

            i = end;
        }

        return common;
    }

    /// <summary>Parameters closer than this are the same break.</summary>
    public static double Same(KnotVector knots) => (knots.End - knots.Start) * Window / Parts;

    private static List<double> AtKnots(IsoCurve curve, double largest)
    {
        var (knots, found) = (curve.Knots, new List<double>());
        var breaks = knots.Breaks;
        for (var i = 1; i < breaks.Count - 1; i++)
        {
            if (knots.Multiplicity(breaks[i]) < knots.Degree - 1)
            {
                continue;
            }

            var aside = 1e-7 * Math.Min(breaks[i] - breaks[i - 1], breaks[i + 1] - breaks[i]);
            var (before, behind) = (curve.At(breaks[i] - aside), curve.At(breaks[i] + aside));
            var jump = (curve.Curvature(behind) - curve.Curvature(before)).Length;
            if (jump > Math.Max(LeastCurvature, KnotShare * largest) || (curve.Tangent(behind) - curve.Tangent(before)).Length > LeastAngle)
            {
                found.Add(breaks[i]);
            }
        }

        return found;
    }

    private static IEnumerable<double> Spread(Vector3[] bends, double start, double step)
    {
        var mean = Vector3.Zero;
        foreach (var bend in bends)
        {
            mean += bend * (1.0 / bends.Length);
        }

        var range = 2 * bends.Max(b => (b - mean).Length);
        var least = Math.Max(LeastCurvature, SpreadShare * range);
        for (var i = 0; i + Window < bends.Length; i++)
        {
            if ((bends[i + Window] - bends[i]).Length <= least)
            {
                continue;
            }

            // The steepest change nearby. Anything within two windows is the same break.
            var (best, steepest) = (i, 0.0);
            for (var k = i; k < Math.Min(i + (2 * Window), bends.Length - 1); k++)
            {
                var change = (bends[k + 1] - bends[k]).Length;
                (best, steepest) = change > steepest ? (k, change) : (best, steepest);
            }

            yield return start + ((best + 0.5) * step);
            i = best + (2 * Window);
        }
    }
}
