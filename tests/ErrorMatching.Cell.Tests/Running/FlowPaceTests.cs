namespace ErrorMatching.Cell.Tests;

public sealed class FlowPaceTests
{
    [Fact]
    public void Finishing_and_giving_back_take_at_most_10_s()
    {
        // A slot is given back when what had begun did not end, and the runner waits as long again for the others.
        var pace = new FlowPace();
        Assert.Equal(TimeSpan.FromSeconds(10), pace.Finish + pace.GiveBack + pace.GiveBack);
    }

    [Fact]
    public void Pauses_double_up_to_the_longest_and_stay_there()
    {
        var pace = new FlowPace();
        Assert.Equal([5, 10, 20, 40, 60, 60, 60], new[] { 0, 1, 2, 3, 4, 5, int.MaxValue }.Select(f => pace.PauseAfter(f).TotalSeconds));
    }
}
