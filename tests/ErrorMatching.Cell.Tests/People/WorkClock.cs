namespace ErrorMatching.Cell.Tests;

/// <summary>A clock whose two hands move when the test says so: time of day, which may be set back, and elapsed time,
/// which may stand still.</summary>
internal sealed class WorkClock : TimeProvider
{
    private long _elapsed;

    public DateTimeOffset Now { get; set; } = new(2026, 3, 1, 6, 0, 0, TimeSpan.Zero);

    public override long TimestampFrequency => TimeSpan.TicksPerSecond;

    public override DateTimeOffset GetUtcNow() => Now;

    public override long GetTimestamp() => _elapsed;

    public void Pass(TimeSpan time)
    {
        Now += time;
        _elapsed += time.Ticks;
    }

    public void Run(TimeSpan time) => _elapsed += time.Ticks;
}
