using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The part of a surface's parameters that belongs to the piece: all of it, or what its trimming leaves.</summary>
/// <param name="Loops">Closed polygons of (u, v), the last point joined to the first; none for the whole surface. A place belongs to the region if it lies inside an odd number of them.</param>
public sealed record SurfaceRegion(IReadOnlyList<IReadOnlyList<Point2>> Loops)
{
    /// <summary>The whole surface.</summary>
    public static SurfaceRegion Whole { get; } = new([]);

    /// <summary>True if nothing is cut away.</summary>
    public bool IsWhole => Loops.Count == 0;

    /// <summary>True if a place belongs to the region.</summary>
    public bool Contains(double u, double v)
    {
        if (IsWhole)
        {
            return true;
        }

        var inside = false;
        foreach (var loop in Loops)
        {
            for (var i = 0; i < loop.Count; i++)
            {
                var (a, b) = (loop[i], loop[(i + 1) % loop.Count]);
                if (a.Y > v != b.Y > v && u < a.X + ((b.X - a.X) * ((v - a.Y) / (b.Y - a.Y))))
                {
                    inside = !inside;
                }
            }
        }

        return inside;
    }
}
