namespace ErrorMatching.Nc;

/// <summary>What stays the same over many motions.</summary>
/// <param name="Feed">Feed in mm/min as last programmed.</param>
/// <param name="Frame">Counts the changes of offsets and origins.</param>
internal readonly record struct MotionSetting(double Feed, int Frame)
{
    /// <summary>True if both are the same, to the last bit.</summary>
    public bool SameAs(in MotionSetting other) =>
        Frame == other.Frame && BitConverter.DoubleToInt64Bits(Feed) == BitConverter.DoubleToInt64Bits(other.Feed);
}
