using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell.Tests;

/// <summary>No program is replaced or removed while its machine uses it, by any way that leads there.</summary>
public sealed class ReplacementGuardTests
{
    private const string Program = "P100.MPF";
    private static readonly byte[] Old = Encoding.ASCII.GetBytes("G1 X1\nM30\n");
    private static readonly byte[] New = Encoding.ASCII.GetBytes("G1 X2.001 Y3\nM30\n");

    private static readonly MachineState Busy = ToldState.Of(MachineActivity.Running, Program);
    private static readonly MachineState Free = ToldState.Of(MachineActivity.Idle, Program);

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Theory]
    [InlineData(ServerKind.Exchanges)]
    [InlineData(ServerKind.Replaces)]
    [InlineData(ServerKind.Refuses)]
    public async Task A_program_in_use_is_left_alone_and_nothing_else_is_left_there(ServerKind server)
    {
        var folder = Folder(server);
        var failure = await Assert.ThrowsAsync<MachineBusyException>(
            () => Sender(folder, () => Busy).SendAsync(Program, Hash(Old), New, "1", Token));
        Assert.False(failure.IsReplaced);
        Assert.Equal(Old, Assert.Single(folder.Files).Value);
    }

    // The machine starts at each instant of a transfer: before the last look the program stays, after it that is told.
    [Theory]
    [InlineData(ServerKind.Exchanges)]
    [InlineData(ServerKind.Replaces)]
    [InlineData(ServerKind.Refuses)]
    public async Task A_machine_that_starts_during_a_transfer_keeps_its_program_or_that_is_told(ServerKind server)
    {
        var ends = new HashSet<(bool IsNew, bool? IsReplaced)>();
        for (var instant = 1; instant <= 7; instant++)
        {
            var (folder, state) = (Folder(server), Free);
            var end = instant;
            folder.Changed = () => state = folder.Operations >= end ? Busy : state;
            bool? isReplaced = null;
            try
            {
                await Sender(folder, () => state).SendAsync(Program, Hash(Old), New, "1", Token);
            }
            catch (MachineBusyException e)
            {
                isReplaced = e.IsReplaced;
            }

            var isNew = folder.Files[Program].SequenceEqual(New);
            Assert.Equal(isNew, isReplaced != false);
            Assert.Equal([Program], folder.Files.Keys);
            ends.Add((isNew, isReplaced));
        }

        Assert.Superset(new HashSet<(bool, bool?)> { (false, false), (true, true) }, ends);
    }

    // A server that does not rename over a file has no program of this name for a moment. It gets one back, whatever the machine does.
    [Fact]
    public async Task A_free_name_gets_its_program_although_the_machine_is_busy()
    {
        var folder = Folder(ServerKind.Refuses);
        folder.Files.Remove(Program);
        folder.Files[Program + ".emold"] = Old;
        await Sender(folder, () => Busy).RecoverAsync(Program, Token);
        Assert.Equal(Old, Assert.Single(folder.Files).Value);
    }

    [Theory]
    [InlineData(ServerKind.Exchanges)]
    [InlineData(ServerKind.Replaces)]
    [InlineData(ServerKind.Refuses)]
    public async Task A_change_that_a_cut_left_aside_waits_for_the_machine_too(ServerKind server)
    {
        byte[] edited = [.. Old, .. "(edited)"u8];
        var folder = Folder(server);
        folder.Files[Program] = New;
        folder.Files[Program + ".emold"] = edited;
        await Assert.ThrowsAsync<MachineBusyException>(() => Sender(folder, () => Busy).RecoverAsync(Program, Token));
        Assert.Equal((New, edited), (folder.Files[Program], Assert.Single(folder.Files, f => f.Key != Program).Value));
        await Sender(folder, () => Free).RecoverAsync(Program, Token);
        Assert.Equal(edited, Assert.Single(folder.Files).Value);
    }

    [Fact]
    public async Task What_is_not_known_after_a_replacement_is_said()
    {
        var asked = 0;
        var folder = Folder(ServerKind.Exchanges);
        var unseen = await Sender(folder, () => ++asked > 2 ? MachineState.Unknown("gone") : Free)
            .SendAsync(Program, Hash(Old), New, "1", Token);
        Assert.Equal(("gone", 3), (unseen?.Sentence, asked));
        Assert.Null(await Sender(folder, () => Free).SendAsync(Program, Hash(New), Old, "1", Token));
    }

    [Fact]
    public async Task A_shop_whose_programs_call_each_other_can_demand_an_idle_machine()
    {
        var other = ToldState.Of(MachineActivity.Running, "MAIN.MPF");
        Assert.Null(await Guard(new ToldState(() => other)).WhyNotAsync(Program, [], Token));
        var why = await Guard(new ToldState(() => other) { OnlyIdle = true }).WhyNotAsync(Program, [], Token);
        Assert.Matches(@"^machine-busy\(\w+, running, MAIN\.MPF, ", Stated.As(why));
        Assert.Null(await Guard(new ToldState(() => Free) { OnlyIdle = true }).WhyNotAsync(Program, [], Token));
    }

    // The law: over 1,000 random changes with each kind of server, not one replacement while running.
    [Theory]
    [InlineData(ServerKind.Exchanges)]
    [InlineData(ServerKind.Replaces)]
    [InlineData(ServerKind.Refuses)]
    public async Task Over_1000_random_states_no_program_in_use_is_replaced(ServerKind server)
    {
        var control = new SimulatedControl(29 + (int)server, Program);
        var folder = new FaultyFolder(server, new Dictionary<int, Fault>());
        folder.Files[Program] = Old;
        var before = Old;
        folder.Changed = () =>
        {
            var there = folder.Files.GetValueOrDefault(Program);
            var isReplacing = there?.SequenceEqual(before) != true;
            before = there ?? [];
            control.Do(isReplacing && (server != ServerKind.Refuses || there is null));
        };
        var sent = 0;
        while (control.Changes < 1000 || sent < 10)
        {
            var (from, to) = folder.Files[Program].SequenceEqual(Old) ? (Old, New) : (New, Old);
            try
            {
                await Sender(folder, control.Ask).SendAsync(Program, Hash(from), to, "1", Token);
                sent++;
            }
            catch (MachineBusyException e)
            {
                sent += e.IsReplaced ? 1 : 0;
            }
        }

        Assert.Empty(control.Wrong);
        Assert.Equal(sent, control.Replaced);
    }

    private static ProgramSender Sender(FaultyFolder folder, Func<MachineState> say) =>
        new(folder, h => h == Hash(Old) || h == Hash(New), null, Guard(new ToldState(say)));

    private static ReplacementGuard Guard(StateSettings state) => ReplacementGuard.Of(
        new()
        {
            Name = "mill",
            Dialect = "siemens-840d",
            Transport = new FolderSettings("nowhere"),
            Slots = [],
            Timeout = TimeSpan.FromSeconds(1),
            Attempts = 1,
            State = state,
        },
        TimeProvider.System)!;

    private static string Hash(byte[] bytes) => Convert.ToHexStringLower(SHA256.HashData(bytes));

    private static FaultyFolder Folder(ServerKind server)
    {
        var folder = new FaultyFolder(server, new Dictionary<int, Fault>());
        folder.Files[Program] = Old;
        return folder;
    }
}
