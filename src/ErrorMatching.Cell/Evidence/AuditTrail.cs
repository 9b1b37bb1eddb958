using System.Data.Common;
using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The audit trail of a store, for verification and export.</summary>
/// <param name="store">The store.</param>
/// <param name="keysFolder">The folder of the keys that sealed it. It is not created here.</param>
/// <param name="witnessFile">A second file that remembers the last seen end; null for none.</param>
/// <remarks>Failures of the store throw a <see cref="StoreException"/>, failures of the keys a <see cref="PeopleException"/>.</remarks>
public sealed class AuditTrail(CellStore store, string keysFolder, string? witnessFile = null)
{
    private readonly SecondWitness? _second = witnessFile is null ? null : new(witnessFile);

    private static readonly string[] Columns = ["number", "time", "who", "what", "subject", "basis", "previous", "hash", "rows",
        "subjectRecorded", "basisRecorded"];

    /// <summary>The audit trail of a cell's store.</summary>
    /// <param name="store">The store.</param>
    /// <param name="settings">The cell.</param>
    public AuditTrail(CellStore store, CellSettings settings)
        : this(store, (settings ?? throw new ArgumentNullException(nameof(settings))).KeysFolder, settings.WitnessFile)
    {
    }

    /// <summary>Checks every entry of one snapshot of the trail. An intact end is remembered next to the keys, if they exist.</summary>
    public AuditFinding Verify() => Verify(null, CancellationToken.None);

    /// <summary>Checks every entry of one snapshot of the trail and reports progress. An intact end is remembered next to the keys, if they
    /// exist.</summary>
    /// <param name="progress">Receives progress; null for no reports.</param>
    /// <param name="cancellation">Cancels the check.</param>
    public AuditFinding Verify(IProgress<CellProgress>? progress, CancellationToken cancellation)
    {
        var (key, witness, second) = (AuditKey.Find(keysFolder), AuditWitness.Find(keysFolder), _second?.Find());
        var finding = store.Database.TwoSnapshots((connection, transaction, rows) =>
        {
            var head = AuditRow.Head(connection, transaction, "");
            var count = Count(connection, transaction);
            var meaning = new RecordedMeaning(rows.Connection!, rows, key);
            var fault = AuditChain.Verify(
                Told(
                    Rows.Stream(connection, AuditRow.Select + " ORDER BY seq", AuditRow.ReadOrUnreadable, null, transaction),
                    "looking at entries",
                    count,
                    progress,
                    cancellation), head, key, meaning.Add);
            fault ??= KeysFault(key, witness, second, head, At) ?? meaning.Fault(store.Database);
            if (key is not null) fault ??= AuditCheckpoint.Fault(connection, transaction, key);
            var contents = new CheckedContents();
            fault ??= contents.Fault(connection, transaction, rows, progress, cancellation);
            var archives = new CheckedArchives(store.Database.ArchiveFolder);
            fault ??= archives.Fault(connection, transaction, progress, cancellation);
            return new AuditFinding(count, head.Hash, fault, key is not null)
            {
                Contents = contents.Count,
                ContentBytes = contents.Bytes,
                Pages = contents.Pages,
                Archives = archives.Found,
            };

            IReadOnlyList<AuditEntry> At(long seq) => Rows.Query(
                connection, AuditRow.Select + " WHERE seq = @seq", AuditRow.ReadOrUnreadable, [("seq", seq)], transaction);
        });
        if (finding.Holds && finding.Entries > (witness?.Seq ?? 0))
        {
            KeepIfPossible(new AuditWitness(finding.Entries, finding.Hash), witness);
        }

        return finding;
    }

