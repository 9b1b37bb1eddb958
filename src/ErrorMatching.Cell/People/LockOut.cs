namespace ErrorMatching.Cell;

/// <summary>How long a name is locked after failed sign-ins in a row: not at all, then longer and longer.</summary>
internal static class LockOut
{
    /// <summary>This many failures are free.</summary>
    public const int FreeFailures = 4;

    private static readonly TimeSpan First = TimeSpan.FromSeconds(30);
    private static readonly TimeSpan Longest = TimeSpan.FromHours(1);

    /// <summary>How long the name is locked after the last of so many failures: 30 s after the fifth, then twice as long each, at most 1 h.</summary>
    public static TimeSpan After(int failures) => failures <= FreeFailures ? TimeSpan.Zero : failures - FreeFailures - 1 > 7 ? Longest : Min(First * (1 << (failures - FreeFailures - 1)), Longest);

    /// <summary>Until when the name is locked; null if it is not. A clock that was set back does not make it longer.</summary>
    /// <param name="failures">Failures in a row.</param>
    /// <param name="last">When the last of them was, as the clock said then.</param>
    /// <param name="now">What the clock says now.</param>
    public static DateTimeOffset? Until(int failures, DateTimeOffset last, DateTimeOffset now)
    {
        var length = After(failures);
        var until = (last > now ? now : last) + length;
        return length > TimeSpan.Zero && until > now ? until : null;
    }

    private static TimeSpan Min(TimeSpan a, TimeSpan b) => a < b ? a : b;
}
