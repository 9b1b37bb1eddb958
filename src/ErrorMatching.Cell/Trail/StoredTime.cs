namespace ErrorMatching.Cell;

/// <summary>Times in stored form: whole microseconds since 1970-01-01 UTC.</summary>
internal static class StoredTime
{
    /// <summary>The stored form; fractions of a microsecond are dropped.</summary>
    public static long Of(DateTimeOffset time) => (time.UtcTicks - DateTimeOffset.UnixEpoch.Ticks) / TimeSpan.TicksPerMicrosecond;

    /// <summary>The time from its stored form.</summary>
    public static DateTimeOffset From(long microseconds) => DateTimeOffset.UnixEpoch.AddTicks(microseconds * TimeSpan.TicksPerMicrosecond);

    /// <summary>The time as the store returns it.</summary>
    public static DateTimeOffset Rounded(DateTimeOffset time) => From(Of(time));
}
