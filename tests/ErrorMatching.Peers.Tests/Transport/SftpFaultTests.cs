using System.Diagnostics;
using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>A real sshd behind a proxy that cuts, holds and changes the stream:
/// the program there is the old one or the new one, whole.</summary>
public sealed class SftpFaultTests : IDisposable
{
    private const int Workers = 4;

    private readonly Lazy<SshPeer> _peer = new(() => new SshPeer());

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    public void Dispose()
    {
        if (_peer.IsValueCreated)
            _peer.Value.Dispose();
    }

    [Fact]
    public async Task A_connection_cut_after_any_byte_leaves_one_program_whole()
    {
        SshPeer.IsNeeded();
        var (up, down) = await LengthsAsync(withGoodbye: true);

        // Both ways: sparsely while keys are exchanged, densely behind the login.
        var faults = Places(up, Depth.Of(42, 140)).Select(n => new CutFault(CutKind.Cut, 0, true, n))
            .Concat(Places(down, Depth.Of(30, 100)).Select(n => new CutFault(CutKind.Cut, 0, false, n))).ToArray();
        Assert.True(faults.Length >= Depth.Of(60, 200));
        var ends = new bool[faults.Length];
        await EachAsync(
            [.. faults.Select((f, n) => (f, n))],
            async (proxy, program, fault) => ends[fault.n] = (
                await BreakAsync(proxy, program, fault.f, FtpPeer.Patience, mend: fault.n % 8 == 0, TransportError.Away)).IsNew);
        Assert.Contains(true, ends);
        Assert.Contains(false, ends);
    }

    [Fact]
    public async Task A_byte_changed_on_the_way_breaks_the_connection_and_no_program()
    {
        SshPeer.IsNeeded();
        // The last places are in the last request and in its answer, each longer than twice as much. A change in the goodbye behind them
        // would go unseen, and rightly so: everything was answered.
        var (up, down) = await LengthsAsync(withGoodbye: false);
        var faults = new[] { up / 2, up - 2500, up - 400, up - 24 }.Select(n => new CutFault(CutKind.Corrupt, 0, true, n))
            .Concat(new[] { down / 2, down - 2500, down - 400, down - 24 }.Select(n => new CutFault(CutKind.Corrupt, 0, false, n)));
        await EachAsync([.. faults], async (proxy, program, fault) =>
        {
            // Whoever receives a changed packet hangs up, which to us is a machine that went away. Where the change made a packet longer,
            // it waits for the rest instead, which never comes.
            var (failure, _) = await UntilItHappensAsync(proxy, program, fault, seconds: 3, TransportError.Away, TransportError.Slow);
            Assert.True(failure is not null, $"{fault} went unseen.");
        });
    }

    [Fact]
    public async Task A_connection_that_stalls_is_given_up_in_time()
    {
        SshPeer.IsNeeded();
        var (up, down) = await LengthsAsync(withGoodbye: false);
        await EachAsync(
            [
                new CutFault(CutKind.Stall, 0, true, 0),
                new CutFault(CutKind.Stall, 0, true, up - 150),
                new CutFault(CutKind.Stall, 0, false, down - 150)],
            async (proxy, program, fault) =>
        {
            var (failure, _) = await UntilItHappensAsync(proxy, program, fault, seconds: 2, TransportError.Slow);
            Assert.True(failure is not null, $"{fault} was not given up.");
        });
    }

    private static IEnumerable<long> Places(long length, int most)
    {
        var early = (int)(most * 0.3);
        var turn = length / 2;
        return Enumerable.Range(0, early).Select(n => turn * n / early)
            .Concat(Enumerable.Range(0, most - early).Select(n => turn + ((length - turn) * n / (most - early))))
            .Distinct();
    }

    // How much goes through in a transfer that nothing breaks, of a program whose name is as long as those of the others.
    private async Task<(long Up, long Down)> LengthsAsync(bool withGoodbye)
    {
        using var proxy = new CutProxy(_peer.Value.Port);
        var program = new SentProgram(_peer.Value.Folder, "P9.MPF");
        program.Reset();
        proxy.Arm(null);
        using (var machine = Open(proxy, FtpPeer.Patience))
        {
            Assert.Null(await program.SendAsync(machine));
            if (!withGoodbye)
                return proxy.Passed;
        }

        await proxy.QuietAsync();
        Assert.True(program.IsWhole("nothing"));
        return proxy.Passed;
    }

    // On a busy computer the time may be up before the transfer came as far as the fault: then it gets more.
    private async Task<(TransportException? Failure, bool IsNew)> UntilItHappensAsync(
        CutProxy proxy, SentProgram program, CutFault fault, double seconds, params TransportError[] errors)
    {
        while (true)
        {
            var (failure, isNew, happened) = await BreakAsync(proxy, program, fault, seconds, mend: true, errors);
            if (happened)
                return (failure, isNew);

            Assert.True(seconds < FtpPeer.Patience, $"{fault} did not happen: {failure?.Message}");
            seconds *= 2;
        }
    }

    private async Task<(TransportException? Failure, bool IsNew, bool Happened)> BreakAsync(
        CutProxy proxy, SentProgram program, CutFault fault, double seconds, bool mend, params TransportError[] errors)
    {
        program.Reset();
        proxy.Arm(fault);
        TransportException? failure;
        using (var machine = Open(proxy, seconds))
            failure = await program.SendAsync(machine);
        var happened = !proxy.IsArmed;
        proxy.Arm(null);
        program.IsWhole($"{fault}, at once");
        await proxy.QuietAsync();
        var isNew = program.IsWhole(fault.ToString());

        // The last bytes only say goodbye, and their number differs by a few: nobody may hear the cut.
        if (failure is null)
            Assert.True(isNew, fault.ToString());
        else
            Assert.True(errors.Contains(failure.Error), $"{fault}: {failure.Message}");
        if (mend)
        {
            using var machine = Open(proxy, FtpPeer.Patience);
            await program.MendAsync(machine, fault.ToString());
        }

        return (failure, isNew, happened);
    }

    private IMachineFolder Open(CutProxy proxy, double seconds) => _peer.Value.Open(s => s with { Port = proxy.Port }, seconds);

    private async Task EachAsync<T>(T[] cases, Func<CutProxy, SentProgram, T, Task> check)
    {
        var watch = Stopwatch.StartNew();
        var folder = _peer.Value.Folder;
        await Parallel.ForEachAsync(
            Enumerable.Range(0, Math.Min(Workers, cases.Length)),
            new ParallelOptions { MaxDegreeOfParallelism = Workers, CancellationToken = Token },
            async (worker, _) =>
        {
            using var proxy = new CutProxy(_peer.Value.Port);
            var program = new SentProgram(folder, $"P{worker}.MPF");
            for (var n = worker; n < cases.Length; n += Workers)
                await check(proxy, program, cases[n]);
        });
        TestContext.Current.TestOutputHelper?.WriteLine($"{cases.Length} cases in {watch.Elapsed.TotalSeconds:0.0} s");
    }
}
