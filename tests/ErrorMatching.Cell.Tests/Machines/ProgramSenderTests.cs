using System.Security.Cryptography;
using System.Text;
using Polly;
using Polly.Retry;

namespace ErrorMatching.Cell.Tests;

/// <summary>The machine has the old program or the new one, whole, wherever a transfer fails: in all places and all pairs of places, with
/// servers that rename over a file and those that do not.</summary>
public sealed class ProgramSenderTests
{
    private const string Program = "P100.MPF";

    // A transfer in two steps, cleaned up after, has no more operations.
    private const int Places = 16;

    private static readonly byte[] Old = Encoding.ASCII.GetBytes("G1 X1\nM30\n");
    private static readonly byte[] New = Encoding.ASCII.GetBytes("G1 X2.001 Y3\nM30\n");
    private static readonly Fault[] Faults = [Fault.Before, Fault.InPart, Fault.After, Fault.Corrupt, Fault.Denied, Fault.Full];

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Theory]
    [InlineData(ServerKind.Exchanges, 4)]
    [InlineData(ServerKind.Replaces, 3)]
    [InlineData(ServerKind.Refuses, 6)]
    public async Task A_program_is_sent_in_as_few_operations_as_its_server_allows(ServerKind server, int operations)
    {
        var folder = Folder(server, true, []);
        await Sender(folder).SendAsync(Program, Hash(Old), New, "17", Token);
        Assert.Equal([Program], folder.Files.Keys);
        Assert.Equal(New, folder.Files[Program]);
        Assert.Equal(operations, folder.Operations);
    }

    [Theory]
    [InlineData(ServerKind.Exchanges, true, false)]
    [InlineData(ServerKind.Exchanges, false, false)]
    [InlineData(ServerKind.Exchanges, true, true)]
    [InlineData(ServerKind.Exchanges, false, true)]
    [InlineData(ServerKind.Replaces, true, false)]
    [InlineData(ServerKind.Replaces, false, false)]
    [InlineData(ServerKind.Replaces, true, true)]
    [InlineData(ServerKind.Replaces, false, true)]
    [InlineData(ServerKind.Refuses, true, false)]
    [InlineData(ServerKind.Refuses, false, false)]
    [InlineData(ServerKind.Refuses, true, true)]
    [InlineData(ServerKind.Refuses, false, true)]
    public async Task The_program_is_the_old_or_the_new_one_wherever_a_transfer_fails_once_or_twice(ServerKind server, bool hadOne,
        bool triesAgain)
    {
        var sawBoth = (Old: false, New: false);
        for (var first = 0; first < Places; first++)
        {
            for (var second = first; second < Places; second++)
            {
                foreach (var one in Faults)
                {
                    foreach (var other in second == first ? [one] : Faults)
                    {
                        var plan = new Dictionary<int, Fault> { [first] = one, [second] = other };
                        var (wasOld, wasNew) = await EndsWholeAsync(server, hadOne, triesAgain, plan);
                        sawBoth = (sawBoth.Old || wasOld, sawBoth.New || wasNew);
                    }
                }
            }
        }

        Assert.True(sawBoth is { Old: true, New: true });
    }

    // At every instant of a transfer but one: FTP has no word that looks and renames at once, so there the last look and the renaming are
    // two.
    [Theory]
    [InlineData(ServerKind.Exchanges, 4, -1)]
    [InlineData(ServerKind.Replaces, 3, 1)]
    [InlineData(ServerKind.Refuses, 6, -1)]
    public async Task What_somebody_changes_while_a_program_is_sent_is_not_lost(ServerKind server, int operations, int open)
    {
        byte[] edited = [.. Old, .. "(edited)"u8];
        foreach (var instant in Enumerable.Range(0, operations).Where(i => i != open))
        {
            var (folder, isEdited) = (Folder(server, true, []), false);
            folder.Changed = () =>
            {
                if (folder.Operations == instant + 1)
                    (isEdited, folder.Files[Program]) = (true, edited);
            };
            var failure = await Record.ExceptionAsync(() => Sender(folder).SendAsync(Program, Hash(Old), New, "17", Token));
            Assert.Equal(isEdited ? edited : New, folder.Files[Program]);
            Assert.Equal([Program], folder.Files.Keys);

            // What is changed once the new program has its name is no matter of this transfer.
            if (isEdited && instant < operations - 2)
                Assert.True(failure is ChangedAtMachineException { Found: var found } ? found!.SequenceEqual(edited)
                    : failure is TransportException, $"{instant}: {failure}");
        }
    }

    [Theory]
    [InlineData(ServerKind.Exchanges)]
    [InlineData(ServerKind.Replaces)]
    [InlineData(ServerKind.Refuses)]
    public async Task What_a_cut_left_aside_and_nobody_keeps_gets_its_place_back(ServerKind server)
    {
        byte[] edited = [.. Old, .. "(edited)"u8];
        var folder = Folder(server, false, []);
        folder.Files[Program] = New;
        folder.Files[Program + ".emold"] = edited;
        await Sender(folder).RecoverAsync(Program, Token);
        Assert.Equal(edited, folder.Files[Program]);
        Assert.Equal([Program], folder.Files.Keys);

        // Two that nobody keeps are a person's to look at.
        folder.Files[Program + ".emold"] = [1];
        Assert.Equal([1], (await Assert.ThrowsAsync<ChangedAtMachineException>(() => Sender(folder).RecoverAsync(Program, Token))).Found);
        Assert.Equal(2, folder.Files.Count);
        folder.Files[folder.Files.Keys.Single(n => n != Program)] = edited;
        await Sender(folder).RecoverAsync(Program, Token);
        Assert.Equal([Program], folder.Files.Keys);
    }

    [Fact]
    public async Task Both_halves_of_a_cut_rename_become_the_old_program()
    {
        var folder = Folder(ServerKind.Refuses, false, []);
        folder.Files[Program + ".emold"] = Old;
        folder.Files[Program + ".17-0123abcd.emnew"] = New;
        await Sender(folder).RecoverAsync(Program, Token);
        Assert.Equal([Program], folder.Files.Keys);
        Assert.Equal(Old, folder.Files[Program]);
    }

    [Fact]
    public async Task Recovery_leaves_files_of_other_programs_and_people_alone()
    {
        var folder = Folder(ServerKind.Replaces, true, []);
        string[] others = [
            "P100.MPF.old", "P100.MPF.emnew", "P100.MPF.A.emnew", "P1000.MPF.17-0123abcd.emnew", "P100.MP.17-0123abcd.emnew",
            "P100.MPF.X.17-0123abcd.emnew", "P100.emold"];
        foreach (var other in others)
            folder.Files[other] = [1];
        await Sender(folder).RecoverAsync(Program, Token);
        Assert.Equal(others.Append(Program).Order(StringComparer.Ordinal), folder.Files.Keys.Order(StringComparer.Ordinal));
    }

    [Theory]
    [InlineData("../P100")]
    [InlineData("A/B")]
    [InlineData("A\\B")]
    [InlineData("")]
    [InlineData(".")]
    [InlineData("..")]
    [InlineData(".hidden")]
    [InlineData("-rf")]
    [InlineData("A B")]
    [InlineData("A\n")]
    [InlineData("A\0")]
    [InlineData("Ä")]
    [InlineData("CON")]
    [InlineData("lpt1.mpf")]
    [InlineData("A.")]
    [InlineData("A.emnew")]
    [InlineData("A.EMOLD")]
    [InlineData("A;rm")]
    [InlineData("A*")]
    [InlineData("C:A")]
    public async Task A_name_beside_the_white_list_reaches_no_machine(string name)
    {
        var folder = Folder(ServerKind.Replaces, true, []);
        var sender = Sender(folder);
        Assert.False(ProgramNames.Allows(name));
        var refusals = new[]
        {
            await Assert.ThrowsAsync<TransportException>(() => sender.SendAsync(name, Hash(Old), New, "17", Token)),
            await Assert.ThrowsAsync<TransportException>(() => sender.CurrentAsync(name, Token)),
            await Assert.ThrowsAsync<TransportException>(() => sender.RecoverAsync(name, Token)),
        };
        Assert.All(refusals, r => Assert.Equal(TransportError.Denied, r.Error));
        Assert.Equal(0, folder.Operations);
    }

    [Theory]
    [InlineData("P100.MPF")]
    [InlineData("O1234")]
    [InlineData("_N_P100_MPF")]
    [InlineData("a")]
    [InlineData("CONE.MPF")]
    [InlineData("1-2_3.4")]
    public void Names_of_programs_are_allowed(string name) => Assert.True(ProgramNames.Allows(name));

    [Fact]
    public void A_name_has_at_most_64_characters()
    {
        Assert.True(ProgramNames.Allows(new string('A', 64)));
        Assert.False(ProgramNames.Allows(new string('A', 65)));
    }

    [Fact]
    public async Task What_cannot_succeed_is_not_tried_again()
    {
        var folder = Folder(ServerKind.Replaces, true, new() { [0] = Fault.Denied });
        var failure = await Assert.ThrowsAsync<TransportException>(() =>
            Sender(folder, Tries(5)).SendAsync(Program, Hash(Old), New, "17", Token));
        Assert.Equal(TransportError.Denied, failure.Error);
        Assert.Equal(Old, folder.Files[Program]);
    }

    [Fact]
    public async Task A_lost_answer_does_not_send_a_program_twice()
    {
        var folder = Folder(ServerKind.Replaces, true, new() { [2] = Fault.After });
        var written = new HashSet<string>(StringComparer.Ordinal);
        folder.Changed = () => written.UnionWith(folder.Files.Keys.Where(n => n.EndsWith(".emnew", StringComparison.Ordinal)));
        await Sender(folder, Tries(2)).SendAsync(Program, Hash(Old), New, "17", Token);
        Assert.Equal(New, folder.Files[Program]);
        Assert.Single(written);
    }

    private static async Task<(bool WasOld, bool WasNew)> EndsWholeAsync(ServerKind server, bool hadOne, bool triesAgain, Dictionary<int,
        Fault> plan)
    {
        var folder = Folder(server, hadOne, plan);
        byte[]? old = hadOne ? Old : null;
        folder.Changed = () => Assert.True(IsWhole(folder, old, server), $"{Describe(folder)} after {string.Join(", ", plan)}");
        var sender = Sender(folder, triesAgain ? Tries(3) : null);
        var sent = await SucceedsAsync(() => sender.SendAsync(Program, Hash(old), New, "17", Token));
        if (sent)
            Assert.Equal(New, folder.Files[Program]);
        await SucceedsAsync(() => sender.RecoverAsync(Program, Token));

        // The faults left over are beyond this point: a folder of its own that has the same files.
        var healthy = Folder(server, false, []);
        foreach (var (name, bytes) in folder.Files)
            healthy.Files[name] = bytes;
        healthy.Changed = () => Assert.True(IsWhole(healthy, old, server), $"{Describe(healthy)} after {string.Join(", ", plan)}");
        await Sender(healthy).RecoverAsync(Program, Token);
        var (wasOld, wasNew) = (Same(healthy, old), Same(healthy, New));
        Assert.True(wasOld || wasNew, $"{Describe(healthy)} after {string.Join(", ", plan)}");
        Assert.True(!sent || wasNew);
        Assert.All(healthy.Files.Keys, n => Assert.Equal(Program, n));

        await Sender(healthy).SendAsync(Program, Hash(healthy.Files.GetValueOrDefault(Program)), New, "18", Token);
        Assert.Equal([Program], healthy.Files.Keys);
        Assert.Equal(New, healthy.Files[Program]);
        return (wasOld, wasNew);
    }

    private static bool IsWhole(FaultyFolder folder, byte[]? old, ServerKind server)
    {
        if (Same(folder, old) || Same(folder, New))
            return true;

        // Between two steps one lies beside it, whole, and gets its name back.
        return server == ServerKind.Refuses && !folder.Files.ContainsKey(Program)
            && folder.Files.Any(f => f.Key.EndsWith(".emold", StringComparison.Ordinal)
                && (f.Value.SequenceEqual(New) || (old is not null && f.Value.SequenceEqual(old))));
    }

    // What is his own and what was there the cell keeps elsewhere.
    private static ProgramSender Sender(FaultyFolder folder, ResiliencePipeline? tries = null) =>
        new(folder, h => h == Hash(Old) || h == Hash(New), tries);

    private static string? Hash(byte[]? bytes) => bytes is null ? null : Convert.ToHexStringLower(SHA256.HashData(bytes));

    private static bool Same(FaultyFolder folder, byte[]? bytes)
    {
        var there = folder.Files.GetValueOrDefault(Program);
        return bytes is null ? there is null : there?.SequenceEqual(bytes) == true;
    }

    private static string Describe(FaultyFolder folder) =>
        string.Join(", ", folder.Files.Select(f => $"{f.Key}={Encoding.ASCII.GetString(f.Value)}"));

    private static FaultyFolder Folder(ServerKind server, bool hasOne, Dictionary<int, Fault> faults)
    {
        var folder = new FaultyFolder(server, faults);
        if (hasOne)
            folder.Files[Program] = Old;
        return folder;
    }

    private static async Task<bool> SucceedsAsync(Func<Task> work)
    {
        try
        {
            await work();
            return true;
        }
        catch (Exception failure) when (failure is TransportException or ChangedAtMachineException)
        {
            // What is read wrongly is taken for changed.
            return false;
        }
    }

    private static ResiliencePipeline Tries(int most) => new ResiliencePipelineBuilder()
        .AddRetry(new RetryStrategyOptions
        {
            MaxRetryAttempts = most - 1,
            Delay = TimeSpan.Zero,
            ShouldHandle = args => ValueTask.FromResult(args.Outcome.Exception is TransportException { IsWorthAnotherTry: true }),
        })
        .Build();
}
