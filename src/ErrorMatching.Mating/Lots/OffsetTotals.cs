using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>The corrections by offsets that a control has, from the reports before.</summary>
/// <param name="RadiusMm">Of the tool's radius, mm.</param>
/// <param name="Work">Of the work offset.</param>
public sealed record OffsetTotals(decimal RadiusMm, OffsetShift Work)
{
    /// <summary>Nothing was corrected yet.</summary>
    public static OffsetTotals None { get; } = new(0, default);
}
