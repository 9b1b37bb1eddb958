namespace ErrorMatching.Mating;

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
