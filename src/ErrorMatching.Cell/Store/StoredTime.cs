namespace ErrorMatching.Cell;

/// <summary>Times as the store keeps them: whole microseconds since 1970-01-01 UTC.</summary>
internal static class StoredTime
{
    /// <summary>The stored form; what is finer than a microsecond falls away.</summary>
    public static long Of(DateTimeOffset time) => (time.UtcTicks - DateTimeOffset.UnixEpoch.Ticks) / TimeSpan.TicksPerMicrosecond;

    /// <summary>The time of a stored form.</summary>
    public static DateTimeOffset From(long microseconds) => DateTimeOffset.UnixEpoch.AddTicks(microseconds * TimeSpan.TicksPerMicrosecond);

    /// <summary>The time as it comes back from the store.</summary>
    public static DateTimeOffset Rounded(DateTimeOffset time) => From(Of(time));
}
