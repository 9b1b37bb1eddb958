using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>An edge of a STEP file as a loop passes it (ORIENTED_EDGE).</summary>
/// <param name="Edge">Its EDGE_CURVE.</param>
/// <param name="Curve">The edge's curve, as the edge refers to it.</param>
/// <param name="From">Where the edge begins in the curve's own direction, mm.</param>
/// <param name="To">Where it ends in that direction, mm.</param>
/// <param name="IsBackward">True if the loop passes it against the curve's direction.</param>
internal sealed record StepEdgeUse(StepRecord Edge, StepInstance Curve, Point3 From, Point3 To, bool IsBackward)
{
    /// <summary>Reads an edge.</summary>
    /// <param name="oriented">The ORIENTED_EDGE.</param>
    /// <param name="scale">Millimeters per unit.</param>
    public static StepEdgeUse Of(StepInstance oriented, double scale)
    {
        var record = oriented.Get("ORIENTED_EDGE");
        var edge = record.Record(3, "EDGE_CURVE");
        var forward = edge.Flag(4);
        var (first, last) = (StepCurves.Point(edge, 1, scale), StepCurves.Point(edge, 2, scale));
        var (from, to) = forward ? (first, last) : (last, first);
        return new(edge, edge.Instance(3), from, to, record.Flag(4) != forward);
    }

    /// <summary>The edge with its curve in space.</summary>
    public StepEdgeUse InSpace()
    {
        var use = this;
        for (var depth = 0; use.Inner() is { } inner; depth++)
        {
            use = depth < ExchangeLimits.MaxDepth ? inner : throw Edge.Fail("too-deep", "curves that refer to one another without end");
        }

        return use;
    }

    // The first attribute of a curve on surfaces is its curve in space. The edge has ends of its own, so that of a trimmed curve only the
    // sense matters.
    private StepEdgeUse? Inner()
    {
        var record = Curve.Records[0];
        return Curve.Keyword switch
        {
            "SURFACE_CURVE" or "SEAM_CURVE" or "INTERSECTION_CURVE" => this with { Curve = record.Instance(1) },
            "TRIMMED_CURVE" when record.Flag(4) => this with { Curve = record.Instance(1) },
            "TRIMMED_CURVE" => this with { Curve = record.Instance(1), From = To, To = From, IsBackward = !IsBackward },
            _ => null,
        };
    }
}
