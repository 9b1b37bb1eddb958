using System.Data.Common;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Looks whether the contents that a store says are in archives are there. Of an archive that is absent, it claims
/// nothing.</summary>
/// <param name="folder">The folder of the archives; null if there is none.</param>
internal sealed class CheckedArchives(string? folder)
{
    private readonly List<ArchiveFinding> _found = [];

    /// <summary>The archives that rows of the store refer to, by name.</summary>
    public IReadOnlyList<ArchiveFinding> Found => _found;

    /// <summary>The first fault; null if there is none.</summary>
    public AuditFault? Fault(
        DbConnection connection, DbTransaction transaction, IProgress<CellProgress>? progress, CancellationToken cancellation)
    {
        var recorded = RecordedArchives.Of(connection, transaction);
        var named = Rows.Query(
            connection,
            $"SELECT COALESCE(source, ''), count(*), min(sha256) FROM content WHERE form = '{PackedContent.Archive}' GROUP BY source "
                + "ORDER BY source",
            r => (Name: r.GetString(0), Count: r.GetInt64(1), First: r.GetString(2)),
            null,
            transaction);
        foreach (var (name, count, first) in named)
        {
            cancellation.ThrowIfCancellationRequested();
            progress?.Report(new("looking at archives", _found.Count, named.Count));

            // A row that only says so has lost its content.
            if (!ContentArchive.IsName(name) || count > recorded.GetValueOrDefault(name))
            {
                return new(AuditFaultKind.RowDiffers, 0, RecordedThinning.Unrecorded.With(first, name));
            }

            var isThere = ContentArchive.IsThere(folder, name);
            _found.Add(new(name, isThere, count));
            if (isThere && Fault(connection, transaction, name, cancellation) is { } fault) return fault;
        }

        return null;
    }

    // Both are read once, in the order of the hashes.
    private AuditFault? Fault(DbConnection connection, DbTransaction transaction, string name, CancellationToken cancellation)
    {
        try
        {
            using var archive = ContentArchive.Open(folder, name);
            using var there = archive.All().GetEnumerator();
            var isLeft = there.MoveNext();
            foreach (var (sha256, length) in Rows.Stream(
                connection,
                $"SELECT sha256, length FROM content WHERE form = '{PackedContent.Archive}' AND source = @name ORDER BY sha256",
                r => (Sha256: r.GetString(0), Length: r.IsDBNull(1) ? (long?)null : r.GetInt64(1)),
                [("name", name)],
                transaction))
            {
                cancellation.ThrowIfCancellationRequested();
                while (isLeft && string.CompareOrdinal(there.Current.Sha256, sha256) < 0) isLeft = there.MoveNext();
                if (!isLeft || there.Current.Sha256 != sha256
                    || ContentArchive.PlainOf(there.Current.Content, length) is not { } plain || ContentHash.Sha256(plain) != sha256)
                {
                    return new(AuditFaultKind.RowDiffers, 0, RecordedThinning.Lacks.With(sha256, name));
                }
            }

            return null;
        }
        catch (StoreException e) when (e.Error is StoreError.Damaged or StoreError.Denied or StoreError.Archived)
        {
            return new(AuditFaultKind.RowDiffers, 0, RecordedThinning.Unusable.With(name, e.Message));
        }
    }
}

/// <summary>An archive that a store refers to.</summary>
/// <param name="Name">Its file name.</param>
/// <param name="IsThere">True if it is in its folder; then each of its contents had its hash.</param>
/// <param name="Contents">Number of contents that the store says are in it.</param>
public sealed record ArchiveFinding(string Name, bool IsThere, long Contents);
