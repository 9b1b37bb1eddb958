namespace ErrorMatching.Freeform;

/// <summary>The reason for a point of a measuring plan.</summary>
public enum PlanReason
{
    /// <summary>An end of the curve: always measured.</summary>
    End,

    /// <summary>The slope has changed by its share since the previous point.</summary>
    Slope,

    /// <summary>The curvature breaks here.</summary>
    Break,
}
