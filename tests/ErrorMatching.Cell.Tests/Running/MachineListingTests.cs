namespace ErrorMatching.Cell.Tests;

public sealed class MachineListingTests
{
    [Fact]
    public async Task Slots_that_ask_at_about_the_same_time_share_a_listing_but_never_one_from_before()
    {
        var clock = new ManualClock();
        var machine = new MemoryMachine("m1");
        var listing = new MachineListing(machine, clock, TimeSpan.FromSeconds(1));
        var token = TestContext.Current.CancellationToken;
        machine.Files["OLD.READY"] = [];
        Assert.Equal(["OLD.READY"], await listing.NamesAsync(0, token));
        machine.Files.Clear();
        clock.Advance(TimeSpan.FromMilliseconds(500));
        Assert.Equal(["OLD.READY"], await listing.NamesAsync(0, token));
        Assert.Empty(await listing.NamesAsync(clock.GetTimestamp(), token));
        Assert.Equal(2, machine.Done.Count);
        machine.Files["NEW.READY"] = [];
        Assert.Empty(await listing.NamesAsync(0, token));
        clock.Advance(TimeSpan.FromSeconds(1));
        Assert.Equal(["NEW.READY"], await listing.NamesAsync(0, token));
        Assert.Equal(3, machine.Done.Count);
    }
}
