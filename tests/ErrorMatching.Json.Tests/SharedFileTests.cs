using ErrorMatching.Testing;

namespace ErrorMatching.Json.Tests;

public sealed class SharedFileTests
{
    private const int SharingViolation = unchecked((int)0x80070020);

    [Theory]
    [InlineData(0)]
    [InlineData(3)]
    [InlineData(10)]
    public void What_fails_in_passing_is_done_in_the_end(int failures)
    {
        var (done, pauses) = (0, new List<double>());
        var result = SharedFile.Patiently(
            () => done++ < failures ? throw Failure(done) : "done", SharedFile.PassesOnWindows, p => pauses.Add(p.TotalMilliseconds));
        Assert.Equal("done", result);
        Assert.Equal(failures + 1, done);
        Assert.Equal(Enumerable.Range(0, failures).Select(i => Math.Pow(2, i)), pauses);

        static Exception Failure(int number) =>
            number % 2 == 0 ? new UnauthorizedAccessException() : new IOException("in use", SharingViolation);
    }

    [Fact]
    public void What_fails_for_a_second_has_failed()
    {
        var waited = TimeSpan.Zero;
        Assert.Throws<UnauthorizedAccessException>(() => SharedFile.Patiently<bool>(
            () => throw new UnauthorizedAccessException(), SharedFile.PassesOnWindows, p => waited += p));
        Assert.Equal(1.023, waited.TotalSeconds, 1e-9);
    }

    [Theory]
    [InlineData(unchecked((int)0x80070070))]
    [InlineData(unchecked((int)0x80070002))]
    [InlineData(unchecked((int)0x800700B7))]
    public void A_full_disk_a_missing_file_and_a_taken_name_are_final(int error)
    {
        var tries = 0;
        Assert.Throws<IOException>(() => SharedFile.Patiently<bool>(
            () =>
            {
                tries++;
                throw new IOException("final", error);
            },
            SharedFile.PassesOnWindows,
            _ => Assert.Fail("It waits.")));
        Assert.Equal(1, tries);
    }

    [Fact]
    public void A_file_can_be_replaced_and_deleted_while_it_is_read()
    {
        using var folder = new TemporaryFolder();
        var file = folder.File("a.txt", "before");
        using var reading = new StreamReader(SharedFile.OpenRead(file));
        SharedFile.Replace(folder.File("b.txt", "after"), file);
        Assert.Equal("after"u8, SharedFile.ReadAllBytes(file));
        SharedFile.Delete(file);
        SharedFile.Delete(file);
        Assert.Equal("before", reading.ReadToEnd());
        Assert.Empty(Directory.EnumerateFiles(folder.Path));
    }

    [Fact]
    public void A_file_that_is_being_written_is_not_read_in_part()
    {
        using var folder = new TemporaryFolder();
        using var writing = new FileStream(folder["a.txt"], FileMode.Create, FileAccess.Write, FileShare.None);
        Assert.Throws<IOException>(() => SharedFile.OpenRead(folder["a.txt"]));
    }

    [Fact]
    public void Names_that_are_taken_stay()
    {
        using var folder = new TemporaryFolder();
        var (one, other) = (folder.File("a.txt", "a"), folder.File("b.txt", "b"));
        Assert.Throws<IOException>(() => SharedFile.Rename(one, other));
        SharedFile.Rename(one, folder["c.txt"]);
        Assert.Equal(["b.txt", "c.txt"], Directory.EnumerateFiles(folder.Path).Select(f => Path.GetFileName(f)).Order());
        Assert.Equal("b"u8, SharedFile.ReadAllBytes(other));

        Directory.CreateDirectory(folder["one"]);
        Directory.CreateDirectory(folder["other"]);
        Assert.Throws<IOException>(() => SharedFile.RenameFolder(folder["one"], folder["other"]));
        SharedFile.RenameFolder(folder["one"], folder["third"]);
        Assert.True(Directory.Exists(folder["third"]));
    }

    [Fact]
    public void A_file_without_a_length_is_read_whole()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Only Linux has such files.");
        Assert.NotEmpty(SharedFile.ReadAllBytes("/proc/self/status"));
    }

    // As a shell makes one of "--program <(...)".
    [Fact]
    public async Task A_pipe_is_read_to_its_end_and_not_beyond_a_limit()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Windows has no pipes in folders.");
        using var folder = new TemporaryFolder();
        var pipe = folder["pipe"];
        using (var make = System.Diagnostics.Process.Start("mkfifo", pipe))
        {
            await make.WaitForExitAsync(TestContext.Current.CancellationToken);
            Assert.Equal(0, make.ExitCode);
        }

        // More than a pipe holds at once.
        byte[] sent = [.. Enumerable.Range(0, 200_000).Select(i => (byte)i)];
        Assert.Equal(sent, await Through(SharedFile.ReadAllBytes));
        Assert.Equal(sent, await Through(path => SharedFile.ReadAllBytes(path, sent.Length)));
        await Assert.ThrowsAsync<IOException>(() => Through(path => SharedFile.ReadAllBytes(path, sent.Length - 1)));

        async Task<byte[]> Through(Func<string, byte[]> read)
        {
            var writing = Task.Run(() =>
            {
                try
                {
                    File.WriteAllBytes(pipe, sent);
                }
                catch (IOException)
                {
                    // A reader that stops early closes the pipe. The test looks at what it read until then.
                }
            });
            try
            {
                return await Task.Run(() => read(pipe));
            }
            finally
            {
                await writing;
            }
        }
    }
}
