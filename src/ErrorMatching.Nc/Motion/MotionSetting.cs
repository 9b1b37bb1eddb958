namespace ErrorMatching.Nc;

/// <summary>Settings that stay the same over many motions.</summary>
/// <param name="Feed">The last programmed feed, mm/min.</param>
/// <param name="Frame">Number of changes of offsets and origins so far.</param>
internal readonly record struct MotionSetting(double Feed, int Frame)
{
    /// <summary>True if both are bitwise equal.</summary>
    public bool SameAs(in MotionSetting other) =>
        Frame == other.Frame && BitConverter.DoubleToInt64Bits(Feed) == BitConverter.DoubleToInt64Bits(other.Feed);
}
