namespace ErrorMatching.Mating;

/// <summary>How measured points are moved before they are compared.</summary>
public enum JobAlignmentKind
{
    /// <summary>Not at all: they are in the part's frame already.</summary>
    None,

    /// <summary>A point onto its theoretical place, a second one into its theoretical direction.</summary>
    Datum,

    /// <summary>The rigid least-squares fit of all key points to their theoretical places.</summary>
    BestFit,
}
