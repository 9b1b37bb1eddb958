using System.Diagnostics;
using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>A real vsftpd behind a proxy that breaks what it is told to:
/// the program there is the old one or the new one, whole, whatever breaks and wherever.</summary>
public sealed class FtpFaultTests : IDisposable
{
    private const int Workers = 6;

    // Bytes are alike but for the first and last ones, and those about half a program.
    private static readonly IEnumerable<int> Places = Enumerable.Range(0, SentProgram.Bytes + 1)
        .Where(n => n % Depth.Of(400, 1) == 0 || n < 3 || n > SentProgram.Bytes - 3 || Math.Abs(n - (SentProgram.Bytes / 2)) < 2);

    private readonly Lazy<FtpPeer> _peer = new(() => new FtpPeer(FtpTls.None));

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    public void Dispose()
    {
        if (_peer.IsValueCreated)
            _peer.Value.Dispose();
    }

    [Fact]
    public async Task A_connection_cut_after_any_byte_of_a_program_leaves_the_old_one_whole()
    {
        FtpPeer.IsNeeded();
        await EachAsync(Places, async (proxy, program, n) =>
        {
            // Every fourth is recovered from, and sent again where that begins with no byte, one, or all of them, and at some in between.
            var fault = new FtpFault { CutWriting = n };
            var mend = n < 2 || n % 32 == 0 || n > SentProgram.Bytes - 16;
            var (failure, isNew) = await BreakAsync(proxy, program, fault, mend);
            if (!mend && n % 4 == 0)
                await program.RecoverAsync(_peer.Value.Open(proxy.Port), fault.ToString());
            Assert.True(TransportError.Away == failure?.Error, $"{n}: {failure?.Message}");
            Assert.False(isNew);
        });
    }

    [Fact]
    public async Task A_connection_cut_while_a_program_is_read_back_leaves_one_whole()
    {
        FtpPeer.IsNeeded();
        var places = new[] { 0, 2 }.SelectMany(r => new[] { 0, 1, 2, 100, 1023, 1024, 2046, 2047, 2048 }.Select(n => (r, n)));
        await EachAsync(places, async (proxy, program, place) =>
        {
            var (failure, isNew) = await BreakAsync(proxy, program, new FtpFault { CutReading = place.n, Reading = place.r });
            Assert.True(TransportError.Away == failure?.Error, $"{place}: {failure?.Message}");
            Assert.Equal(place.r == 2, isNew);
        });
    }

    [Fact]
    public async Task A_byte_changed_on_the_way_is_seen()
    {
        FtpPeer.IsNeeded();
        var faults = new[] { 0, 1, 1000, 2047 }.SelectMany(n => new[]
        {
            (Fault: new FtpFault { CorruptWriting = n }, IsNew: false),
            (Fault: new FtpFault { CorruptReading = n }, IsNew: false),
            (Fault: new FtpFault { CorruptReading = n, Reading = 2 }, IsNew: true),
        });
        await EachAsync(faults, async (proxy, program, fault) =>
        {
            var (failure, isNew) = await BreakAsync(proxy, program, fault.Fault);
            Assert.True(TransportError.Differs == failure?.Error, $"{fault}: {failure?.Message}");
            Assert.Equal(fault.IsNew, isNew);
        });
    }

    [Fact]
    public async Task A_connection_that_stalls_is_given_up_in_time()
    {
        FtpPeer.IsNeeded();
        var faults = new[] { 0, 1, 1024, 2048 }.SelectMany(n => new[]
        {
            new FtpFault { StallWriting = n },
            new FtpFault { StallReading = n },
            new FtpFault { StallReading = n, Reading = 2 },
        });
        await EachAsync(faults, async (proxy, program, fault) =>
        {
            // On a busy computer the time may be up before the transfer came as far as the fault: then it gets more.
            for (var (seconds, happened) = (1.0, false); !happened; seconds *= 2)
            {
                (var failure, _, happened) = await TryToBreakAsync(proxy, program, fault, seconds);
                Assert.True(TransportError.Slow == failure?.Error, $"{fault}: {failure?.Message}");
                Assert.True(happened || seconds < FtpPeer.Patience, $"{fault} did not happen: {failure?.Message}");
            }
        });
    }

    [Fact]
    public async Task A_connection_cut_at_any_command_leaves_one_whole()
    {
        FtpPeer.IsNeeded();
        string[] commands = ["USER", "PASS", "PWD", "CWD", "EPSV", "TYPE", "STOR", "SIZE", "RETR", "RNFR", "RNTO"];
        var faults = commands.SelectMany(c => new[] { new FtpFault { CutBefore = c }, new FtpFault { CutAfter = c } });
        await EachAsync(faults, async (proxy, program, fault) =>
        {
            var (failure, isNew) = await BreakAsync(proxy, program, fault);
            Assert.True(TransportError.Away == failure?.Error, $"{fault}: {failure?.Message}");
            Assert.Equal(fault.CutAfter == "RNTO", isNew);
        });
    }

