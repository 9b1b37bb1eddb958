namespace ErrorMatching.Freeform;

/// <summary>Points on curves of a surface. Each curve has one j, and its points have ascending i. Numbers of points may differ.</summary>
/// <param name="Curves">The curves by ascending j, each with its points by ascending i.</param>
public sealed record PointGrid(IReadOnlyList<IReadOnlyList<GridPoint>> Curves)
{
    /// <summary>All points, curve by curve.</summary>
    public IEnumerable<GridPoint> Points => Curves.SelectMany(c => c);

    /// <summary>True if all curves have the same numbers i, so that the points form curves in both directions.</summary>
    public bool IsRectangular => Curves.All(c => c.Select(p => p.I).SequenceEqual(Curves[0].Select(p => p.I)));
}
