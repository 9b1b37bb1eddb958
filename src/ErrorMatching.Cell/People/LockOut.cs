namespace ErrorMatching.Cell;

/// <summary>How long a name is locked after consecutive failed sign-ins: at first not at all, then longer and longer.</summary>
internal static class LockOut
{
    /// <summary>Number of failures without a lock.</summary>
    public const int FreeFailures = 4;

    private static readonly TimeSpan First = TimeSpan.FromSeconds(30);
    private static readonly TimeSpan Longest = TimeSpan.FromHours(1);

    /// <summary>How long the name is locked after the given number of failures: 30 s after the fifth, doubled with each further one, at
    /// most 1 h.</summary>
    public static TimeSpan After(int failures) =>
        failures <= FreeFailures
            ? TimeSpan.Zero
            : failures - FreeFailures - 1 > 7
            ? Longest
            : Min(First * (1 << (failures - FreeFailures - 1)), Longest);

    /// <summary>When the lock ends; null if the name is not locked. Setting the clock back does not make the lock longer.</summary>
    /// <param name="failures">Consecutive failures.</param>
    /// <param name="last">Time of the last failure, by the clock at that time.</param>
    /// <param name="now">The current time.</param>
    public static DateTimeOffset? Until(int failures, DateTimeOffset last, DateTimeOffset now)
    {
        var length = After(failures);
        var until = (last > now ? now : last) + length;
        return length > TimeSpan.Zero && until > now ? until : null;
    }

    private static TimeSpan Min(TimeSpan a, TimeSpan b) => a < b ? a : b;
}
