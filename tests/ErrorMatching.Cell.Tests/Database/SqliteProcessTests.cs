using System.Diagnostics;
using System.Globalization;

namespace ErrorMatching.Cell.Tests;

/// <summary>A store in a file beside other processes, and processes that end at any instant.</summary>
public sealed class SqliteProcessTests : IDisposable
{
    private const int Turns = 40;
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-store-").FullName;

    private string File => Path.Combine(_folder, "cell.db");

    [Fact]
    public void Whatever_was_acknowledged_is_there_after_a_process_was_killed_while_it_wrote()
    {
        var acknowledged = new Dictionary<long, int>();
        for (var kill = 0; kill < 8; kill++)
        {
            using var writer = StoreWriter.Start("write", File);
            for (var line = 0; line < 1 + 37 * kill % 90; line++)
            {
                Note(writer.Output.ReadLine());
            }

            writer.Kill();
            while (writer.Output.ReadLine() is { } rest) Note(rest);

            using var store = CellStore.Open(new SqliteSettings(File), TimeProvider.System);
            Assert.Null(store.VerifyAudit());
            Assert.All(acknowledged, a => Assert.True(store.Find(a.Key)!.Version >= a.Value));
            Assert.All(acknowledged, a => Assert.True(store.Corrections.StepsOf(a.Key).Count == store.Find(a.Key)!.Version));

            // Whatever is there beyond that is one step of which the answer did not come any more.
            var all = store.Search(new HistoryQuery { Most = int.MaxValue });
            Assert.InRange(all.Sum(c => c.Version) - acknowledged.Values.Sum(), 0, kill + 1);
            Assert.Equal(1 + all.Sum(c => c.Version), store.ChangeCount());
            Assert.All(all, c => store.Content(c.MeasurementSha256));
        }

        void Note(string? line)
        {
            // A line that the end of the process cut is no acknowledgment.
            if (line?.Split(' ') is [var id, { Length: 1 } version])
                acknowledged[long.Parse(id, CultureInfo.InvariantCulture)] = int.Parse(version, CultureInfo.InvariantCulture);
        }
    }

    [Fact]
    public void Two_processes_that_write_make_one_chain()
    {
        using var store = CellStore.Open(new SqliteSettings(File), TimeProvider.System);
        using var writer = StoreWriter.Start("take-turns", File);
        for (var i = 0; i < Turns; i++)
        {
            // Both write at the same time, and each goes on when both have.
            writer.Input.WriteLine($"turn {i}");
            writer.Input.Flush();
            store.Audit("anna", "signed-in", "password");
            Assert.NotNull(writer.Output.ReadLine());
        }

        writer.Input.Close();
        writer.WaitForExit();
        Assert.Equal(Turns, store.AuditEntries(0, int.MaxValue).Count(e => e.What == "signed-in"));
        Assert.Equal(Turns, store.Corrections.InState(CorrectionState.Archived).Count);
        Assert.Equal(1 + (2 * Turns), store.ChangeCount());
        Assert.Null(store.VerifyAudit());
    }

    [Fact]
    public void A_store_that_another_process_keeps_in_a_change_is_named_locked_and_is_still_read()
    {
        using var store = CellStore.Open(new SqliteSettings(File), TimeProvider.System);
        var correction = store.Archive(new Arrival("gauge", "one.csv", "one", "1"u8.ToArray())).Correction;
        using var holder = StoreWriter.Start("hold", File);
        Assert.Equal("held", holder.Output.ReadLine());
        Assert.Equal(
            StoreError.Locked,
            Assert.Throws<StoreException>(() => store.Step(correction, CorrectionState.Recognized, "cell", "by name")).Error);
        Assert.Equal(correction, store.Find(correction.Id));
        using (var beside = CellStore.Open(
            new SqliteSettings(File), TimeProvider.System, inspect: false)) Assert.Equal(correction, beside.Find(correction.Id));
        holder.Input.Close();
        holder.WaitForExit();
        store.Step(correction, CorrectionState.Recognized, "cell", "by name");
        Assert.Null(store.VerifyAudit());
    }

    [Fact]
    public void A_slot_of_a_process_that_was_killed_is_free()
    {
        using var store = CellStore.Open(new SqliteSettings(File), TimeProvider.System);
        using var holder = StoreWriter.Start("hold", File);
        Assert.Equal("held", holder.Output.ReadLine());
        Assert.Null(store.TryLockSlot("mill", "1"));
        holder.Kill();
        using var slot = store.TryLockSlot("mill", "1");
        Assert.True(slot!.IsHeld);
        store.Audit("anna", "signed-in", "password");
    }

    [Fact]
    public void A_disk_that_is_full_is_named_and_nothing_is_lost()
    {
        // Of 1400 KB, 200 are taken by a file that makes room later.
        string[] said =
        [
            "Full after some: True", "Make room, then repeat what failed; a running cell repeats it by itself.",
            "Make room on its disk, then repeat what failed.",
            "all there: True, chain: True", "all there: True, chain: True", "opened again, chain: True",
        ];
        Assert.Equal(said, OnDiskOfItsOwn("fill", "size=1400k"));
    }

    [Fact]
    public void A_disk_that_is_mounted_read_only_is_named_can_be_looked_at_and_nothing_is_lost() => Assert.Equal(
        ["ReadOnly", "read 2, whole: True, exported 2, changes: ReadOnly", "read 2, whole: True, exported 2, changes: ReadOnly", "kept 3"],
            OnDiskOfItsOwn("read-only", "size=4000k"));

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    // A file system in memory that only the other process sees, which Linux lets anybody have where it lets them have namespaces.
    private string[] OnDiskOfItsOwn(string task, string options)
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "A disk of its own is made by Linux's unshare and mount.");
        using var may = Process.Start("unshare", ["--mount", "--map-root-user", "mount", "-t", "tmpfs", "tmpfs", _folder]);
        may.WaitForExit();
        Assert.SkipUnless(may.ExitCode == 0, "This system lets nobody mount a disk of their own (unshare --mount --map-root-user).");

        using var other = StoreWriter.Start(
            task,
            File,
            "unshare",
            "--mount",
            "--map-root-user",
            "sh",
            "-c",
            $"mount -t tmpfs -o {options} tmpfs '{_folder}' && exec \"$0\"");
        var said = other.Output.ReadToEnd();
        other.WaitForExit();
        return said.Split('\n', StringSplitOptions.RemoveEmptyEntries);
    }
}
