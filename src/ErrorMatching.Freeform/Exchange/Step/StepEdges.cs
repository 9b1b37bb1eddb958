using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Writes the edges that bound a surface.</summary>
/// <param name="lines">The file.</param>
/// <param name="surface">The surface.</param>
/// <param name="reference">Reference to the surface in the file.</param>
internal sealed class StepEdges(StepLines lines, SplineSurface surface, string reference)
{
    private string? _plane;

    /// <summary>Writes the loop of the four edges of the whole surface, each with its line in the parameters.</summary>
    public string Border()
    {
        var (u0, u1, v0, v1) = (surface.KnotsU.Start, surface.KnotsU.End, surface.KnotsV.Start, surface.KnotsV.End);
        Point2[] corners = [new(u0, v0), new(u1, v0), new(u1, v1), new(u0, v1)];
        var vertices = corners.Select(Vertex).ToArray();
        SplineCurve[] sides = [surface.CurveAtV(v0), surface.CurveAtU(u1), surface.CurveAtV(v1), surface.CurveAtU(u0)];
        List<string> edges = [];
        for (var side = 0; side < sides.Length; side++)
        {
            // Each curve follows its parameter. The last two sides traverse it backward.
            var forward = side < 2;
            var (from, to) = forward ? (side, (side + 1) % 4) : ((side + 1) % 4, side);
            var curve = lines.Curve(sides[side].Knots, sides[side].Poles.ToArray().Select(lines.Point), sides[side].Weights);
            edges.Add(Edge(
                vertices[from],
                vertices[to],
                curve,
                [corners[from], corners[to]],
                [sides[side].Knots.Start, sides[side].Knots.End],
                forward));
        }

        return lines.Add($"EDGE_LOOP('',({string.Join(',', edges)}))");
    }

    /// <summary>Writes a loop with one edge for each side of a polygon in the parameters.</summary>
    public string Polygon(IReadOnlyList<Point2> loop)
    {
        var vertices = loop.Select(Vertex).ToArray();
        List<string> edges = [];
        for (var i = 0; i < loop.Count; i++)
        {
            var next = (i + 1) % loop.Count;
            var side = LoopOnSurface.Side(surface, loop[i], loop[next]);
            var numbers = Enumerable.Range(0, side.Count).Select(n => (double)n).ToArray();
            var curve = lines.Curve(KnotVector.Clamped(1, numbers), side.Select(p => lines.Point(surface.PointAt(p.X, p.Y))).ToList(), []);
            edges.Add(Edge(vertices[i], vertices[next], curve, side, numbers, forward: true));
        }

        return lines.Add($"EDGE_LOOP('',({string.Join(',', edges)}))");
    }

    private string Edge(string from, string to, string curve, IEnumerable<Point2> parameters, double[] knots, bool forward)
    {
        _plane ??= lines.Add("(GEOMETRIC_REPRESENTATION_CONTEXT(2)PARAMETRIC_REPRESENTATION_CONTEXT()REPRESENTATION_CONTEXT('',''))");
        var flat = lines.Curve(KnotVector.Clamped(1, knots), parameters.Select(lines.Point).ToList(), []);
        var onSurface = lines.Add($"PCURVE('',{reference},{lines.Add($"DEFINITIONAL_REPRESENTATION('',({flat}),{_plane})")})");
        var both = lines.Add($"SURFACE_CURVE('',{curve},({onSurface}),.PCURVE_S1.)");
        var edge = lines.Add($"EDGE_CURVE('',{from},{to},{both},.T.)");
        return lines.Add($"ORIENTED_EDGE('',*,*,{edge},{(forward ? ".T." : ".F.")})");
    }

    private string Vertex(Point2 p) => lines.Add($"VERTEX_POINT('',{lines.Point(surface.PointAt(p.X, p.Y))})");
}
