using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The faces of a STEP file by their edges.</summary>
internal sealed class StepWalls
{
    // Where more faces meet, nothing is known.
    private const int MaxAtEdge = 8;

    private readonly Dictionary<long, List<WallFace>> _byEdge = [];

    /// <summary>Finds the edges of all faces. A face that cannot be read is left out: nobody may want it.</summary>
    /// <param name="items">The surfaces of the file.</param>
    public StepWalls(IEnumerable<StepItem> items)
    {
        foreach (var item in items.Where(i => StepFace.IsFace(i.Instance)))
        {
            try
            {
                var (wall, edges) = (WallOf(item), EdgesOf(item.Instance.Records[0]));
                foreach (var edge in edges)
                {
                    if (!_byEdge.TryGetValue(edge, out var list))
                    {
                        _byEdge[edge] = list = [];
                    }

                    if (list.Count <= MaxAtEdge)
                    {
                        list.Add(wall);
                    }
                }
            }
            catch (Exception e) when (e is InputException or GeometryException)
            {
            }
        }
    }

    /// <summary>The faces at an edge.</summary>
    /// <param name="edge">The number of its EDGE_CURVE.</param>
    public IReadOnlyList<WallFace> At(long edge) =>
        _byEdge.GetValueOrDefault(edge) is { Count: <= MaxAtEdge } faces ? faces : [];

    private static WallFace WallOf(StepItem item)
    {
        var record = item.Instance.Records[0];
        var surface = record.Instance(2);
        var wall = new WallFace(item.Instance.Id, surface.Records.Count == 1 ? surface.Keyword : "B_SPLINE_SURFACE")
        {
            IsOfSolid = item.IsOfSolid,
            IsAlongSurface = record.Flag(3),
        };
        if (surface.Keyword is "PLANE" or "CYLINDRICAL_SURFACE")
        {
            var frame = StepPlacement.Of(surface.Records[0].Instance(1));
            var origin = frame.Origin * item.MillimetersPerUnit;
            return wall with { Axis = frame.Z, Origin = new(origin.X, origin.Y, origin.Z) };
        }

        if (surface.Keyword == "SURFACE_OF_LINEAR_EXTRUSION")
        {
            var vector = surface.Records[0].Record(2, "VECTOR");
            return wall with { Axis = vector.Coordinates(vector.At(1), 1, "DIRECTION").Normalize() };
        }

        return wall;
    }

    private static HashSet<long> EdgesOf(StepRecord face)
    {
        HashSet<long> edges = [];
        foreach (var bound in face.Instances(1))
        {
            var loop = bound.Records[0].Instance(1);
            if (loop.Keyword == "EDGE_LOOP")
            {
                edges.UnionWith(loop.Records[0].Instances(1).Select(
                    o => o.Get("ORIENTED_EDGE").At(3)).Where(e => e.Kind == StepValueKind.Reference).Select(e => (long)e.Number));
            }
        }

        return edges;
    }
}