    /// <summary>Checks keys and end of the trail without reading all of it. It finds missing keys, keys that did not seal the trail, and a
    /// trail that does not continue from the last seen entry, as in a store that was rolled back.</summary>
    /// <returns>The fault; null if there is none, or the store never had a key.</returns>
    public AuditFault? EndFault()
    {
        var (key, head) = (AuditKey.Find(keysFolder), store.AuditHead());
        return KeysFault(key, AuditWitness.Find(keysFolder), _second?.Find(), head, At, mayBeUnsealed: true)
            ?? (key is null || head.IsSealedBy(key) ? null : new(AuditFaultKind.Unsealed, head.Seq, string.Create(
                CultureInfo.InvariantCulture,
                $"The end of the audit trail, entry {head.Seq}, is not sealed by the cell's key: the store was written to by something "
                    + $"else, or the key is another one.")));

        IReadOnlyList<AuditEntry> At(long seq) => seq > 0 ? store.AuditEntries(seq - 1, 1) : [];
    }

    private AuditFault? KeysFault(
        byte[]? key,
        AuditWitness? witness,
        AuditWitness? second,
        AuditHead head,
        Func<long, IReadOnlyList<AuditEntry>> at,
        bool mayBeUnsealed = false) =>
        key is null ? mayBeUnsealed && head.Seal is null ? null : new(AuditFaultKind.KeysMissing, head.Seq, AuditKey.Missing(keysFolder))
        : witness is null ? new(AuditFaultKind.WitnessMissing, head.Seq, AuditWitness.Missing(keysFolder))
        : witness.Fault(head, at(witness.Seq), Path.Combine(keysFolder, AuditWitness.FileName))
            ?? (second is not null ? second.Fault(head, at(second.Seq), _second!.File)
            : _second is not null && witness.Second == _second.File ? new(AuditFaultKind.WitnessMissing, head.Seq, _second.Missing())
            : null);

    // The result is valid even if it cannot be saved on a read-only disk.
    private void KeepIfPossible(AuditWitness seen, AuditWitness? before)
    {
        try
        {
            if (before is not null) Keep(seen);
        }
        catch (PeopleException e) when (e.InnerException is IOException or UnauthorizedAccessException)
        {
        }
    }

    // The second file first: from then on, the first one says that it must be there.
    private void Keep(AuditWitness seen)
    {
        _second?.Keep(seen);
        (seen with { Second = _second?.File }).Keep(keysFolder);
    }

    /// <summary>Remembers the trail's end next to the keys and in the second file, after checking only that end. The more often this runs,
    /// the less can be cut off unnoticed. Does nothing if the end has a fault.</summary>
    /// <returns>The fault; null if there is none.</returns>
    public AuditFault? Remember()
    {
        var head = store.AuditHead();
        if (EndFault() is { } fault) return fault;
        if (AuditWitness.Find(keysFolder) is { } witness && (head.Seq > witness.Seq || witness.Second != _second?.File))
        {
            Keep(new AuditWitness(head.Seq, head.Hash));
        }

        return null;
    }

    /// <summary>Accepts the end of a store that was rolled back on purpose, such as by a restored backup, or whose last seen end is no
    /// longer known, and records that. Does nothing if the trail continues from the last seen entry, or if its end is not the sealed
    /// one.</summary>
    /// <param name="by">Who did it.</param>
    /// <param name="basis">What was done, or why.</param>
    /// <returns>True if it was accepted.</returns>
    public bool TakeOver(string by, Statement basis)
    {
        var (key, witness, second) = (AuditKey.Find(keysFolder), AuditWitness.Find(keysFolder), _second?.Find());
        var head = store.AuditHead();
        if (key is null || !head.IsSealedBy(key) || EndFault() is null)
        {
            return false;
        }

        store.Audit(
            by,
            "trail-set-back",
            Further(witness, second) is not { } seen || seen.Fault(head, At(seen.Seq), "") is null
                ? Recorded.WitnessBegun.With(basis) : Recorded.SetBack.With(basis, seen.Seq, seen.Hash));
        head = store.AuditHead();
        Keep(new AuditWitness(head.Seq, head.Hash));
        return true;

        IReadOnlyList<AuditEntry> At(long seq) => seq > 0 ? store.AuditEntries(seq - 1, 1) : [];
    }

    private static AuditWitness? Further(AuditWitness? one, AuditWitness? other) =>
        one is null || other?.Seq > one.Seq ? other : one;

