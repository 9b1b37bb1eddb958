using System.Text;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>Contents that are moved to archives, and what still reads them.</summary>
/// <param name="kind">The kind of store.</param>
public abstract class StoreThinTests(StoreKind kind) : StoreTest(kind)
{
    private readonly TemporaryFolder _folder = new();

    private StoreSettings WithArchives => Settings with { Archives = _folder["archives"] };

    [Fact]
    public void Contents_of_old_corrections_move_to_an_archive_and_are_read_there()
    {
        using var store = Filled(5);
        var all = Hashes(store);
        var policy = new ThinPolicy(Clock.GetUtcNow().AddDays(-365), 2);

        // Three of them are old and not among the last two of the slot. Each has a file and a program of its own.
        var rehearsed = store.Thin(policy, null, null, CancellationToken.None);
        Assert.Equal((6L, 0), (rehearsed.Contents, rehearsed.Archives.Count));
        Assert.False(Directory.Exists(_folder["archives"]));
        var thinned = store.Thin(policy, "os:test", null, CancellationToken.None);
        Assert.Equal((rehearsed.Contents, rehearsed.Bytes), (thinned.Contents, thinned.Bytes));
        var name = Assert.Single(thinned.Archives);
        Assert.Equal([name], Directory.EnumerateFiles(_folder["archives"]).Select(Path.GetFileName));
        Assert.Equal(6, Archived(store));
        Assert.All(all, c => Assert.Equal(c.Value, Encoding.UTF8.GetString(store.Content(c.Key))));
        Assert.All(all, c => Assert.True(store.Keeps(c.Key)));
        var entry = store.AuditEntries(0, 999)[^1];
        Assert.Equal(("os:test", "thinned", $"archive {name}"), (entry.Who, entry.What, entry.Subject!.Sentence));
        Assert.Contains(ArchiveWriter.HashOf(_folder["archives/" + name]), entry.Basis.Sentence, StringComparison.Ordinal);

        // Nothing is left to move, and what comes again returns to the store.
        Assert.Equal(0, store.Thin(policy, "os:test", null, CancellationToken.None).Contents);
        var again = store.Archive(Arrival("again", "piece 0"));
        Assert.True(again.IsNew);
        Assert.Equal(5, Archived(store));
    }

    [Fact]
    public void An_absent_archive_is_named_by_whoever_needs_it()
    {
        using var store = Filled(5);
        var name = store.Thin(new(Clock.GetUtcNow().AddDays(-365), 2), "os:test", null, CancellationToken.None).Archives[0];
        File.Move(_folder["archives/" + name], _folder["elsewhere"]);
        var missing = Assert.Throws<StoreException>(() => store.Content(Hash("piece 0")));
        Assert.Equal(StoreError.Archived, missing.Error);
        Assert.Contains(name, missing.Message, StringComparison.Ordinal);

        // Nothing is deleted at a machine that is stored nowhere else.
        Assert.False(store.Keeps(Hash("O0")));
        File.Move(_folder["elsewhere"], _folder["archives/" + name]);
        Assert.Equal("piece 0", Encoding.UTF8.GetString(store.Content(Hash("piece 0"))));
    }

    // A person who decides, a slot and a job that goes on need theirs, whatever their age.
    [Fact]
    public void What_is_needed_stays()
    {
        using var store = Open();
        var archived = store.Archive(Arrival("archived", "archived")).Correction;
        var released = Release(store, "first", "O first");
        Release(store, "second", "O second");
        var proposed = Approve(store, "third", "O third");
        Clock.Now += TimeSpan.FromDays(800);
        using var thin = CellStore.Open(WithArchives, Clock);
        var thinned = thin.Thin(new(Clock.GetUtcNow().AddDays(-365), 1), "os:test", null, CancellationToken.None);

        // The slot has the second program and had the first before; the third waits. Of the first, the file alone is not needed.
        Assert.Equal(1, thinned.Contents);
        Assert.Equal(["first"], ArchivedOf(thin).Select(h => Encoding.UTF8.GetString(thin.Content(h))));
        Assert.NotNull(released.ProgramSha256);
        Assert.All([archived, proposed], c => Assert.NotNull(thin.Find(c.Id)));
    }

