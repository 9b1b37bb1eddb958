using System.Buffers;
using System.Globalization;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Moves contents that nothing needs any more to archives. An archive is complete, on disk, read again and has its name before
/// any row refers to it; then its rows change, and the audit trail names it, in one transaction. So whenever the process ends, each content
/// is in the store, or in an archive that the store names; the next run goes on.</summary>
/// <param name="database">The store.</param>
/// <param name="clock">Supplies the times of audit entries.</param>
/// <param name="auditKey">The key that seals the audit trail; null for none.</param>
internal sealed class Thinning(CellDatabase database, TimeProvider clock, byte[]? auditKey)
{
    // One archive and one change of the store: others wait for that one at most a second or two.
    private const int MostContents = 10_000;
    private const long MostBytes = 256L << 20;
    private const int RowsAtOnce = 500;
    private static readonly SearchValues<char> Digits = SearchValues.Create("0123456789abcdef");

    /// <summary>How much would be moved.</summary>
    public Thinned Rehearse(ThinPolicy policy)
    {
        var (movable, _) = MovableContents.Of(database, policy);
        return new(movable.Count, movable.Sum(m => m.Bytes), []);
    }

    /// <summary>Moves the contents.</summary>
    /// <param name="policy">Which.</param>
    /// <param name="by">The user's name.</param>
    /// <param name="at">Called behind each step, with its name.</param>
    /// <param name="progress">Receives progress; null for no reports.</param>
    /// <param name="cancellation">Ends the work between two archives.</param>
    /// <exception cref="StoreException">With <see cref="StoreError.NotSupported"/> if no folder is configured, with
    /// <see cref="StoreError.Locked"/> while another process thins the store, with <see cref="StoreError.Damaged"/> if a content is not
    /// what was kept.</exception>
    public Thinned Run(ThinPolicy policy, string by, Action<string> at, IProgress<CellProgress>? progress, CancellationToken cancellation)
    {
        var folder = database.ArchiveFolder ?? throw new StoreException(
            StoreError.NotSupported,
            "A store on PostgreSQL has no folder of its own for archives: name one as \"archives\" in \"store\", the same for all "
                + "computers that use the store.");
        using var only = database.TryLock("thin") ?? throw new StoreException(
            StoreError.Locked, $"{database.Place} is being thinned by another process. Nothing was changed.");
        ArchiveWriter.CleanUp(folder);
        progress?.Report(new("looking for contents that nothing needs", 0, 0));
        var (movable, lastStep) = MovableContents.Of(database, policy);
        var run = new Moving(policy, by, lastStep);
        var left = Adopted(folder, movable, run, at);
        for (var from = 0; from < left.Count;)
        {
            cancellation.ThrowIfCancellationRequested();
            progress?.Report(new("moving contents", from, left.Count));
            var (to, bytes) = (from, 0L);
            while (to < left.Count && to - from < MostContents && bytes < MostBytes) bytes += left[to++].Bytes;
            var contents = Contents([.. left.Skip(from).Take(to - from).Select(m => m.Sha256)]);
            foreach (var (sha256, content) in contents) DemandKept(sha256, content);
            var (name, hash) = ArchiveWriter.Write(folder, contents, at);
            Refer(name, hash, contents, run, at);
            from = to;
        }

        return new(run.Contents, run.Bytes, run.Archives);
    }

    // An archive that has its name, and that no entry names: the process ended in between. Only what equals the store's own rows is
    // believed.
    private IReadOnlyList<MovableContent> Adopted(
        string folder, IReadOnlyList<MovableContent> movable, Moving run, Action<string> at)
    {
        var recorded = database.Read(connection => RecordedArchives.Of(connection, null));
        var left = movable;
        foreach (var name in ContentArchive.In(folder).Where(n => !recorded.ContainsKey(n)))
        {
            var open = left.Select(m => (m.High, m.Low)).ToHashSet();
            var same = new List<(string Sha256, PackedContent Content)>();
            try
            {
                using var archive = ContentArchive.Open(folder, name);
                foreach (var some in archive.All().Where(
                    c => IsHash(c.Sha256) && MovableContent.Of(c.Sha256, 0) is var m && open.Contains((m.High, m.Low))).Chunk(RowsAtOnce))
                {
                    var own = Contents([.. some.Select(c => c.Sha256)]).ToDictionary(c => c.Sha256, c => c.Content, StringComparer.Ordinal);
                    same.AddRange(own.Where(o => some.First(c => c.Sha256 == o.Key).Content is { } there && IsSame(there, o.Value))
                        .Select(o => (o.Key, o.Value)));
                }
            }
            catch (StoreException e) when (e.Error is StoreError.Damaged or StoreError.Denied)
            {
                // Nothing refers to it, and everything is still in the store.
                continue;
            }

            if (same.Count == 0) continue;
            Refer(name, ArchiveWriter.HashOf(Path.Combine(folder, name)), same, run, at);
            var moved = same.Select(c => MovableContent.Of(c.Sha256, 0)).Select(m => (m.High, m.Low)).ToHashSet();
            left = [.. left.Where(m => !moved.Contains((m.High, m.Low)))];
        }

        return left;
    }

