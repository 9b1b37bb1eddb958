namespace ErrorMatching.Nc;

/// <summary>How the machine's switches for block skip stand, all levels alike: whether blocks behind a slash are passed over.</summary>
public enum BlockSkip : byte
{
    /// <summary>Nobody has said so: a program that depends on it is refused.</summary>
    Unstated,

    /// <summary>Blocks behind a slash are executed.</summary>
    Off,

    /// <summary>Blocks behind a slash are passed over.</summary>
    On,
}
