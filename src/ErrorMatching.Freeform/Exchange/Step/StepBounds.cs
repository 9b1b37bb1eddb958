using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Reads the bounds of a flat face of a STEP file as its edges are, without turning them into polygons.</summary>
/// <param name="item">The face.</param>
/// <param name="origin">A point of its plane, mm.</param>
/// <param name="normal">The unit normal of its plane.</param>
internal sealed class StepBounds(StepItem item, Point3 origin, Vector3 normal)
{
    // An arc that is in a plane at five places is in it, unless it is as small as the distance that is accepted.
    private static readonly double[] Shares = [0, 0.25, 0.5, 0.75, 1];

    private readonly double _scale = item.MillimetersPerUnit;
    private readonly Dictionary<long, int> _passed = [];
    private int _edges;

    /// <summary>Reads all bounds.</summary>
    public IReadOnlyList<IReadOnlyList<FaceEdge>> Read()
    {
        var bounds = item.Instance.Records[0].Instances(1).Select(Bound).Where(b => b.Count > 0).ToList();
        return [
            .. bounds.Select(b => (IReadOnlyList<FaceEdge>)[
                .. b.Select(e => e.Edge with { Number = e.Id, IsInside = _passed.GetValueOrDefault(e.Id) > 1 })])];
    }

    // Each edge with the number of its EDGE_CURVE; 0 if it has none.
    private List<(FaceEdge Edge, long Id)> Bound(StepInstance bound)
    {
        if (bound.Keyword is not ("FACE_BOUND" or "FACE_OUTER_BOUND"))
        {
            throw bound.Records[0].Fail("bad-reference", "FACE_BOUND or FACE_OUTER_BOUND is expected among the bounds of a face");
        }

        var loop = bound.Records[0].Instance(1);
        var record = loop.Records[0];
        switch (loop.Keyword)
        {
            case "EDGE_LOOP":
                var edges = record.Instances(1).SelectMany(Edge).ToList();
                return edges.Count > 0 ? edges : throw record.Fail("bad-loop", "a loop without edges; one at least is expected");
            case "POLY_LOOP":
                var points = StepCurves.Points(record, 1, _scale);
                return points.Length >= 3
                    ? [.. Straight(record, [.. points, points[0]]).Select(e => (e, 0L))]
                    : throw record.Fail("bad-loop", $"a loop of {points.Length} points; three are expected at least");
            case "VERTEX_LOOP":
                return [];
            default:
                throw record.Fail("not-read", "a loop of this kind is not read: EDGE_LOOP, POLY_LOOP and VERTEX_LOOP are");
        }
    }

    private IEnumerable<(FaceEdge Edge, long Id)> Edge(StepInstance oriented)
    {
        var use = StepEdgeUse.Of(oriented, _scale).InSpace();
        _passed[use.Edge.Id] = _passed.GetValueOrDefault(use.Edge.Id) + 1;
        return Edges(use).Select(e => (e, use.Edge.Id));
    }

    private IEnumerable<FaceEdge> Edges(StepEdgeUse use)
    {
        if (++_edges > ExchangeLimits.MaxCurves)
        {
            throw item.Instance.Records[0].Fail("too-large", $"more than {ExchangeLimits.MaxCurves} curves limit one face");
        }

        var record = use.Curve.Records[0];
        switch (use.Curve.Keyword)
        {
            case "LINE":
                CheckLine(use, record);
                return Straight(record, use.IsBackward ? [use.To, use.From] : [use.From, use.To]);
            case "CIRCLE" or "ELLIPSE":
                return [Round(use, record)];
        }

        var curve = StepCurves.Between(use.Curve, use.From, use.To, _scale);
        CheckEnd(use, record, curve.PointAt(curve.Knots.Start), use.From);
        CheckEnd(use, record, curve.PointAt(curve.Knots.End), use.To);
        foreach (var pole in curve.Poles)
        {
            CheckPlane(record, pole);
        }

        curve = use.IsBackward ? curve.Reverse() : curve;
        return use.Curve.Keyword == "POLYLINE"
            ? Straight(record, curve.Poles.ToArray())
            : [new SplineEdge(Entity(use.Curve), record.Line, curve)];
    }

    private IEnumerable<FaceEdge> Straight(StepRecord record, Point3[] points)
    {
        foreach (var point in points)
        {
            CheckPlane(record, point);
        }

        return points.Zip(points.Skip(1), (a, b) => new StraightEdge(record.ToString(), record.Line, a, b));
    }

    // A rational spline has many types, of which one says what it is.
    private static string Entity(StepInstance curve) => (curve.Find("B_SPLINE_CURVE") ?? curve.Records[0]).ToString();

    private RoundEdge Round(StepEdgeUse use, StepRecord record)
    {
        var isCircle = record.Keyword == "CIRCLE";
        StepArc arc;
        try
        {
            arc = StepArc.Of(record, record.Real(2), record.Real(isCircle ? 2 : 3), use.From, use.To, _scale);
        }
        catch (GeometryException e)
        {
            throw record.Fail("bad-curve", e.Message);
        }

        CheckEnd(use, record, arc.At(arc.Start), use.From);
        CheckEnd(use, record, arc.At(arc.Start + arc.Sweep), use.To);
        foreach (var share in Shares)
        {
            CheckPlane(record, arc.At(arc.Start + (share * arc.Sweep)));
        }

        return new(
            record.ToString(),
            record.Line,
            new(arc.Center.X, arc.Center.Y, arc.Center.Z),
            arc.X,
            arc.Y,
            use.IsBackward ? arc.Start + arc.Sweep : arc.Start,
            use.IsBackward ? -arc.Sweep : arc.Sweep)
        {
            IsCircular = isCircle,
        };
    }

    // The ends of a straight edge would say enough. That they are on their line shows that the file means what it says.
    private void CheckLine(StepEdgeUse use, StepRecord line)
    {
        var at = line.Coordinates(line.At(1), 1, "CARTESIAN_POINT") * _scale;
        var vector = line.Record(2, "VECTOR");
        Vector3 along;
        try
        {
            along = vector.Coordinates(vector.At(1), 1, "DIRECTION").Normalize();
        }
        catch (GeometryException)
        {
            throw vector.Fail("bad-value", "a direction of length zero");
        }

        foreach (var end in new[] { use.From, use.To })
        {
            var from = new Vector3(end.X, end.Y, end.Z) - at;
            var foot = at + (along * from.Dot(along));
            CheckEnd(use, line, new(foot.X, foot.Y, foot.Z), end);
        }
    }

    private static void CheckEnd(StepEdgeUse use, StepRecord curve, Point3 onCurve, Point3 vertex)
    {
        var off = (onCurve - vertex).Length;
        if (!(off <= RegionTracer.GapMm))
        {
            throw curve.Fail("bad-curve", string.Create(
                CultureInfo.InvariantCulture,
                $"the edge {use.Edge} ends at {PlaceText.Triple(vertex)}, {off:0.###} mm away from this curve; at most "
                    + $"{RegionTracer.GapMm} mm is expected"));
        }
    }

    private void CheckPlane(StepRecord curve, Point3 p)
    {
        var off = Math.Abs((p - origin).Dot(normal));
        if (!(off <= RegionTracer.GapMm))
        {
            throw curve.Fail("limit-off-surface", string.Create(
                CultureInfo.InvariantCulture,
                $"it limits the flat face {item.Instance} and is {off:0.###} mm away from its plane at {PlaceText.Triple(p)}; at most "
                    + $"{RegionTracer.GapMm} mm is expected"));
        }
    }
}
