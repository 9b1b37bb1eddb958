namespace ErrorMatching.Cell.Tests;

public sealed class LockOutTests
{
    private static readonly DateTimeOffset Now = new(2026, 3, 1, 6, 0, 0, TimeSpan.Zero);

    [Theory]
    [InlineData(0, 0), InlineData(4, 0), InlineData(5, 30), InlineData(6, 60), InlineData(7, 120), InlineData(8, 240), InlineData(9, 480),
        InlineData(10, 960), InlineData(11, 1920), InlineData(12, 3600), InlineData(13, 3600), InlineData(int.MaxValue, 3600)]
    public void It_begins_with_30_s_after_5_failures_and_doubles_up_to_an_hour(int failures, int seconds) =>
        Assert.Equal(TimeSpan.FromSeconds(seconds), LockOut.After(failures));

    [Fact]
    public void It_ends_when_its_time_is_over()
    {
        Assert.Null(LockOut.Until(4, Now, Now));
        Assert.Equal(Now.AddSeconds(30), LockOut.Until(5, Now, Now.AddSeconds(29.9)));
        Assert.Null(LockOut.Until(5, Now, Now.AddSeconds(30)));
    }
}