    [Theory]
    [InlineData("STOR", "550 Permission denied.", TransportError.Denied)]
    [InlineData("STOR", "553 Name not allowed.", TransportError.Denied, Explicit = true)]
    [InlineData("STOR", "552 No room.", TransportError.Full)]
    [InlineData("STOR", "452 No room.", TransportError.Full, Explicit = true)]
    [InlineData("STOR", "450 In use.", TransportError.Unknown)]
    [InlineData("STOR", "421 Going down.", TransportError.Away)]
    [InlineData("STOR", "425 No data connection.", TransportError.Away, Explicit = true)]
    [InlineData("RETR", "550 Permission denied.", TransportError.Denied)]
    [InlineData("CWD", "550 Not there.", TransportError.Denied, Explicit = true)]
    [InlineData("PASS", "530 Login incorrect.", TransportError.Login)]
    [InlineData("USER", "421 Too many.", TransportError.Away, Explicit = true)]
    [InlineData("EPSV", "421 Too many.", TransportError.Away)]
    public async Task A_refusal_is_named_and_leaves_the_old_program(string command, string answer, TransportError error)
    {
        FtpPeer.IsNeeded();
        await EachAsync([0], async (proxy, program, _) =>
        {
            var (failure, isNew) = await BreakAsync(proxy, program, new FtpFault { Instead = (command, answer) });
            Assert.True(error == failure?.Error, failure?.Message);
            Assert.Contains(answer[..3], failure!.Message, StringComparison.Ordinal);
            Assert.False(isNew);
        });
    }

    [Theory]
    [InlineData("RNFR", "550 Not there.")]
    [InlineData("RNTO", "550 File exists.")]
    [InlineData("RNTO", "553 Name not allowed.", Explicit = true)]
    public async Task A_refused_renaming_goes_on_in_two_steps(string command, string answer)
    {
        FtpPeer.IsNeeded();
        await EachAsync([0], async (proxy, program, _) =>
        {
            var (failure, isNew) = await BreakAsync(proxy, program, new FtpFault { Instead = (command, answer) });
            Assert.Null(failure);
            Assert.True(isNew);
        });
    }

    [Theory]
    [InlineData("552 No room after all.", TransportError.Full)]
    [InlineData("550 Not kept.", TransportError.Denied, Explicit = true)]
    [InlineData("426 Failure reading network stream.", TransportError.Away)]
    [InlineData("451 Local error.", TransportError.Unknown, Explicit = true)]
    public async Task A_refusal_after_all_bytes_is_named_and_leaves_the_old_program(string answer, TransportError error)
    {
        FtpPeer.IsNeeded();
        await EachAsync([0], async (proxy, program, _) =>
        {
            var (failure, isNew) = await BreakAsync(proxy, program, new FtpFault { Finally = ("STOR", answer) });
            Assert.True(error == failure?.Error, failure?.Message);
            Assert.False(isNew);
        });
    }

    private async Task<(TransportException? Failure, bool IsNew)> BreakAsync(
        FtpProxy proxy, SentProgram program, FtpFault fault, bool mend = true)
    {
        var (failure, isNew, happened) = await TryToBreakAsync(proxy, program, fault, FtpPeer.Patience, mend);
        Assert.True(happened, $"{fault} did not happen: {failure?.Message}");
        return (failure, isNew);
    }

    private async Task<(TransportException? Failure, bool IsNew, bool Happened)> TryToBreakAsync(
        FtpProxy proxy, SentProgram program, FtpFault fault, double seconds, bool mend = true)
    {
        program.Reset();
        proxy.Arm(fault);
        var failure = await program.SendAsync(_peer.Value.Open(proxy.Port, seconds));
        var happened = !proxy.IsArmed;
        proxy.Disarm();
        program.IsWhole($"{fault}, at once");
        await proxy.QuietAsync();
        var isNew = program.IsWhole(fault.ToString());
        if (mend)
            await program.MendAsync(_peer.Value.Open(proxy.Port), fault.ToString());
        return (failure, isNew, happened);
    }

    // Several proxies at a time, each with a program of its own in the same folder.
    private async Task EachAsync<T>(IEnumerable<T> cases, Func<FtpProxy, SentProgram, T, Task> check)
    {
        var watch = Stopwatch.StartNew();
        var all = cases.ToArray();
        var folder = _peer.Value.Folder;
        await Parallel.ForEachAsync(
            Enumerable.Range(0, Math.Min(Workers, all.Length)),
            new ParallelOptions { MaxDegreeOfParallelism = Workers, CancellationToken = Token },
            async (worker, _) =>
        {
            using var proxy = new FtpProxy(_peer.Value.Port);
            var program = new SentProgram(folder, $"P{worker}.MPF");
            for (var n = worker; n < all.Length; n += Workers)
                await check(proxy, program, all[n]);
        });
        TestContext.Current.TestOutputHelper?.WriteLine($"{all.Length} cases in {watch.Elapsed.TotalSeconds:0.0} s");
    }
}
