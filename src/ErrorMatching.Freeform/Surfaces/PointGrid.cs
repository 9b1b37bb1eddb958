namespace ErrorMatching.Freeform;

/// <summary>Points that lie on curves of a surface: each curve has one j, its points rising i. Curves may have different numbers of points.</summary>
/// <param name="Curves">The curves by rising j; each with its points by rising i.</param>
public sealed record PointGrid(IReadOnlyList<IReadOnlyList<GridPoint>> Curves)
{
    /// <summary>All points, curve by curve.</summary>
    public IEnumerable<GridPoint> Points => Curves.SelectMany(c => c);

    /// <summary>True if every curve has the same numbers i, so that the points have curves in both directions.</summary>
    public bool IsRectangular => Curves.All(c => c.Select(p => p.I).SequenceEqual(Curves[0].Select(p => p.I)));
}
