using System.Diagnostics;

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
        var sender = new ProgramSender(Open());
        Assert.Equal([1, 2, 3], await sender.CurrentAsync("P1.MPF", Token));
        await sender.SendAsync("P1.MPF", new byte[] { 4, 5 }, "7", Token);
        Assert.Equal([4, 5], File.ReadAllBytes(Path.Combine(_folder, "P1.MPF")));
        Assert.Equal([4, 5], await sender.CurrentAsync("P1.MPF", Token));
        Assert.Single(Directory.GetFileSystemEntries(_folder));
    }

    [Fact]
    public async Task A_program_that_is_not_there_is_none() => Assert.Null(await new ProgramSender(Open()).CurrentAsync("P1.MPF", Token));

    [Fact]
    public async Task An_empty_program_is_a_program()
    {
        await new ProgramSender(Open()).SendAsync("P1.MPF", ReadOnlyMemory<byte>.Empty, "7", Token);
        Assert.Equal(Array.Empty<byte>(), await new ProgramSender(Open()).CurrentAsync("P1.MPF", Token));
    }

    [Fact]
    public async Task What_was_left_over_is_removed()
    {
        File.WriteAllBytes(Path.Combine(_folder, "P1.MPF.7-01234567.emnew"), [1]);
        File.WriteAllBytes(Path.Combine(_folder, "P1.MPF.emold"), [2]);
        await new ProgramSender(Open()).RecoverAsync("P1.MPF", Token);
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
        Assert.Equal(TransportError.Denied, (await Assert.ThrowsAsync<TransportException>(() => folder.WriteAsync(name, new byte[] { 1 }, Token))).Error);
        Assert.Equal(TransportError.Denied, (await Assert.ThrowsAsync<TransportException>(() => folder.RenameAsync("P1.MPF", name, 10, Token))).Error);
        Assert.Equal(TransportError.Denied, (await Assert.ThrowsAsync<TransportException>(() => folder.DeleteAsync(name, Token))).Error);
    }

    [Fact]
    public async Task A_file_larger_than_what_is_read_is_refused_by_its_length()
    {
        File.WriteAllBytes(Path.Combine(_folder, "log.txt"), new byte[11]);
        Assert.Equal(TransportError.TooLarge, (await Assert.ThrowsAsync<TransportException>(() => Open().ReadAsync("log.txt", 10, Token))).Error);
        Assert.Equal(11, (await Open().ReadAsync("log.txt", 11, Token))!.Length);
    }

    [Fact]
    public async Task A_name_that_a_folder_has_is_denied_with_what_to_do()
    {
        Directory.CreateDirectory(Path.Combine(_folder, "P1.MPF"));
        var failure = await Assert.ThrowsAsync<TransportException>(() => new ProgramSender(Open()).SendAsync("P1.MPF", new byte[] { 1 }, "7", Token));
        Assert.NotEqual(TransportError.Away, failure.Error);
        Assert.Equal(["P1.MPF"], Directory.EnumerateFileSystemEntries(_folder).Select(f => Path.GetFileName(f)!));
    }

    [Fact]
    public async Task A_full_disk_is_named()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "/dev/full is Linux's.");
        File.CreateSymbolicLink(Path.Combine(_folder, "full"), "/dev/full");
        Assert.Equal(TransportError.Full, (await Assert.ThrowsAsync<TransportException>(() => Open().WriteAsync("full", new byte[] { 1 }, Token))).Error);
    }

    [Fact]
    public async Task A_share_that_hangs_is_given_up_after_the_time_limit()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "A pipe without a writer is Linux's.");
        var pipe = await Pipe();
        var folder = MachineFolders.Open(Settings() with { Timeout = TimeSpan.FromMilliseconds(200) }, () => null);
        Assert.Equal(TransportError.Slow, (await Assert.ThrowsAsync<TransportException>(() => folder.ReadAsync("hangs", 10, Token))).Error);

        // Lets the thread that hangs come back.
        await using var end = new FileStream(pipe, FileMode.Open, FileAccess.ReadWrite);
    }

    [Fact]
    public async Task A_share_that_hangs_is_asked_again_only_when_the_access_that_hangs_has_ended()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "A pipe without a writer is Linux's.");
        var pipe = await Pipe();
        var folder = MachineFolders.Open(Settings() with { Timeout = TimeSpan.FromMilliseconds(200) }, () => null);
        await Assert.ThrowsAsync<TransportException>(() => folder.ReadAsync("hangs", 10, Token));
        var refused = await Assert.ThrowsAsync<TransportException>(() => folder.DeleteAsync("hangs", Token));
        Assert.Equal(TransportError.Slow, refused.Error);
        Assert.Contains("an earlier access still hangs", refused.Message, StringComparison.Ordinal);
        Assert.True(File.Exists(pipe));

        await using var end = new FileStream(pipe, FileMode.Open, FileAccess.ReadWrite);
        var began = Stopwatch.GetTimestamp();
        while (await Record.ExceptionAsync(() => folder.DeleteAsync("hangs", Token)) is { } failure)
        {
            Assert.True(Stopwatch.GetElapsedTime(began) < TimeSpan.FromMinutes(2), failure.Message);
            await Task.Delay(10, Token);
        }

        Assert.False(File.Exists(pipe));
    }

    private async Task<string> Pipe()
    {
        var pipe = Path.Combine(_folder, "hangs");
        using var made = Process.Start("mkfifo", [pipe]);
        await made.WaitForExitAsync(Token);
        return pipe;
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
