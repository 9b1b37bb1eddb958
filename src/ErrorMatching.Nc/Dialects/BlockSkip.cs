namespace ErrorMatching.Nc;

/// <summary>State of the machine's block skip switches, the same for all levels: whether blocks after a slash are skipped.</summary>
public enum BlockSkip : byte
{
    /// <summary>Not stated: a program that depends on it is refused.</summary>
    Unstated,

    /// <summary>Blocks after a slash are executed.</summary>
    Off,

    /// <summary>Blocks after a slash are skipped.</summary>
    On,
}
