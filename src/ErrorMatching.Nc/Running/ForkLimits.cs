namespace ErrorMatching.Nc;

/// <summary>How much a program may be executed to find out whether both ways of its branches lead to the same. Shared by all runs that
/// try a way.</summary>
/// <param name="blocks">Number of blocks in all.</param>
internal sealed class ForkLimits(long blocks)
{
    /// <summary>Most blocks of one way.</summary>
    public const int Way = 2_000;

    /// <summary>Most branches inside ways of branches.</summary>
    public const int Depth = 3;

    private long _left = blocks;

    /// <summary>Counts a block; false if none is left.</summary>
    public bool TryTake() => _left-- > 0;
}
