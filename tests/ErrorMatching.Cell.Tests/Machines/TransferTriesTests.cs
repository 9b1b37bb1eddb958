namespace ErrorMatching.Cell.Tests;

public sealed class TransferTriesTests
{
    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Fact]
    public async Task Tries_are_as_many_as_the_settings_say_and_wait_ever_longer()
    {
        var clock = new InstantClock();
        var told = new List<TransferTry>();
        var tries = 0;
        var failure = await Assert.ThrowsAsync<TransportException>(
            async () => await TransferTries.For(Machine(8), clock, told.Add).ExecuteAsync(
            _ => throw new TransportException(TransportError.Away, $"try {++tries}"), Token));
        Assert.Equal("try 8", failure.Message);
        double[] waits = [0.25, 0.5, 1, 2, 4, 8, 10];
        Assert.Equal(waits, clock.Waits.Select(w => w.TotalSeconds));
        Assert.Equal(waits, told.Select(t => t.Wait.TotalSeconds));
        Assert.Equal(Enumerable.Range(1, 7), told.Select(t => t.Number));
        Assert.All(told, t => Assert.Equal(("mill", $"try {t.Number}"), (t.Machine, t.Failure.Message)));
    }

    [Theory]
    [InlineData(TransportError.Away, 3)]
    [InlineData(TransportError.Slow, 3)]
    [InlineData(TransportError.Differs, 3)]
    [InlineData(TransportError.Unknown, 3)]
    [InlineData(TransportError.Login, 1)]
    [InlineData(TransportError.WrongServer, 1)]
    [InlineData(TransportError.Denied, 1)]
    [InlineData(TransportError.Full, 1)]
    [InlineData(TransportError.CannotReplace, 1)]
    [InlineData(TransportError.TooLarge, 1)]
    [InlineData(TransportError.ToolMissing, 1)]
    public async Task Only_what_another_try_may_mend_is_tried_again(TransportError error, int expected)
    {
        var tries = 0;
        await Assert.ThrowsAsync<TransportException>(async () => await TransferTries.For(Machine(3), new InstantClock()).ExecuteAsync(
            _ =>
            {
                tries++;
                throw new TransportException(error, "no");
            },
            Token));
        Assert.Equal(expected, tries);
    }

    [Fact]
    public async Task One_attempt_is_one_try()
    {
        var clock = new InstantClock();
        await Assert.ThrowsAsync<TransportException>(
            async () => await TransferTries.For(Machine(1), clock).ExecuteAsync(
                _ => throw new TransportException(TransportError.Away, "no"), Token));
        Assert.Empty(clock.Waits);
    }

    private static MachineSettings Machine(int attempts) => new()
    {
        Name = "mill",
        Transport = new FolderSettings("none"),
        Dialect = "siemens-840d",
        Slots = [],
        Timeout = TimeSpan.FromSeconds(1),
        Attempts = attempts,
    };

    // Every wait is over at once, and known.
    private sealed class InstantClock : TimeProvider
    {
        public List<TimeSpan> Waits { get; } = [];

        public override ITimer CreateTimer(TimerCallback callback, object? state, TimeSpan dueTime, TimeSpan period)
        {
            if (dueTime > TimeSpan.Zero)
                Waits.Add(dueTime);
            return System.CreateTimer(callback, state, dueTime == Timeout.InfiniteTimeSpan ? dueTime : TimeSpan.Zero, period);
        }
    }
}
