using System.Diagnostics;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A cell whose store, keys and logs are on a small disk of their own:
/// a file system in memory, which takes root to mount.</summary>
public sealed class FullDiskTests
{
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(2);

    [Fact]
    public async Task A_cell_on_a_full_disk_says_so_loses_nothing_and_goes_on_when_there_is_room()
    {
        using var cell = new FireCell(slots: 2, store: """{ "kind": "sqlite", "file": "small/cell.db" }""", keys: "small/keys");
        using var disk = new SmallDisk(cell["small"]);
        MoveLogs(cell, "small/logs");
        var files = new FireFiles();
        var (first, second) = (files.Next(cell.Slots[0], 1), files.Next(cell.Slots[1], 2));
        cell.Start();
        cell.Drop(first.Name, first.Bytes);
        await cell.Until(async () => await cell.StateOf(first.Name) == "verified", Patience, "the first is at the machine");

        disk.Fill();
        cell.Drop(second.Name, second.Bytes);
        await cell.Until(async () => (await cell.Status()).Codes.Contains("store-full"), Patience, "the trouble is named");
        var (exit, isRunning, codes) = await cell.Status();
        Assert.True(isRunning, "A cell that has no room for its sign of life was taken for dead.");
        Assert.Equal(3, exit);
        Assert.Contains("store-full", codes);
        Assert.Contains("store-full", cell.Said, StringComparison.Ordinal);
        Assert.Contains(
            Directory.EnumerateFiles(cell.Incoming, "*", SearchOption.AllDirectories),
            f => File.ReadAllBytes(f).AsSpan().SequenceEqual(second.Bytes));
        Assert.Equal("verified", await cell.StateOf(first.Name));

        disk.Empty();
        await cell.Until(async () => await cell.StateOf(second.Name) == "verified", Patience, "the second is at the machine");
        await cell.Until(async () => (await cell.Status()).Exit == 0, Patience, "nothing is said any more");
        Assert.Equal(
            second.Name,
            files.FileByProgram[
                FireFiles.Hash(
                    await File.ReadAllBytesAsync(
                        Path.Combine(cell.Machine, FireCell.ProgramOf(cell.Slots[1])), TestContext.Current.CancellationToken))]);
        await cell.AuditHolds();
        await cell.Stop();
    }

    [Fact]
    public async Task A_cell_on_a_read_only_disk_says_so_and_goes_on_when_it_can_be_written()
    {
        using var cell = new FireCell(slots: 1, store: """{ "kind": "sqlite", "file": "small/cell.db" }""", keys: "keys");
        using var disk = new SmallDisk(cell["small"]);
        var files = new FireFiles();
        var first = files.Next(cell.Slots[0], 1);
        cell.Start();
        await cell.Until(async () => (await cell.Status()).Exit == 0, Patience, "it runs");
        await cell.Stop();

        disk.Remount("ro");
        cell.Drop(first.Name, first.Bytes);
        var run = await ConsoleRun.Of(cell.Folder, "cell", "run", cell.Configuration, "--json");
        Assert.Equal((3, "store-read-only"), (run.Exit, run.SingleError.GetProperty("code").GetString()));
        var (exit, _, codes) = await cell.Status();

        // The store can be read, so the status answers: nothing is wrong with it but that no cell runs.
        Assert.Equal((3, "cell-not-running"), (exit, Assert.Single(codes)));
        Assert.Equal(
            first.Bytes, await File.ReadAllBytesAsync(Path.Combine(cell.Incoming, first.Name), TestContext.Current.CancellationToken));

        disk.Remount("rw");
        cell.Start();
        await cell.Until(async () => await cell.StateOf(first.Name) == "verified", Patience, "it goes on");
        await cell.Stop();
    }

    private static void MoveLogs(FireCell cell, string folder) =>
        File.WriteAllText(
            cell.Configuration,
            File.ReadAllText(cell.Configuration).Replace("\"keys\":", $"\"logs\": \"{folder}\", \"keys\":", StringComparison.Ordinal));

    private sealed class SmallDisk : IDisposable
    {
        private readonly string _folder;

        public SmallDisk(string folder)
        {
            _folder = folder;
            Directory.CreateDirectory(folder);
            Assert.SkipUnless(
                OperatingSystem.IsLinux() && Run("mount", "-t", "tmpfs", "-o", "size=2m,mode=0700", "errormatch-test", folder) == 0,
                "A file system in memory cannot be mounted here; that takes root.");
        }

        private string Ballast => Path.Combine(_folder, "ballast");

        public void Fill()
        {
            var piece = new byte[4096];
            using var file = new FileStream(Ballast, FileMode.Create, FileAccess.Write, FileShare.None, bufferSize: 0);
            Assert.Throws<IOException>(Write);

            void Write()
            {
                while (true)
                {
                    file.Write(piece);
                }
            }
        }

        public void Empty() => File.Delete(Ballast);

        public void Remount(string how) => Assert.Equal(0, Run("mount", "-o", "remount," + how, _folder));

        public void Dispose()
        {
            // Lazily: a process that a failed test left may still have files open.
            Run("umount", "--lazy", _folder);
        }

        private static int Run(string program, params string[] words)
        {
            var start = new ProcessStartInfo(program, words)
            {
                UseShellExecute = false,
                RedirectStandardError = true,
                RedirectStandardOutput = true
            };
            using var process = Process.Start(start)!;
            process.StandardError.ReadToEnd();
            process.WaitForExit();
            return process.ExitCode;
        }
    }
}
