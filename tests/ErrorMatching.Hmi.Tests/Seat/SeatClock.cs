namespace ErrorMatching.Hmi.Tests;

/// <summary>The real clock, which a test can put forward.</summary>
internal sealed class SeatClock : TimeProvider
{
    private long _ahead;
    private long _stood;

    public override long TimestampFrequency => System.TimestampFrequency;

    public override TimeZoneInfo LocalTimeZone => TimeZoneInfo.Utc;

    public void Advance(TimeSpan time) => Interlocked.Add(ref _ahead, time.Ticks);

    /// <summary>Lets no time pass for what is measured by timestamps, but what <see cref="Advance"/> says: what lasts a second lasts until
    /// then, however slow the machine is.</summary>
    public void Stand() => Interlocked.Exchange(ref _stood, System.GetTimestamp());

    public override DateTimeOffset GetUtcNow() => System.GetUtcNow() + TimeSpan.FromTicks(Interlocked.Read(ref _ahead));

    public override long GetTimestamp() =>
        (Interlocked.Read(ref _stood) is var stood && stood != 0 ? stood : System.GetTimestamp())
            + (long)(TimeSpan.FromTicks(Interlocked.Read(ref _ahead)).TotalSeconds * TimestampFrequency);
}
