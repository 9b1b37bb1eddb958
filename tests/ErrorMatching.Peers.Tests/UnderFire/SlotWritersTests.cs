using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>What judges two cells sees what it must see.</summary>
public sealed class SlotWritersTests
{
    [Fact]
    public async Task Two_transfers_into_one_slot_at_once_are_seen_and_no_others()
    {
        using var folder = new TemporaryFolder();
        using var writers = new SlotWriters(folder.Path);
        string Begin(string name) => folder.File(name, "M30");

        File.Move(Begin("OS00.NC.1-aaaaaaaa.emnew"), folder["OS00.NC"]);
        File.Delete(Begin("OS00.NC.2-aaaaaaaa.emnew"));
        Begin("OS01.NC.3-aaaaaaaa.emnew");
        Begin("OS00.NC.4-aaaaaaaa.emnew");
        Begin("OS01.READY");
        await Quiet.WhenAsync(() => writers.Seen == 4, "four transfers seen");
        Assert.Empty(writers.AtOnce);

        Begin("OS01.NC.5-aaaaaaaa.emnew");
        await Quiet.WhenAsync(() => writers.Seen == 5, "five transfers seen");
        Assert.Equal("OS01.NC.3-aaaaaaaa.emnew and OS01.NC.5-aaaaaaaa.emnew", Assert.Single(writers.AtOnce));
    }
}
