using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads curves of a STEP file as B-splines: LINE, CIRCLE, ELLIPSE, POLYLINE and B-splines, between two of their points.</summary>
internal static class StepCurves
{
    private const int Starts = 16;

    /// <summary>Returns the part of a curve from one point to another, in the curve's own direction, in millimeters.</summary>
    /// <param name="curve">The curve.</param>
    /// <param name="from">Start of the part.</param>
    /// <param name="to">End of the part; equal to the start for a closed curve.</param>
    /// <param name="scale">Millimeters per unit.</param>
    /// <exception cref="InputException">The curve is broken or not supported.</exception>
    public static SplineCurve Between(StepInstance curve, Point3 from, Point3 to, double scale)
    {
        var record = curve.Records[0];
        try
        {
            return curve.Keyword switch
            {
                "LINE" => Polygon([from, to]),
                "CIRCLE" => Arc(record, record.Real(2), record.Real(2), from, to, scale),
                "ELLIPSE" => Arc(record, record.Real(2), record.Real(3), from, to, scale),
                _ => Spline(curve, scale) is { } spline ? Part(spline, from, to) : throw NotRead(record),
            };
        }
        catch (GeometryException e)
        {
            throw record.Fail("bad-curve", e.Message);
        }
    }

    /// <summary>Reads a complete B-spline or polyline; null for any other curve.</summary>
    /// <exception cref="InputException">The curve is broken.</exception>
    public static SplineCurve? Spline(StepInstance curve, double scale)
    {
        if (curve.Find("POLYLINE") is { } polyline)
        {
            return Polygon(Points(polyline, 1, scale));
        }

        var simple = curve.Records is [var only] && only.Keyword is "B_SPLINE_CURVE_WITH_KNOTS" or "BEZIER_CURVE" ? curve.Records[0] : null;
        var shape = simple ?? (curve.Records.Count > 1 ? curve.Find("B_SPLINE_CURVE") : null);
        if (shape is null)
        {
            return null;
        }

        var first = simple is null ? 0 : 1;
        var degree = shape.Int(first, 1, KnotVector.MaxDegree);
        var poles = Points(shape, first + 1, scale);
        var knots = simple is { Keyword: "B_SPLINE_CURVE_WITH_KNOTS" } ? simple : curve.Find("B_SPLINE_CURVE_WITH_KNOTS");
        var own = knots == simple ? 6 : 0;
        try
        {
            var vector = knots is not null ? StepKnots.Of(knots, degree, own, own + 1)
                : curve.Find("BEZIER_CURVE") is not null ? KnotVector.Clamped(degree, [0, 1])
                : throw NotRead(shape);
            return new(vector, poles, curve.Find("RATIONAL_B_SPLINE_CURVE") is { } rational ? rational.Reals(0) : []);
        }
        catch (GeometryException e)
        {
            throw shape.Fail("bad-curve", e.Message);
        }
    }

    /// <summary>Reads the point of a VERTEX_POINT or CARTESIAN_POINT in millimeters.</summary>
    public static Point3 Point(StepRecord owner, int index, double scale)
    {
        var vertex = owner.Record(index, "VERTEX_POINT");
        var p = vertex.Coordinates(vertex.At(1), 1, "CARTESIAN_POINT") * scale;
        return new(p.X, p.Y, p.Z);
    }

    /// <summary>A polyline whose parameter counts the points.</summary>
    public static SplineCurve Polygon(IReadOnlyList<Point3> points) =>
        new(KnotVector.Clamped(1, Enumerable.Range(0, points.Count).Select(i => (double)i).ToArray()), points.ToArray());

    /// <summary>Reads the points of a list of references, in millimeters.</summary>
    public static Point3[] Points(StepRecord record, int index, double scale)
    {
        var list = record.List(index);
        var points = new Point3[list.Count];
        for (var i = 0; i < points.Length; i++)
        {
            var p = record.Coordinates(list[i], index, "CARTESIAN_POINT") * scale;
            points[i] = new(p.X, p.Y, p.Z);
        }

        return points;
    }

    private static InputException NotRead(StepRecord record) => record.Fail(
        "not-read",
        "a curve of this kind is not read: LINE, CIRCLE, ELLIPSE, POLYLINE, B_SPLINE_CURVE_WITH_KNOTS (rational too) and BEZIER_CURVE "
            + "are. Export edges as B-splines");

    private static SplineCurve Arc(StepRecord record, double first, double second, Point3 from, Point3 to, double scale)
    {
        var arc = StepArc.Of(record, first, second, from, to, scale);
        return SplineArc.Of(arc.Center, arc.X, arc.Y, arc.Start, arc.Start + arc.Sweep);
    }

    // Most edges are a whole curve. The others are cut from it at the ends of the edge.
    private static SplineCurve Part(SplineCurve curve, Point3 from, Point3 to)
    {
        var (start, end) = (curve.Knots.Start, curve.Knots.End);
        if ((curve.PointAt(start) - from).Length <= RegionTracer.GapMm && (curve.PointAt(end) - to).Length <= RegionTracer.GapMm)
        {
            return curve;
        }

        var (a, b) = (Closest(curve, from), Closest(curve, to));
        return a < b ? curve.Between(a, b)
            : throw new GeometryException(
                GeometryError.CoincidentPoints, $"the edge ends before it begins on its curve, or passes the place where the curve closes");
    }

    // Takes the nearest of many samples, then bisects: exact enough for the end of an edge.
    private static double Closest(SplineCurve curve, Point3 p)
    {
        var breaks = curve.Knots.Breaks;
        var (best, distance, step) = (breaks[0], double.PositiveInfinity, 0.0);
        for (var i = 1; i < breaks.Count; i++)
        {
            for (var k = 0; k <= Starts; k++)
            {
                var t = breaks[i - 1] + ((breaks[i] - breaks[i - 1]) * k / Starts);
                var d = (curve.PointAt(t) - p).Length;
                if (d < distance)
                {
                    (best, distance, step) = (t, d, (breaks[i] - breaks[i - 1]) / Starts);
                }
            }
        }

        for (; step > 1e-13 * (breaks[^1] - breaks[0]); step /= 2)
        {
            foreach (var t in new[] { Math.Max(breaks[0], best - step), Math.Min(breaks[^1], best + step) })
            {
                var d = (curve.PointAt(t) - p).Length;
                if (d < distance)
                {
                    (best, distance) = (t, d);
                }
            }
        }

        return best;
    }
}
