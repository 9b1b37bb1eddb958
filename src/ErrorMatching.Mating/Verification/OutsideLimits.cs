namespace ErrorMatching.Mating;

/// <summary>Which key points have a mating error with compensation outside of their limits, and which of them only because of it. Predicted
/// errors and measured ones are judged alike.</summary>
public sealed record OutsideLimits
{
    private OutsideLimits(IReadOnlyList<string> points, IReadOnlyList<string> drivenOut) => (Points, DrivenOut) = (points, drivenOut);

    /// <summary>All of them, in the order of cutting.</summary>
    public IReadOnlyList<string> Points { get; }

    /// <summary>Those that are within their limits without compensation:
    /// it drives them out, as beside a corner, where the boundary follows both its sides.</summary>
    public IReadOnlyList<string> DrivenOut { get; }

    /// <summary>Those that are outside without compensation too: it does not bring them within.</summary>
    public IEnumerable<string> Staying => Points.Except(DrivenOut, StringComparer.Ordinal);

    /// <summary>Judges the mating errors of key points.</summary>
    /// <param name="points">For each, in the order of cutting: its label, the limits of its mating error (null for none), and its mating
    /// error along the normal without compensation and with it, mm.</param>
    public static OutsideLimits Of(IEnumerable<(string Label, ToleranceBand? Limits, double WithoutMm, double WithMm)> points)
    {
        var outside = points.Where(p => p.Limits is { } limits && !limits.Contains(p.WithMm)).ToArray();
        return new([.. outside.Select(p => p.Label)], [.. outside.Where(p => p.Limits!.Value.Contains(p.WithoutMm)).Select(p => p.Label)]);
    }
}
