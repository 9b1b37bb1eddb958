using System.Data.Common;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Looks whether every content of a store has its hash, and whether every content that a correction names is there.</summary>
internal sealed class CheckedContents
{
    private static readonly string[] Named = ["job_sha256", "base_sha256", "part_sha256", "program_sha256", "report_sha256", "page_sha256",
        "sums_sha256", "previous_sha256", "undo_sha256"];

    private long _count;
    private long _bytes;
    private long _pages;

    /// <summary>Contents whose bytes have their hash.</summary>
    public long Count => _count;

    /// <summary>Their length, uncompressed.</summary>
    public long Bytes => _bytes;

    /// <summary>Pages, which are drawn from their reports.</summary>
    public long Pages => _pages;

    /// <summary>The first fault; null if there is none.</summary>
    /// <param name="connection">The store.</param>
    /// <param name="transaction">One snapshot of it.</param>
    /// <param name="second">The same snapshot on another connection, for a second core.</param>
    /// <param name="progress">Receives progress; null for no reports.</param>
    /// <param name="cancellation">Cancels the check.</param>
    public AuditFault? Fault(
        DbConnection connection,
        DbTransaction transaction,
        DbTransaction second,
        IProgress<CellProgress>? progress,
        CancellationToken cancellation)
    {
        var missing = Task.Run(() => Missing(second.Connection!, second, cancellation), CancellationToken.None);
        AuditFault? damaged;
        try
        {
            var all = Rows.Query(connection, "SELECT count(*) FROM content", r => r.GetInt64(0), null, transaction)[0];
            damaged = Damaged(connection, transaction, all, progress, cancellation);
        }
        finally
        {
            missing.ContinueWith(_ => { }, CancellationToken.None, TaskContinuationOptions.None, TaskScheduler.Default).Wait(
                CancellationToken.None);
        }

        return missing.GetAwaiter().GetResult() ?? damaged;
    }

    private AuditFault? Damaged(
        DbConnection connection, DbTransaction transaction, long all, IProgress<CellProgress>? progress, CancellationToken cancellation)
    {
        string? first = null;
        var (done, each) = (0L, Math.Max(1, all / 100));
        Parallel.ForEach(
            ReadAhead.Of(Rows.Stream(
                connection,
                $"SELECT {ContentRow.Columns}, sha256 FROM content",
                r => (Packed: ContentRow.ReadOrNull(r), Sha256: r.GetString(5)),
                null,
                transaction)),
            new ParallelOptions { MaxDegreeOfParallelism = 2, CancellationToken = cancellation },
            content =>
            {
                if (Interlocked.Increment(ref done) % each == 0) progress?.Report(new("looking at contents", Volatile.Read(ref done), all));
                // Archives are looked at by themselves.
                if (content.Packed is { Form: PackedContent.Archive, Bytes.Length: 0 }) return;
                if (content.Packed is { Form: PackedContent.Page, Source: not null })
                {
                    Interlocked.Increment(ref _pages);
                    return;
                }

                if (content.Packed?.Plain() is { } plain && ContentHash.Sha256(plain) == content.Sha256)
                {
                    Interlocked.Increment(ref _count);
                    Interlocked.Add(ref _bytes, plain.Length);
                    return;
                }

                lock (Named)
                {
                    if (first is null || string.CompareOrdinal(content.Sha256, first) < 0) first = content.Sha256;
                }
            });
        return first is null ? null : new(AuditFaultKind.RowDiffers, 0, Recorded.ContentDiffers.With(first));
    }

    // The database's own references do not hold where somebody else wrote.
    private static AuditFault? Missing(DbConnection connection, DbTransaction transaction, CancellationToken cancellation)
    {
        foreach (var column in Named)
        {
            cancellation.ThrowIfCancellationRequested();
            if (Rows.Query(
                connection,
                $"SELECT id, {column} FROM correction WHERE {column} IS NOT NULL AND NOT EXISTS (SELECT 1 FROM content WHERE sha256 = "
                    + $"correction.{column}) ORDER BY id LIMIT 1",
                r => (Id: r.GetInt64(0), Sha256: r.GetString(1)),
                null,
                transaction) is [var (id, sha256)]) return new(AuditFaultKind.RowDiffers, 0, Recorded.ContentMissing.With(sha256, id));
        }

        return Rows.Query(
            connection,
            "SELECT page.sha256 FROM content AS page WHERE page.form = 'page' AND NOT EXISTS (SELECT 1 FROM content AS report WHERE "
                + "report.sha256 = page.source AND COALESCE(report.form, '') <> 'page') ORDER BY page.sha256 LIMIT 1",
            r => r.GetString(0),
            null,
            transaction) is [var page] ? new(AuditFaultKind.RowDiffers, 0, Recorded.ContentDiffers.With(page)) : null;
    }
}
