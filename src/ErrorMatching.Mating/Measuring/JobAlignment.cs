namespace ErrorMatching.Mating;

/// <summary>The alignment that a job requests.</summary>
/// <param name="Kind">How points are moved.</param>
/// <param name="Origin">Label of the datum's origin; null unless the kind is <see cref="JobAlignmentKind.Datum"/>.</param>
/// <param name="Direction">Label of the point that gives the datum's direction; null unless the kind is
/// <see cref="JobAlignmentKind.Datum"/>.</param>
/// <param name="LockX">True if a best fit must not shift along the first axis.</param>
/// <param name="LockY">True if a best fit must not shift along the second axis.</param>
/// <param name="LockRotation">True if a best fit must not rotate.</param>
public sealed record JobAlignment(JobAlignmentKind Kind, string? Origin, string? Direction, bool LockX, bool LockY, bool LockRotation)
{
    /// <summary>No alignment, the default: an alignment can hide the very error to be matched.</summary>
    public static JobAlignment None { get; } = new(JobAlignmentKind.None, null, null, false, false, false);
}

/// <summary>How measured points are moved before they are compared.</summary>
public enum JobAlignmentKind
{
    /// <summary>Not at all; they are already in the part's frame.</summary>
    None,

    /// <summary>One point onto its theoretical position, a second one into its theoretical direction.</summary>
    Datum,

    /// <summary>The rigid least-squares fit of all key points to their theoretical positions.</summary>
    BestFit,
}
