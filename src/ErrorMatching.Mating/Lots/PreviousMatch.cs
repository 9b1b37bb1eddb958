using ErrorMatching.Measurement;

namespace ErrorMatching.Mating;

/// <summary>The match whose program cut the measured counterpart: which counterparts it knew, and what its program corrects.</summary>
/// <param name="File">Its report.</param>
/// <param name="Sha256">SHA-256 of the report.</param>
/// <param name="Pieces">The counterparts so far, with the corrections of its program.</param>
public sealed record PreviousMatch(string File, string Sha256, MeasuredLot Pieces)
{
    /// <summary>The corrections by offsets with which its program is cut; null if its job allowed none.</summary>
    public OffsetTotals? Offsets { get; init; }
}
