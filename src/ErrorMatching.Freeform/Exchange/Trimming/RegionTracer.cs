using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Converts boundary curves of a surface to closed polygons in its parameters, within <see cref="ToleranceMm"/>.</summary>
/// <param name="map">The surface.</param>
/// <param name="fail">Creates an error from a code and a problem.</param>
internal sealed class RegionTracer(SurfaceMap map, Func<string, string, InputException> fail)
{
    /// <summary>Largest distance between the polygon sides and the curves.</summary>
    public const double ToleranceMm = 0.001;

    /// <summary>Largest gap between consecutive curves, and largest distance of curves from the surface, that is accepted as inexact
    /// writing. CAD systems write 0.001 to 0.01 mm.</summary>
    public const double GapMm = 0.05;

    private const int MaxHalvings = 14;

    private readonly List<IReadOnlyList<Point2>> _loops = [];
    private List<Point2> _loop = [];
    private int _curves;
    private int _points;

    public IReadOnlyList<IReadOnlyList<Point2>> Loops => _loops;

    /// <summary>Continues the loop along a curve in space.</summary>
    /// <param name="curve">The curve in millimeters.</param>
    /// <exception cref="InputException">The curve is not on the surface, or does not start where the previous one ended.</exception>
    public void Space(SplineCurve curve) => Trace(curve.Knots.Breaks, straight: false, (t, near) =>
    {
        var p = curve.PointAt(t);
        var foot = map.FootOf(p, near);
        var off = (map.PointAt(foot) - p).Length;
        return off <= GapMm
            ? foot
            : throw fail(
                "limit-off-surface",
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"a curve that limits the surface is {off:0.###} mm away from it at {Place(p)}; at most {GapMm} mm is expected"));
    });

    /// <summary>Continues the loop along a curve in the parameters.</summary>
    /// <param name="curve">The curve; x is u, y is v.</param>
    /// <exception cref="InputException">The curve does not start where the previous one ended.</exception>
    public void Parameters(SplineCurve curve)
    {
        var start = curve.PointAt(curve.Knots.Start);
        var turned = _loop.Count > 0 ? map.Seam.Beside(new(start.X, start.Y), _loop[^1]) - new Point2(start.X, start.Y) : default;
        Trace(curve.Knots.Breaks, straight: curve.Knots.Degree == 1, (t, _) =>
        {
            var p = curve.PointAt(t);
            return new Point2(p.X, p.Y) + turned;
        });
    }

    /// <summary>Closes the loop.</summary>
    /// <exception cref="InputException">The loop is not closed or encloses nothing.</exception>
    public void Close()
    {
        if (_loop.Count > 0)
        {
            Join(_loop[0]);
            if (map.Seam.IsBetween(_loop[0], _loop[^1]))
            {
                throw fail(
                    "bad-loop",
                    $"a limit that goes round the surface, which closes on itself, and passes {Place(map.PointAt(_loop[0]))} again from "
                        + $"the other side; loops that enclose a part of it are expected. Export the part that is cut as a surface of its "
                        + $"own");
            }

            if (_loop.Count > 1 && Near(_loop[^1], _loop[0]))
            {
                _loop.RemoveAt(_loop.Count - 1);
            }
        }

        if (_loop.Count < 3)
        {
            throw fail("bad-loop", $"a loop of {_loop.Count} points, which encloses nothing");
        }

        _loops.Add(_loop);
        _loop = [];
    }

    private void Trace(IReadOnlyList<double> breaks, bool straight, Func<double, Point2?, Point2> place)
    {
        if (++_curves > ExchangeLimits.MaxCurves)
        {
            throw fail("too-large", $"more than {ExchangeLimits.MaxCurves} curves limit one surface");
        }

        Point2? before = _loop.Count > 0 ? _loop[^1] : null;
        var first = place(breaks[0], before);
        Join(first);
        if (_loop.Count == 0 || !Near(_loop[^1], first))
        {
            Add(first);
        }

        for (var i = 1; i < breaks.Count; i++)
        {
            var last = place(breaks[i], first);
            Refine(place, breaks[i - 1], first, breaks[i], last, straight ? MaxHalvings : 0);
            Add(last);
            first = last;
        }
    }

    // TwoThreads a piece until its quarter points are within the tolerance of the chord.
    private void Refine(Func<double, Point2?, Point2> place, double from, Point2 a, double to, Point2 b, int halvings)
    {
        if (halvings >= MaxHalvings)
        {
            return;
        }

        var along = map.PointAt(b) - map.PointAt(a);
        var length = along.Dot(along);
        Point2 middle = default;
        var apart = false;
        for (var k = 1; k <= 3; k++)
        {
            var q = place(from + ((to - from) * k / 4), a);
            middle = k == 2 ? q : middle;
            var off = map.PointAt(q) - map.PointAt(a.Lerp(b, k / 4.0));
            off = length > 0 ? off - (along * (off.Dot(along) / length)) : off;
            apart |= off.Length > ToleranceMm;
        }

        if (apart)
        {
            var half = (from + to) / 2;
            Refine(place, from, a, half, middle, halvings + 1);
            Add(middle);
            Refine(place, half, middle, to, b, halvings + 1);
        }
    }

    private void Join(Point2 next)
    {
        if (_loop.Count > 0 && (map.PointAt(next) - map.PointAt(_loop[^1])).Length is var gap && gap > GapMm)
        {
            throw fail(
                "open-loop",
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"the curves that limit the surface leave a gap of {gap:0.###} mm at {Place(map.PointAt(_loop[^1]))}; a closed loop "
                        + $"is expected"));
        }
    }

    private void Add(Point2 q)
    {
        if (!q.IsFinite)
        {
            throw fail("bad-loop", "a curve that limits the surface has a point that is no finite number");
        }

        if (++_points > ExchangeLimits.MaxLoopPoints)
        {
            throw fail("too-large", $"the limits of the surface take more than {ExchangeLimits.MaxLoopPoints} points");
        }

        _loop.Add(q);
    }

    // True for the same place, on the same side of a seam.
    private bool Near(Point2 a, Point2 b)
    {
        if (a == b)
        {
            return true;
        }

        var (p, q, middle) = (map.PointAt(a), map.PointAt(b), map.PointAt(a.Lerp(b, 0.5)));
        return (q - p).Length <= ToleranceMm
            && (middle - p).Length <= ToleranceMm
            && a.DistanceTo(b) <= 1e-3 * (1 + Math.Abs(a.X) + Math.Abs(a.Y));
    }

    private static string Place(Point3 p) => PlaceText.Triple(p);
}
