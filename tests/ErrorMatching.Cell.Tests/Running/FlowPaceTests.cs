namespace ErrorMatching.Cell.Tests;

public sealed class FlowPaceTests
{
    [Fact]
    public void What_a_stop_may_take_leaves_time_within_10_s_for_the_end_of_the_process()
    {
        var pace = new FlowPace();
        Assert.InRange(pace.Finish + pace.GiveBack + pace.Deaf, TimeSpan.FromSeconds(5), TimeSpan.FromSeconds(8));
        Assert.InRange(pace.Heartbeat, TimeSpan.FromSeconds(1), Heartbeat.Fresh / 5);
    }

    [Fact]
    public void Pauses_double_to_a_minute()
    {
        var pace = new FlowPace();
        Assert.Equal([5, 10, 20, 40, 60, 60], new[] { 0, 1, 2, 3, 4, 1000 }.Select(n => pace.PauseAfter(n).TotalSeconds));
    }
}
