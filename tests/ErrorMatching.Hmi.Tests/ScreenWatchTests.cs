namespace ErrorMatching.Hmi.Tests;

public sealed class ScreenWatchTests
{
    [Fact]
    public async Task Only_an_answer_that_a_person_waits_for_is_told()
    {
        var clock = new StandingClock();
        var told = new List<TimeSpan>();
        var screen = new SlowScreen(clock);
        var watch = new ScreenWatch(screen, clock, told.Add);
        foreach (var busy in new[] { 0, 50, 51, 400 })
        {
            screen.Busy = TimeSpan.FromMilliseconds(busy);
            await watch.AskAsync(TestContext.Current.CancellationToken);
        }

        Assert.Equal([TimeSpan.FromMilliseconds(51), TimeSpan.FromMilliseconds(400)], told);
    }

    /// <summary>A thread that is busy with something else for a while before it does what it is asked.</summary>
    private sealed class SlowScreen(StandingClock clock) : SynchronizationContext
    {
        public TimeSpan Busy { get; set; }

        public override void Post(SendOrPostCallback d, object? state)
        {
            clock.Now += Busy.Ticks;
            d(state);
        }
    }

    private sealed class StandingClock : TimeProvider
    {
        public long Now { get; set; }

        public override long TimestampFrequency => TimeSpan.TicksPerSecond;

        public override long GetTimestamp() => Now;
    }
}
