using System.Diagnostics;
using ErrorMatching.Cell;

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
        var lengths = await LengthsAsync();
        var faults = new List<CutFault>();
        for (var connection = 0; connection < lengths.Length; connection++)
        {
            // Both runs, both ways: sparsely while keys are exchanged, densely behind the login.
            var (up, down) = lengths[connection];
            faults.AddRange(Places(up, 70).Select(n => new CutFault(CutKind.Cut, connection, true, n)));
            faults.AddRange(Places(down, 45).Select(n => new CutFault(CutKind.Cut, connection, false, n)));
        }

        Assert.True(faults.Count >= 200);
        var ends = new bool[faults.Count];
        await EachAsync(
            faults.Select((f, n) => (f, n)).ToArray(),
            async (proxy, program, fault) => ends[fault.n] = (
                await BreakAsync(proxy, program, fault.f, FtpPeer.Patience, mend: fault.n % 8 == 0, TransportError.Away)).IsNew);
        Assert.Contains(true, ends);
        Assert.Contains(false, ends);
    }

    [Fact]
    public async Task A_byte_changed_on_the_way_breaks_the_connection_and_no_program()
    {
        SshPeer.IsNeeded();
        var (up, down) = (await LengthsAsync())[0];
        var faults = new[] { up / 2, up - 600, up - 200 }.Select(n => new CutFault(CutKind.Corrupt, 0, true, n))
            .Concat(new[] { down / 2, down - 600, down - 200 }.Select(n => new CutFault(CutKind.Corrupt, 0, false, n)));
        await EachAsync([.. faults], async (proxy, program, fault) =>
        {
            // Whoever receives a changed packet hangs up, which to us is a machine that went away. Where the change made a packet longer,
            // it waits for the rest instead, which never comes.
            var (failure, isNew) = await UntilItHappensAsync(proxy, program, fault, seconds: 10, TransportError.Away, TransportError.Slow);
            Assert.True(failure is not null, $"{fault} went unseen.");
            Assert.False(isNew);
        });
    }

    [Fact]
    public async Task A_connection_that_stalls_is_given_up_in_time()
    {
        SshPeer.IsNeeded();
        var (up, down) = (await LengthsAsync())[0];
        await EachAsync(
            [
                new CutFault(CutKind.Stall, 0, true, 0),
                new CutFault(CutKind.Stall, 0, true, up - 300),
                new CutFault(CutKind.Stall, 1, false, down / 2)],
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

    // How much goes through in the two runs of a transfer that nothing breaks.
    private async Task<(long Up, long Down)[]> LengthsAsync()
    {
        using var proxy = new CutProxy(_peer.Value.Port);
        var program = new SentProgram(_peer.Value.Folder, "LENGTHS.MPF");
        program.Reset();
        proxy.Arm(null);
        var machine = Open(proxy, FtpPeer.Patience);
        Assert.Equal(SentProgram.New, await machine.WriteAsync("LENGTHS.MPF.new", SentProgram.New, Token));
        await proxy.QuietAsync();
        var first = proxy.Passed;
        Assert.Equal(SentProgram.New, await machine.RenameAsync("LENGTHS.MPF.new", "LENGTHS.MPF", SentProgram.Bytes, Token));
        await proxy.QuietAsync();
        return [first, proxy.Passed];
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
        var failure = await program.SendAsync(Open(proxy, seconds));
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
            await program.MendAsync(Open(proxy, FtpPeer.Patience), fault.ToString());
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
