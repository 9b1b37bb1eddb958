using System.Diagnostics;
using System.Globalization;
using ErrorMatching.Cell;
using ErrorMatching.Cell.Tests;
using ErrorMatching.EndToEnd.Tests;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>A process that is killed while curl sends leaves the program in a temporary folder; the next one removes it.</summary>
public sealed class KilledTransferTests
{
    [Fact]
    public async Task What_a_killed_process_left_of_a_transfer_is_gone_after_the_next_start()
    {
        FtpPeer.IsNeeded();
        using var peer = new FtpPeer(FtpTls.None);
        using var proxy = new FtpProxy(peer.Port);
        using var cell = await FtpCell.Of(peer, slots: 1);
        using var temporary = new TemporaryFolder();
        File.WriteAllText(cell.Configuration, File.ReadAllText(cell.Configuration).Replace(
            string.Create(CultureInfo.InvariantCulture, $"\"port\": {peer.Port}"),
            string.Create(CultureInfo.InvariantCulture, $"\"port\": {proxy.Port}"),
            StringComparison.Ordinal));
        proxy.Arm(new() { StallWriting = 10 });
        var slot = cell.Slots[0];
        using (var killed = Start(cell, temporary.Path))
        {
            cell.Drop($"{slot}_1.csv", File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "part.csv")));
            await ConfiguredCell.Until(() => !proxy.IsArmed);
            killed.Kill(entireProcessTree: true);
            await killed.WaitForExitAsync(TestContext.Current.CancellationToken);
        }

        var left = Left(temporary.Path);
        Assert.NotEmpty(left);
        using var next = Start(cell, temporary.Path);
        try
        {
            await ConfiguredCell.Until(() => left.All(f => !File.Exists(f)));
            await ConfiguredCell.Until(
                () => !File.ReadAllBytes(Path.Combine(peer.Folder, FireCell.ProgramOf(slot))).SequenceEqual(
                    File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "counterpart.nc"))));
        }
        finally
        {
            next.Kill(entireProcessTree: true);
            await next.WaitForExitAsync(CancellationToken.None);
        }
    }

    // Programs on their way.
    private static string[] Left(string temporary) => [.. Directory.EnumerateFiles(temporary, "program", SearchOption.AllDirectories)];

    private static Process Start(FireCell cell, string temporary)
    {
        var start = new ProcessStartInfo(ConsoleRun.Executable, ["cell", "run", cell.Configuration])
        {
            UseShellExecute = false,
            WorkingDirectory = cell.Folder,
            RedirectStandardOutput = true,
            RedirectStandardError = true
        };
        start.Environment["TMPDIR"] = temporary;
        var process = Process.Start(start)!;
        process.BeginOutputReadLine();
        process.BeginErrorReadLine();
        return process;
    }
}
