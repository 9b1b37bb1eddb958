using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>The key points whose mating error with compensation is outside its limits, including those that only the compensation drives
/// out. Predicted and measured errors are judged alike.</summary>
public sealed record OutsideLimits
{
    private OutsideLimits(IReadOnlyList<string> points, IReadOnlyList<string> drivenOut) => (Points, DrivenOut) = (points, drivenOut);

    /// <summary>All of them, in the order of cutting.</summary>
    public IReadOnlyList<string> Points { get; }

    /// <summary>Points within their limits without compensation. The compensation drives them out, for example beside a corner, where the
    /// boundary follows both sides.</summary>
    public IReadOnlyList<string> DrivenOut { get; }

    /// <summary>Points that are also outside without compensation; it does not bring them within.</summary>
    public IEnumerable<string> Staying => Points.Except(DrivenOut, StringComparer.Ordinal);

    /// <summary>Judges the mating errors of key points.</summary>
    /// <param name="points">The points, in the order of cutting.</param>
    public static OutsideLimits Of(IEnumerable<LimitedPoint> points)
    {
        var outside = points.Where(p => p.Limits is { WidthMm: > 0 } limits && !limits.Contains(p.WithMm)).ToArray();
        return new([.. outside.Select(p => p.Label)], [.. outside.Where(p => p.Limits!.Contains(p.WithoutMm)).Select(p => p.Label)]);
    }
}

/// <summary>A key point whose mating error has limits.</summary>
/// <param name="Label">Its label.</param>
/// <param name="Limits">The limits of its mating error; null, or without width, for none.</param>
/// <param name="WithoutMm">Its mating error along the normal without compensation.</param>
/// <param name="WithMm">The same with compensation.</param>
public sealed record LimitedPoint(string Label, ToleranceBand? Limits, double WithoutMm, double WithMm);
