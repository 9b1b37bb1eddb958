namespace ErrorMatching.Measurement;

/// <summary>What happened at a piece of a lot.</summary>
public enum LotEvent
{
    /// <summary>Nothing out of the ordinary.</summary>
    None,

    /// <summary>The process moved before this piece and stays there: a new tool, another clamping.</summary>
    Step,

    /// <summary>Only this piece is off: a chip, or a touch gone wrong.</summary>
    Outlier,
}
