using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Reads the edge loops that bound a face of a STEP file.</summary>
/// <param name="surface">The surface that the edges' parameter curves (PCURVE) refer to.</param>
/// <param name="scale">Millimeters per unit.</param>
/// <param name="map">Its parameter map.</param>
/// <param name="hasParameters">False if the parameters differ from those of the file, so that only curves in space define an edge.</param>
/// <param name="tracer">Receives the loops.</param>
internal sealed class StepLoops(StepInstance surface, double scale, SurfaceMap map, bool hasParameters, RegionTracer tracer)
{
    /// <summary>Follows a bound of the face.</summary>
    /// <param name="bound">FACE_BOUND or FACE_OUTER_BOUND.</param>
    public void Trace(StepInstance bound)
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
                foreach (var edge in record.Instances(1))
                {
                    Edge(edge);
                }

                break;
            case "POLY_LOOP":
                var points = StepCurves.Points(record, 1, scale);
                if (points.Length < 3)
                {
                    throw record.Fail("bad-loop", $"a loop of {points.Length} points; three are expected at least");
                }

                tracer.Space(StepCurves.Polygon([.. points, points[0]]));
                break;
            case "VERTEX_LOOP":
                return; // the degenerate point of a surface, such as the apex of a cone
            default:
                throw record.Fail("not-read", "a loop of this kind is not read: EDGE_LOOP, POLY_LOOP and VERTEX_LOOP are");
        }

        tracer.Close();
    }

    private void Edge(StepInstance oriented)
    {
        var use = StepEdgeUse.Of(oriented, scale);
        if (hasParameters && OfParameters(use.Curve, use.From, use.To) is { } flat)
        {
            tracer.Parameters(use.IsBackward ? flat.Reverse() : flat);
            return;
        }

        use = use.InSpace();
        var space = StepCurves.Between(use.Curve, use.From, use.To, scale);
        tracer.Space(use.IsBackward ? space.Reverse() : space);
    }

    // The parameter curve, if the edge spans all of it. Lines and circles do not define where the edge ends.
    private SplineCurve? OfParameters(StepInstance curve, Point3 from, Point3 to)
    {
        if (curve.Keyword is not ("SURFACE_CURVE" or "INTERSECTION_CURVE"))
        {
            return null;
        }

        foreach (var candidate in curve.Records[0].Instances(2))
        {
            if (candidate.Find("PCURVE") is { } own
                && own.At(1) is { Kind: StepValueKind.Reference } reference
                && (long)reference.Number == surface.Id)
            {
                var items = own.Record(2, "DEFINITIONAL_REPRESENTATION").Instances(1).ToList();
                return items is [var only]
                    && StepCurves.Spline(only, 1) is { } flat
                    && IsAt(flat, flat.Knots.Start, from)
                    && IsAt(flat, flat.Knots.End, to)
                    ? flat
                    : null;
            }
        }

        return null;
    }

    private bool IsAt(SplineCurve flat, double t, Point3 place)
    {
        var q = flat.PointAt(t);
        return (map.PointAt(new(q.X, q.Y)) - place).Length <= RegionTracer.GapMm;
    }
}
