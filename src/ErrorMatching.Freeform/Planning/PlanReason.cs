namespace ErrorMatching.Freeform;

/// <summary>Why a measuring plan has a point somewhere.</summary>
public enum PlanReason
{
    /// <summary>An end of the curve: always measured.</summary>
    End,

    /// <summary>The slope has turned by its share since the point before.</summary>
    Slope,

    /// <summary>The curvature breaks here.</summary>
    Break,
}
