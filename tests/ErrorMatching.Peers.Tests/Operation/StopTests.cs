using ErrorMatching.Cell;
using ErrorMatching.EndToEnd.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>A cell at its own pace that is told to stop, by the signal of service managers,
/// while its machine hangs in the middle of a program.</summary>
public sealed class StopTests
{
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(2);

    [Theory]
    [InlineData(false)]
    [InlineData(true, Explicit = true)]
    public async Task It_ends_within_10_s_gives_back_what_it_can_and_the_next_start_goes_on(bool forGood)
    {
        FtpPeer.IsNeeded();
        using var ftp = new FtpPeer(FtpTls.None);
        using var hang = new FtpHang(ftp.Port, "STOR", forGood);
        using var cell = await FtpCell.Of(ftp, slots: 1, hang.Port);
        var files = new FireFiles();
        var (name, bytes) = files.Next(cell.Slots[0], 1);
        var program = Path.Combine(ftp.Folder, FireCell.ProgramOf(cell.Slots[0]));
        cell.Start();
        cell.Drop(name, bytes);
        await cell.Until(() => Task.FromResult(hang.HasHung), Patience, "the machine hangs");
        Assert.Equal("uploading", await cell.StateOf(name));

        await cell.Stop();
        var state = await cell.StateOf(name);

        // Two seconds are left for looking what the machine holds: one that answers slowly then keeps its slot taken,
        // as one that does not answer does.
        Assert.Contains(state, forGood ? ["uploading"] : new[] { "approved", "uploading" });
        Assert.Equal(
            FireFiles.OriginalSha256, FireFiles.Hash(await File.ReadAllBytesAsync(program, TestContext.Current.CancellationToken)));
        if (state == "approved")
        {
            var shown = await ConsoleRun.Of(cell.Folder, "cell", "show", cell.Configuration, "1", "--json");
            Assert.Equal(
                "given back: the cell was stopped",
                shown.Json.GetProperty("steps").EnumerateArray().Last().GetProperty("basis").GetString());
        }

        hang.IsOver = true;
        cell.Start();
        await cell.Until(async () => await cell.StateOf(name) == "verified", Patience, "the next start goes on");
        Assert.Equal(
            name, files.FileByProgram[FireFiles.Hash(await File.ReadAllBytesAsync(program, TestContext.Current.CancellationToken))]);
        await cell.Stop();
        Assert.DoesNotContain(Directory.EnumerateFiles(ftp.Folder), f => Path.GetFileName(f) != FireCell.ProgramOf(cell.Slots[0]));
        await cell.AuditHolds();
    }
}