    /// <summary>Writes all entries as CSV by RFC 4180 that no spreadsheet executes: times in UTC, and an apostrophe before anything that
    /// looks like a formula. Subject and basis are English sentences; the last columns have them as they are recorded.</summary>
    /// <param name="writer">The destination.</param>
    /// <returns>The number of entries.</returns>
    public long Export(TextWriter writer) => Export(writer, null, CancellationToken.None);

    /// <summary>Writes all entries as CSV, as <see cref="Export(TextWriter)"/> does, and reports progress.</summary>
    /// <param name="writer">The destination.</param>
    /// <param name="progress">Receives progress; null for no reports.</param>
    /// <param name="cancellation">Cancels the export.</param>
    /// <returns>The number of entries.</returns>
    public long Export(TextWriter writer, IProgress<CellProgress>? progress, CancellationToken cancellation) =>
        store.Database.Snapshot((connection, transaction) =>
    {
        SpreadsheetCsv.Write(writer, Columns);
        var count = 0L;
        foreach (var e in Told(
            Rows.Stream(connection, AuditRow.Select + " ORDER BY seq", AuditRow.Read, null, transaction),
            "writing entries",
            Count(connection, transaction),
            progress,
            cancellation))
        {
            SpreadsheetCsv.Write(
                writer,
                e.Seq.ToString(CultureInfo.InvariantCulture),
                e.At.UtcDateTime.ToString("yyyy-MM-dd'T'HH:mm:ss.ffffff'Z'", CultureInfo.InvariantCulture),
                e.Who,
                e.What,
                e.Subject?.Sentence ?? "",
                e.Basis.Sentence,
                e.Previous,
                e.Hash,
                e.RowCodes ?? "",
                e.Subject?.Text ?? "",
                e.Basis.Text);
            count++;
        }

        return count;
    });

    private static long Count(DbConnection connection, DbTransaction transaction) =>
        Rows.Query(connection, "SELECT count(*) FROM audit", r => r.GetInt64(0), null, transaction)[0];

    private static IEnumerable<AuditEntry> Told(
        IEnumerable<AuditEntry> entries, string doing, long of, IProgress<CellProgress>? progress, CancellationToken cancellation)
    {
        var (done, each) = (0L, Math.Max(1, of / 100));
        foreach (var entry in entries)
        {
            if (done++ % each == 0)
            {
                cancellation.ThrowIfCancellationRequested();
                progress?.Report(new(doing, done, of));
            }

            yield return entry;
        }
    }
}

/// <summary>The result of checking every entry of an audit trail.</summary>
/// <param name="Entries">The number of entries.</param>
/// <param name="Hash">Hash of the last entry. A copy kept elsewhere proves later that everything up to here is unchanged.</param>
/// <param name="Fault">The first fault; null if there is none.</param>
/// <param name="IsSealChecked">False if the keys were missing, which is a fault.</param>
public sealed record AuditFinding(long Entries, string Hash, AuditFault? Fault, bool IsSealChecked)
{
    /// <summary>Number of contents in the store whose bytes have their hash.</summary>
    public long Contents { get; init; }

    /// <summary>Length of these contents, uncompressed.</summary>
    public long ContentBytes { get; init; }

    /// <summary>Number of pages that are drawn from their reports, and are checked whenever they are drawn.</summary>
    public long Pages { get; init; }

    /// <summary>The archives that the store refers to. Those that are there were checked, content by content; nothing is known of the
    /// others.</summary>
    public IReadOnlyList<ArchiveFinding> Archives { get; init; } = [];

    /// <summary>True if there is no fault.</summary>
    public bool Holds => Fault is null;

    /// <summary>The result, in a sentence or two.</summary>
    public string Message => Fault is not null ? Fault.Message : Trail + (Archives.Where(a => !a.IsThere).ToArray() is { Length: > 0 } away
        ? string.Create(
            CultureInfo.InvariantCulture,
            $" {away.Sum(a => a.Contents)} contents are in archives that are not here, and were not looked at: "
                + $"{string.Join(", ", away.Select(a => a.Name))}.")
        : "");

    private string Trail => Entries == 1
        ? "1 entry, and it is as it was written."
        : string.Create(CultureInfo.InvariantCulture, $"{Entries} entries, and all are as they were written.");
}
