using System.Diagnostics;
using System.Security.Cryptography;

namespace ErrorMatching.Cell.Tests;

public sealed class FolderTransportTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-test-").FullName;

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    public void Dispose()
    {
        if (Directory.Exists(_folder))
            Directory.Delete(_folder, recursive: true);
    }

    [Fact]
    public async Task A_program_replaces_the_one_that_was_there()
    {
        File.WriteAllBytes(Path.Combine(_folder, "P1.MPF"), [1, 2, 3]);
        var sender = new ProgramSender(Open(), _ => true);
        Assert.Equal([1, 2, 3], await sender.CurrentAsync("P1.MPF", Token));
        await sender.SendAsync("P1.MPF", Convert.ToHexStringLower(SHA256.HashData([1, 2, 3])), new byte[] { 4, 5 }, "7", Token);
        Assert.Equal([4, 5], File.ReadAllBytes(Path.Combine(_folder, "P1.MPF")));
        Assert.Equal([4, 5], await sender.CurrentAsync("P1.MPF", Token));
        Assert.Single(Directory.GetFileSystemEntries(_folder));
    }

    [Fact]
    public async Task A_program_that_is_not_there_is_none() =>
        Assert.Null(await new ProgramSender(Open(), _ => true).CurrentAsync("P1.MPF", Token));

    [Fact]
    public async Task An_empty_program_is_a_program()
    {
        await new ProgramSender(Open(), _ => true).SendAsync("P1.MPF", null, ReadOnlyMemory<byte>.Empty, "7", Token);
        Assert.Equal(Array.Empty<byte>(), await new ProgramSender(Open(), _ => true).CurrentAsync("P1.MPF", Token));
    }

    [Fact]
    public async Task What_was_left_over_is_removed()
    {
        File.WriteAllBytes(Path.Combine(_folder, "P1.MPF.7-01234567.emnew"), [1]);
        File.WriteAllBytes(Path.Combine(_folder, "P1.MPF.emold"), [2]);
        await new ProgramSender(Open(), _ => true).RecoverAsync("P1.MPF", Token);
        Assert.Equal(["P1.MPF"], Directory.EnumerateFiles(_folder).Select(f => Path.GetFileName(f)!));
        Assert.Equal([2], File.ReadAllBytes(Path.Combine(_folder, "P1.MPF")));
    }

    [Fact]
    public async Task A_share_that_vanished_is_away_and_not_empty()
    {
        var folder = Open();
        Directory.Delete(_folder);
        var failures = new[]
        {
            await Assert.ThrowsAsync<TransportException>(() => folder.ListAsync(Token)),
            await Assert.ThrowsAsync<TransportException>(() => folder.ReadAsync("P1.MPF", 10, Token)),
            await Assert.ThrowsAsync<TransportException>(() => folder.WriteAsync("P1.MPF", new byte[] { 1 }, Token)),
            await Assert.ThrowsAsync<TransportException>(() => folder.RenameAsync("P1.MPF", "P2.MPF", 10, Token)),
            await Assert.ThrowsAsync<TransportException>(() => folder.DeleteAsync("P1.MPF", Token)),
        };
        Assert.All(failures, f => Assert.Equal(TransportError.Away, f.Error));
        Assert.All(failures, f => Assert.StartsWith("mill: ", f.Message));
        Assert.False(Directory.Exists(_folder));
    }

    [Theory]
    [InlineData("../P1.MPF")]
    [InlineData("..")]
    [InlineData("sub/P1.MPF")]
    [InlineData("/etc/passwd")]
    [InlineData("a\\b")]
    [InlineData("a\nb")]
    public async Task Nothing_outside_of_the_folder_is_reached(string name)
    {
        var folder = Open();
        Assert.Equal(TransportError.Denied, (await Assert.ThrowsAsync<TransportException>(() => folder.ReadAsync(name, 10, Token))).Error);
        Assert.Equal(
            TransportError.Denied,
            (await Assert.ThrowsAsync<TransportException>(() => folder.WriteAsync(name, new byte[] { 1 }, Token))).Error);
        Assert.Equal(
            TransportError.Denied,
            (await Assert.ThrowsAsync<TransportException>(() => folder.RenameAsync("P1.MPF", name, 10, Token))).Error);
        Assert.Equal(TransportError.Denied, (await Assert.ThrowsAsync<TransportException>(() => folder.DeleteAsync(name, Token))).Error);
    }

    [Fact]
    public async Task A_file_larger_than_what_is_read_is_refused_by_its_length()
    {
        File.WriteAllBytes(Path.Combine(_folder, "log.txt"), new byte[11]);
        Assert.Equal(
            TransportError.TooLarge, (await Assert.ThrowsAsync<TransportException>(() => Open().ReadAsync("log.txt", 10, Token))).Error);
        Assert.Equal(11, (await Open().ReadAsync("log.txt", 11, Token))!.Length);
    }

    [Fact]
    public async Task A_name_that_a_folder_has_is_denied_with_what_to_do()
    {
        Directory.CreateDirectory(Path.Combine(_folder, "P1.MPF"));
        var failure = await Assert.ThrowsAsync<TransportException>(() =>
            new ProgramSender(Open(), _ => true).SendAsync("P1.MPF", null, new byte[] { 1 }, "7", Token));
        Assert.NotEqual(TransportError.Away, failure.Error);
        Assert.Equal(["P1.MPF"], Directory.EnumerateFileSystemEntries(_folder).Select(f => Path.GetFileName(f)!));
    }

    [Fact]
    public async Task A_full_disk_is_named()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "/dev/full is Linux's.");
        File.CreateSymbolicLink(Path.Combine(_folder, "full"), "/dev/full");
        Assert.Equal(
            TransportError.Full,
            (await Assert.ThrowsAsync<TransportException>(() => Open().WriteAsync("full", new byte[] { 1 }, Token))).Error);
    }

    [Fact]
    public async Task A_share_that_hangs_is_given_up_after_the_time_limit_and_asked_again_only_when_the_access_that_hangs_has_ended()
    {
        File.WriteAllBytes(Path.Combine(_folder, "hangs"), [1]);
        using var hanging = new ManualResetEventSlim();
        var folder = new FolderTransport("mill", _folder, TimeSpan.FromMilliseconds(200)) { Doing = _ => hanging.Wait() };
        Assert.Equal(TransportError.Slow, (await Assert.ThrowsAsync<TransportException>(() => folder.ReadAsync("hangs", 10, Token))).Error);
        var refused = await Assert.ThrowsAsync<TransportException>(() => folder.DeleteAsync("hangs", Token));
        Assert.Equal(TransportError.Slow, refused.Error);
        Assert.Contains("an earlier access still hangs", refused.Message, StringComparison.Ordinal);
        Assert.True(File.Exists(Path.Combine(_folder, "hangs")));

        hanging.Set();
        var began = Stopwatch.GetTimestamp();
        while (await Record.ExceptionAsync(() => folder.DeleteAsync("hangs", Token)) is { } failure)
        {
            Assert.True(Stopwatch.GetElapsedTime(began) < TimeSpan.FromMinutes(2), failure.Message);
            await Task.Delay(10, Token);
        }

        Assert.False(File.Exists(Path.Combine(_folder, "hangs")));
    }

    // The machine's other slots are served over the same folder: nothing may wait there for a writer that never comes.
    [Theory]
    [InlineData("pipe")]
    [InlineData("link")]
    [InlineData("folder")]
    public async Task What_has_a_programs_name_and_is_no_plain_file_is_refused_and_keeps_nobody_waiting(string kind)
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Pipes with names in folders are those of Linux.");
        var path = Path.Combine(_folder, "P1.MPF");
        File.WriteAllBytes(Path.Combine(_folder, "P2.MPF"), [2]);
        switch (kind)
        {
            case "link":
                File.CreateSymbolicLink(path, Path.Combine(_folder, "P2.MPF"));
                break;
            case "pipe":
                await MakePipe(path);
                break;
            default:
                Directory.CreateDirectory(path);
                break;
        }

        var folder = MachineFolders.Open(Settings() with { Timeout = TimeSpan.FromSeconds(20) }, () => null);
        var refused = await Assert.ThrowsAsync<TransportException>(() => folder.ReadAsync("P1.MPF", 10, Token));
        Assert.Equal("machine-not-a-file", CellCodes.Of(refused.Error));
        Assert.False(refused.IsWorthAnotherTry);
        Assert.Contains(kind, refused.Message, StringComparison.Ordinal);
        Assert.Equal([2], await folder.ReadAsync("P2.MPF", 10, Token));
    }

    [Fact]
    public async Task What_takes_the_programs_place_at_the_last_moment_and_is_no_plain_file_keeps_it()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Names are exchanged on Linux.");
        File.WriteAllBytes(Path.Combine(_folder, "new"), [2]);
        await MakePipe(Path.Combine(_folder, "P1.MPF"));
        var refused = await Assert.ThrowsAsync<TransportException>(() => Open().ReplaceAsync("new", "P1.MPF", "P1.MPF.emold", 10, Token));
        Assert.Equal(TransportError.NotAFile, refused.Error);
        Assert.Equal([2], File.ReadAllBytes(Path.Combine(_folder, "P1.MPF.emold")));
        Assert.Contains("pipe", PlainFile.Defect(new FileInfo(Path.Combine(_folder, "P1.MPF"))), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_program_that_is_replaced_keeps_a_name_until_it_was_looked_at()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Names are exchanged on Linux.");
        string On(string name) => Path.Combine(_folder, name);
        File.WriteAllBytes(On("new"), [2]);
        var first = await Open().ReplaceAsync("new", "P1.MPF", "aside", 10, Token);
        Assert.Equal([2], first!.There);
        Assert.Null(first.Was);
        File.WriteAllBytes(On("new"), [3]);
        var second = await Open().ReplaceAsync("new", "P1.MPF", "aside", 10, Token);
        Assert.Equal([3], second!.There);
        Assert.Equal([2], second.Was);
        Assert.Equal(["P1.MPF", "aside"], Directory.EnumerateFiles(_folder).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal));
        var back = await Open().ReplaceAsync("aside", "P1.MPF", "aside", 10, Token);
        Assert.Equal([2], back!.There);
        Assert.Equal([3], File.ReadAllBytes(On("aside")));
    }

    // Else a power cut brings back the old program under a correction that is verified.
    [Fact]
    public async Task A_program_and_its_name_are_on_the_disk_before_it_is_sent()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Windows brings names onto the disk by itself.");
        File.WriteAllBytes(Path.Combine(_folder, "P1.MPF"), [1]);
        var done = new List<string>();
        var folder = new FolderTransport("mill", _folder, TimeSpan.FromMinutes(10))
        {
            Doing = what =>
            done.Add(what.Split(' ')[0] + (what.EndsWith(_folder, StringComparison.Ordinal) ? " names" : ""))
        };
        await new ProgramSender(folder, _ => true).SendAsync("P1.MPF", Convert.ToHexStringLower(SHA256.HashData([1])), new byte[] { 2 },
            "7", Token);
        Assert.Equal(["writing", "syncing", "reading", "replacing", "exchanging", "comparing", "syncing names", "deleting"], done);
        done.Clear();
        await folder.RenameAsync("P1.MPF", "P2.MPF", 10, Token);
        Assert.Equal(["renaming", "syncing names"], done);
    }

    private static async Task MakePipe(string path)
    {
        using var made = Process.Start("mkfifo", [path]);
        await made.WaitForExitAsync(Token);
    }

    private IMachineFolder Open() => MachineFolders.Open(Settings(), () => null);

    private MachineSettings Settings() => new()
    {
        Name = "mill",
        Transport = new FolderSettings(_folder),
        Dialect = "siemens-840d",
        Slots = [],
        Timeout = TimeSpan.FromMinutes(10),
        Attempts = 3,
    };
}
