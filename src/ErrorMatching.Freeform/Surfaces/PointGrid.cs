using ErrorMatching.Geometry;

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

/// <summary>A point with its indices in a grid.</summary>
/// <param name="I">Index of the point along its curve (along u), from 0 or 1 as in the file.</param>
/// <param name="J">Index of its curve (along v).</param>
/// <param name="Position">The point in millimeters.</param>
public readonly record struct GridPoint(int I, int J, Point3 Position);
