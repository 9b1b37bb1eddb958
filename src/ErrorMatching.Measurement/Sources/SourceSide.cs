namespace ErrorMatching.Measurement;

/// <summary>Whose measurement a file is.</summary>
public enum SourceSide
{
    /// <summary>Of the part, which was cut first and is to be matched.</summary>
    Part,

    /// <summary>Of the counterpart, whose program is rewritten.</summary>
    Counterpart,
}
