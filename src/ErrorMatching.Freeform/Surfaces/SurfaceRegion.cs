using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The part of a surface's parameters that belongs to the piece: all of it, or the part inside its trimming loops.</summary>
/// <param name="Loops">Closed polygons of (u, v), the last point joined to the first; none for the whole surface. A place belongs to the
/// region if it is inside an odd number of them.</param>
public sealed record SurfaceRegion(IReadOnlyList<IReadOnlyList<Point2>> Loops)
{
    private RegionBands? _bands;

    /// <summary>The whole surface.</summary>
    public static SurfaceRegion Whole { get; } = new([]);

    /// <summary>Closed polygons of (u, v), the last point joined to the first; none for the whole surface. A place belongs to the region
    /// if it is inside an odd number of them.</summary>
    public IReadOnlyList<IReadOnlyList<Point2>> Loops
    {
        get;
        init => (field, _bands) = (value, null);
    }

    = Loops;

    /// <summary>True if the surface is not trimmed.</summary>
    public bool IsWhole => Loops.Count == 0;

    /// <summary>True if the loops are the same.</summary>
    public bool Equals(SurfaceRegion? other) => other is not null && Equals(Loops, other.Loops);

    /// <inheritdoc/>
    public override int GetHashCode() => Loops.GetHashCode();

    /// <summary>True if a place belongs to the region. The first call prepares an index; two threads may both do so, identically.</summary>
    public bool Contains(double u, double v) => IsWhole || (_bands ??= new(Loops)).Contains(u, v);
}