    // Each step of it is the last one of a process; the next one goes on.
    [Fact]
    public void Whenever_the_process_ends_every_content_is_in_the_store_or_in_an_archive_that_it_names()
    {
        using var store = Filled(0);
        var steps = new List<string>();
        for (var (end, isOver) = (0, false); !isOver; end++)
        {
            Release(store, FormattableString.Invariant($"{end} a"), FormattableString.Invariant($"O{end} a"));
            Release(store, FormattableString.Invariant($"{end} b"), FormattableString.Invariant($"O{end} b"));
            Clock.Now += TimeSpan.FromDays(730);
            var (all, before) = (Hashes(store), Archived(store));
            var policy = new ThinPolicy(Clock.GetUtcNow().AddDays(-365), 1);
            steps.Clear();
            try
            {
                store.Thin(policy, "os:test", Step, null, CancellationToken.None);
                isOver = true;
            }
            catch (OperationCanceledException)
            {
                Assert.Contains(Archived(store) - before, steps[^1] == "recorded" ? [2, 4] : new[] { 0 });
            }

            AssertWhole(all);
            store.Thin(policy, "os:test", null, CancellationToken.None);
            AssertWhole(all);

            // The last of the slot stays, with its program and the one before.
            Assert.Equal((4 * (end + 1)) - 3, Archived(store));

            // What had its name already was used, and nothing unfinished is left.
            var there = Directory.EnumerateFiles(_folder["archives"]).Select(f => Path.GetFileName(f)).ToArray();
            Assert.Equal(end + 1, there.Length);
            Assert.All(there, n => Assert.True(ContentArchive.IsName(n)));
            Assert.Equal(end + 1, store.AuditEntries(0, 9999).Count(e => e.What == "thinned"));

            void Step(string name)
            {
                steps.Add(name);
                if (steps.Count > end) throw new OperationCanceledException(name);
            }
        }

        Assert.Equal(["folder", "written", "flushed", "compared", "named", "changing", "before commit", "recorded"], steps);

        void AssertWhole(Dictionary<string, string> all)
        {
            Assert.All(all, c => Assert.Equal(c.Value, Encoding.UTF8.GetString(store.Content(c.Key))));
            Assert.Null(store.VerifyAudit());
        }
    }

    [Fact]
    public void An_archive_that_somebody_changed_is_not_believed()
    {
        using var store = Filled(5);
        var hash = Hash("piece 0");
        var name = store.Thin(new(Clock.GetUtcNow().AddDays(-365), 2), "os:test", null, CancellationToken.None).Archives[0];
        var file = _folder["archives/" + name];
        var bytes = File.ReadAllBytes(file);
        foreach (var (what, other) in new (string, byte[])[]
        {
            ("cut off", bytes[..(bytes.Length / 2)]), ("empty", []), ("text", "not a database"u8.ToArray()),
            ("another content", Changed(bytes, "piece 0"u8.ToArray())),
        })
        {
            File.WriteAllBytes(file, other);
            Assert.True(StoreError.Damaged == Error(), what);
        }

        File.Delete(file);
        File.WriteAllBytes(_folder["target"], bytes);
        File.CreateSymbolicLink(file, _folder["target"]);
        Assert.Equal(StoreError.Denied, Error());

        StoreError Error() => Assert.Throws<StoreException>(() => store.Content(hash)).Error;
    }

    private static byte[] Changed(byte[] bytes, byte[] text)
    {
        var at = bytes.AsSpan().IndexOf(text);
        Assert.True(at > 0);
        byte[] changed = [.. bytes];
        changed[at] ^= 1;
        return changed;
    }

    // Released corrections, all but the last two of them two years old.
    private CellStore Filled(int count)
    {
        using (var store = Open())
        {
            for (var i = 0; i < count; i++)
            {
                if (i == count - 2) Clock.Now += TimeSpan.FromDays(730);
                Release(store, FormattableString.Invariant($"piece {i}"), FormattableString.Invariant($"O{i}"));
            }
        }

        return CellStore.Open(WithArchives, Clock);
    }

    private static Dictionary<string, string> Hashes(CellStore store) => store.Search(new() { Most = 999 })
        .SelectMany(c => new[] { c.MeasurementSha256, c.ProgramSha256! })
        .ToDictionary(h => h, h => Encoding.UTF8.GetString(store.Content(h)), StringComparer.Ordinal);

    private static int Archived(CellStore store) => ArchivedOf(store).Count;

    private static IReadOnlyList<string> ArchivedOf(CellStore store) =>
        store.Read("SELECT sha256 FROM content WHERE form = 'archive'", r => r.GetString(0));

    protected override void Dispose(bool disposing)
    {
        base.Dispose(disposing);
        _folder.Dispose();
    }
}
