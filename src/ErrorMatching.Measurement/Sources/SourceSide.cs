namespace ErrorMatching.Measurement;

/// <summary>The source of a measurement.</summary>
public enum SourceSide
{
    /// <summary>The part, which was cut first and is to be matched.</summary>
    Part,

    /// <summary>The counterpart, whose program is rewritten.</summary>
    Counterpart,
}
