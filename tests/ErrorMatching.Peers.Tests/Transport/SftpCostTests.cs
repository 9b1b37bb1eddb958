using System.Diagnostics;
using System.Globalization;
using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>What a program costs over SFTP, and what cuts at random places leave. <c>tests/fire sftp PROGRAMS</c> measures both.</summary>
public sealed class SftpCostTests
{
    private static CancellationToken Token => TestContext.Current.CancellationToken;

    private static int? Measured => int.TryParse(
        Environment.GetEnvironmentVariable("ERRORMATCH_SFTP"), NumberStyles.None, CultureInfo.InvariantCulture, out var n) ? n : null;

    [Fact]
    public async Task A_program_costs_a_few_messages_and_no_login()
    {
        SshPeer.IsNeeded();
        var programs = Measured ?? 10;
        using var peer = new SshPeer();
        using var proxy = new CutProxy(peer.Port);
        var program = new SentProgram(peer.Folder, "P1.MPF");
        using var direct = peer.Open();
        using (var machine = peer.Open(s => s with { Port = proxy.Port }))
        {
            for (var n = 0; n < programs; n++)
                await SendAsync(program, machine);
            Assert.Equal(1, proxy.Connections);
        }

        // What the test itself needs was compiled by now, and the proxy is not part of the cell.
        await SendAsync(program, direct);
        var (before, watch) = (Process.GetCurrentProcess().TotalProcessorTime, Stopwatch.StartNew());
        for (var n = 0; n < programs; n++)
            await SendAsync(program, direct);
        var each = (Process.GetCurrentProcess().TotalProcessorTime - before).TotalMilliseconds / programs;
        var all = watch.Elapsed.TotalMilliseconds / programs;
        Write($"{programs} programs over one connection: {each:0.0} ms of processor time and {all:0.0} ms each");
        if (Measured is null)
            return;
        Assert.InRange(each, 0, 29);
    }

    [Fact(Explicit = true)]
    public async Task Cuts_at_random_places_tear_and_lose_nothing()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        using var proxy = new CutProxy(peer.Port);
        var program = new SentProgram(peer.Folder, "P1.MPF");
        program.Reset();
        using (var whole = peer.Open(s => s with { Port = proxy.Port }))
            Assert.Null(await program.SendAsync(whole));
        await proxy.QuietAsync();
        var (up, down) = proxy.Passed;
        var random = new Random(29);
        var (cuts, sent) = (Measured ?? 20, 0);
        for (var n = 0; n < cuts; n++)
        {
            program.Reset();
            var isUp = random.Next(2) == 0;
            var fault = new CutFault(CutKind.Cut, 0, isUp, random.NextInt64(isUp ? up : down));
            proxy.Arm(fault);
            TransportException? failure;
            using (var machine = peer.Open(s => s with { Port = proxy.Port }))
                failure = await program.SendAsync(machine);
            proxy.Arm(null);
            await proxy.QuietAsync();
            sent += program.IsWhole(fault.ToString()) ? 1 : 0;
            Assert.True(failure is null or { Error: TransportError.Away }, failure?.Message);
            using var mending = peer.Open();
            await program.MendAsync(mending, fault.ToString());
        }

        Write($"{cuts} cuts: {cuts - sent} left the old program, {sent} the new one, none a torn or lost one");
    }

    private static async Task SendAsync(SentProgram program, IMachineFolder machine)
    {
        program.Reset();
        Assert.Null(await program.SendAsync(machine));
        Assert.True(program.IsWhole("sending"));
    }

    private static void Write(FormattableString line) =>
        TestContext.Current.TestOutputHelper?.WriteLine(line.ToString(CultureInfo.InvariantCulture));
}