    private List<(string Sha256, PackedContent Content)> Contents(IReadOnlyList<string> hashes)
    {
        var found = new List<(string, PackedContent)>();
        foreach (var some in hashes.Chunk(RowsAtOnce))
        {
            found.AddRange(database.Read(connection => Rows.Query(
                connection,
                $"SELECT {ContentRow.Columns}, sha256 FROM content WHERE {IsOneOf(some)}",
                r => (r.GetString(5), ContentRow.Read(r)))).Where(c => c.Item2.Form is null or PackedContent.Brotli));
        }

        return found;
    }

    private void DemandKept(string sha256, PackedContent content)
    {
        if (content.Plain() is not { } plain || ContentHash.Sha256(plain) != sha256)
        {
            throw new StoreException(
                StoreError.Damaged, $"{database.Place} is damaged: content {sha256} is not what was kept. It is not moved. Restore the "
                    + "latest backup.");
        }
    }

    private void Refer(
        string name, string hash, IReadOnlyList<(string Sha256, PackedContent Content)> contents, Moving run, Action<string> at)
    {
        var (moved, bytes) = database.Write(clock, auditKey, transaction =>
        {
            var needed = MovableContents.NeededSince(transaction, run.LastStep);
            var (count, length) = (0L, 0L);
            foreach (var some in contents.Where(c => !needed.Contains(c.Sha256)).Chunk(RowsAtOnce))
            {
                count += transaction.Execute(
                    "UPDATE content SET length = COALESCE(length, length(bytes)), bytes = @empty, form = 'archive', source = @name, "
                        + $"made_by = NULL WHERE (form IS NULL OR form = 'brotli') AND {IsOneOf(some.Select(c => c.Sha256))}",
                    [("name", name), ("empty", Array.Empty<byte>())]);
                length += some.Sum(c => c.Content.Bytes.LongLength);
                at("changing");
            }

            if (count == 0) return (0L, 0L);
            transaction.Audit(
                run.By,
                RecordedThinning.Thinned,
                RecordedThinning.Archive.With(name),
                RecordedThinning.Moved.With(count, length, hash, run.Policy.Before, run.Policy.KeepLast));
            at("before commit");
            return (count, length);
        });
        at("recorded");
        if (moved > 0) run.Add(name, moved, bytes);
    }

    // Both engines take long lists best as they are; hashes have nothing that would have to be quoted.
    private static string IsOneOf(IEnumerable<string> hashes) => "sha256 IN (" + string.Join(
        ", ",
        hashes.Select(h => IsHash(h)
            ? $"'{h}'"
            : throw new ArgumentException(string.Create(CultureInfo.InvariantCulture, $"{h} is no hash."), nameof(hashes)))) + ")";

    private static bool IsHash(string text) => text.Length == 64 && !text.AsSpan().ContainsAnyExcept(Digits);

    private static bool IsSame(PackedContent one, PackedContent other) =>
        one.Form == other.Form && one.Length == other.Length && one.Bytes.AsSpan().SequenceEqual(other.Bytes);

    // One run, and what it has moved so far.
    private sealed class Moving(ThinPolicy policy, string by, long lastStep)
    {
        private readonly List<string> _archives = [];

        public ThinPolicy Policy => policy;

        public string By => by;

        public long LastStep => lastStep;

        public long Contents { get; private set; }

        public long Bytes { get; private set; }

        public IReadOnlyList<string> Archives => _archives;

        public void Add(string name, long contents, long bytes)
        {
            _archives.Add(name);
            (Contents, Bytes) = (Contents + contents, Bytes + bytes);
        }
    }
}

/// <summary>Which contents are moved to an archive.</summary>
/// <param name="Before">Corrections whose last step was before this time may lose their contents.</param>
/// <param name="KeepLast">Of each slot, this many of the latest corrections keep theirs, however old they are.</param>
public sealed record ThinPolicy(DateTimeOffset Before, int KeepLast);

/// <summary>What was moved, or would be.</summary>
/// <param name="Contents">Number of contents.</param>
/// <param name="Bytes">Their length as stored.</param>
/// <param name="Archives">Names of the archives, in the order in which they were recorded; none for a rehearsal.</param>
public sealed record Thinned(long Contents, long Bytes, IReadOnlyList<string> Archives);
