using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>A server that does not rename over a file: vsftpd behind a proxy that says so in its place.
/// Both programs lie there whole while neither has the name.</summary>
public sealed class FtpWithoutReplacingTests : IDisposable
{
    private readonly Lazy<FtpPeer> _peer = new(() => new FtpPeer(FtpTls.None));

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    public void Dispose()
    {
        if (_peer.IsValueCreated)
            _peer.Value.Dispose();
    }

    [Fact]
    public async Task A_program_is_replaced_in_two_steps()
    {
        FtpPeer.IsNeeded();
        using var proxy = new FtpProxy(_peer.Value.Port) { KeepsFilesOf = _peer.Value.Folder };
        var program = new SentProgram(_peer.Value.Folder, "P1.MPF");
        program.Reset();
        Assert.Null(await program.SendAsync(_peer.Value.Open(proxy.Port)));
        Assert.True(program.IsWhole("two steps"));
        Assert.Empty(program.Leftovers());
    }

    [Theory]
    [InlineData("STOR")]
    [InlineData("RNFR", Explicit = true)]
    [InlineData("RNTO")]
    [InlineData("RETR", Explicit = true)]
    [InlineData("NLST", Explicit = true)]
    [InlineData("DELE")]
    public async Task A_cut_at_any_command_leaves_a_program_or_both_halves(string command)
    {
        FtpPeer.IsNeeded();
        using var proxy = new FtpProxy(_peer.Value.Port) { KeepsFilesOf = _peer.Value.Folder };
        var program = new SentProgram(_peer.Value.Folder, "P1.MPF");

        // The first, second, ... time that the command is given, until a transfer gives it no more.
        var times = 0;
        foreach (var isBefore in new[] { true, false })
        {
            for (var skip = 0; ; skip++)
            {
                program.Reset();
                var what = $"{(isBefore ? "before" : "after")} {command} {skip}";
                proxy.Arm(isBefore ? new FtpFault { CutBefore = command, Skip = skip } : new FtpFault { CutAfter = command, Skip = skip });
                var failure = await program.SendAsync(_peer.Value.Open(proxy.Port));
                var happened = !proxy.IsArmed;
                program.IsWhole(what + ", at once", inTwoSteps: true);
                await proxy.QuietAsync();
                proxy.Disarm();
                program.IsWhole(what, inTwoSteps: true);
                await program.MendAsync(_peer.Value.Open(proxy.Port), what);
                if (!happened)
                {
                    Assert.Null(failure);
                    break;
                }

                times++;
                Assert.Equal(TransportError.Away, failure?.Error);
            }
        }

        Assert.True(times >= 2);
    }

    [Fact]
    public async Task Tries_go_on_where_a_cut_left_both_halves()
    {
        FtpPeer.IsNeeded();
        using var proxy = new FtpProxy(_peer.Value.Port) { KeepsFilesOf = _peer.Value.Folder };
        var program = new SentProgram(_peer.Value.Folder, "P1.MPF");
        program.Reset();

        // The third renaming is the new program's, after the old one went aside.
        proxy.Arm(new FtpFault { CutBefore = "RNTO", Skip = 2 });
        var machine = _peer.Value.Machine(proxy.Port, attempts: 3);
        var failed = new List<TransferTry>();
        var sender = new ProgramSender(_peer.Value.Open(proxy.Port), _ => true,
            TransferTries.For(machine, TimeProvider.System, failed.Add));
        await sender.SendAsync("P1.MPF", SentProgram.Hash(SentProgram.Old), SentProgram.New, "17", Token);
        Assert.True(program.IsWhole("two tries"));
        Assert.Empty(program.Leftovers());
        var one = Assert.Single(failed);
        Assert.Equal(("mill", 1, TransportError.Away), (one.Machine, one.Number, one.Failure.Error));
    }
}
