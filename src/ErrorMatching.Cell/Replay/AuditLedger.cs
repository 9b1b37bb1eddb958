using System.Data.Common;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The state of the audit trail as this process has read it. Each entry is read once. The state begins with the store's checkpoint
/// if that holds, else with the first entry, and has only what may still be sent: its memory does not grow with the trail.</summary>
/// <param name="key">The key that seals the trail and codes rows; null for none, in which case nothing is checked.</param>
internal sealed class AuditLedger(byte[]? key)
{
    /// <summary>The audit trail's word for a change made outside the cell.</summary>
    public const string Tampered = "tampered";

    private const int PageLength = 1024;
    private const int MostSettled = 4096;

    private readonly Lock _gate = new();
    private AuditReplay _replay = new();
    private long _seq;
    private string _hash = AuditEntry.NoHash;
    private bool _hasBegun;
    private int _settleAt = MostSettled;

    // Settled corrections are forgotten. If one is asked for all the same, the trail is read again, and none is.
    private bool _forgets = true;
    private bool _lacks;

    // Entries up to the checkpoint are looked at while the cell already works: how far that is, and whether they are as written.
    private (long Seq, string Hash) _from = (0, AuditEntry.NoHash);
    private (long Seq, string Hash) _behind = (0, AuditEntry.NoHash);
    private AuditFault? _behindFault;

    /// <summary>Why the state does not begin with the store's checkpoint; null if it does, or has not begun.</summary>
    public Statement? WhyWhole { get; private set; }

    /// <summary>Number of the last entry that was read.</summary>
    public long Seq
    {
        get
        {
            lock (_gate) return _seq;
        }
    }

    /// <summary>Why a correction must not go to its machine; null if there is no objection.</summary>
    public AuditFault? Fault(CellDatabase database, Correction correction)
    {
        if (key is null) return null;

        // One after another, each with a connection only in its turn: a store has few.
        lock (_gate)
        {
            return database.Snapshot((connection, transaction) => CatchUp(connection, transaction, CancellationToken.None)
                ?? Known(connection, transaction, correction)
                ?? database.FormFault(connection, transaction)
                ?? Rows(connection, transaction, correction)
                ?? _replay.Corrections[correction.Id].Fault);
        }
    }

    /// <summary>Reads the entries that were added, and makes a checkpoint of the state after the last.</summary>
    /// <param name="database">The store.</param>
    /// <param name="stop">Ends the reading; the next call goes on.</param>
    /// <returns>Null if the trail is not as written, or without a key.</returns>
    public AuditCheckpoint? Checkpoint(CellDatabase database, CancellationToken stop)
    {
        if (key is null) return null;
        lock (_gate)
        {
            return database.Snapshot((connection, transaction) => CatchUp(connection, transaction, stop)) is null && _seq > 0
                ? new(_seq, _hash, ReplayState.Write(_replay)) : null;
        }
    }

    /// <summary>Looks at some more of the entries before the checkpoint that the state began with.</summary>
    /// <param name="database">The store.</param>
    /// <param name="most">How many at most.</param>
    /// <returns>What is wrong with an entry that was looked at; null if nothing is.</returns>
    public AuditFault? LookBehind(CellDatabase database, int most)
    {
        lock (_gate)
        {
            if (_behind.Seq >= _from.Seq) return _behindFault;
            var entries = database.Read(connection => Cell.Rows.Query(
                connection,
                AuditRow.Select + " WHERE seq > @After AND seq <= @Last ORDER BY seq LIMIT @most",
                AuditRow.ReadOrUnreadable,
                [("After", _behind.Seq), ("Last", _from.Seq), ("most", most)]));
            foreach (var entry in entries)
            {
                if (!Follows(entry, entry.IsWrittenAs(entry.Seq), _behind)) return BrokenBehind();
                _behind = (entry.Seq, entry.Hash);
            }

            return entries.Count == 0 || (_behind.Seq == _from.Seq && _behind.Hash != _from.Hash) ? BrokenBehind() : null;
        }
    }

    private AuditFault BrokenBehind()
    {
        _behindFault = Broken(_behind.Seq);
        _behind = _from;
        return _behindFault;
    }

    private AuditFault? CatchUp(DbConnection connection, DbTransaction transaction, CancellationToken stop)
    {
        if (_behindFault is not null) return _behindFault;
        if (!_hasBegun) Begin(connection, transaction);
        var fault = Follow(connection, transaction, stop);
        return _lacks ? FollowWhole(connection, transaction, stop) : fault;
    }

    // A settled correction of before is asked for: this happens if a program is reverted that is not the last one of its slot.
    private AuditFault? Known(DbConnection connection, DbTransaction transaction, Correction correction) =>
        _forgets && correction.Id <= _replay.Highest && !_replay.Corrections.ContainsKey(correction.Id)
            ? FollowWhole(connection, transaction, CancellationToken.None) : null;

    private AuditFault? FollowWhole(DbConnection connection, DbTransaction transaction, CancellationToken stop)
    {
        (_forgets, _lacks) = (false, false);
        BeginAt(new(), 0, AuditEntry.NoHash);
        return Follow(connection, transaction, stop);
    }

    private void Begin(DbConnection connection, DbTransaction transaction)
    {
        var (found, problem) = _forgets ? AuditCheckpoint.Find(connection, transaction, key!) : (null, WhyWhole);
        WhyWhole = problem;
        var replay = Empty();
        if (found is not null) ReplayState.Read(found.State, replay);
        BeginAt(replay, found?.Seq ?? 0, found?.Hash ?? AuditEntry.NoHash);
        (_from, _behind) = ((_seq, _hash), (0, AuditEntry.NoHash));
    }

    private void BeginAt(AuditReplay replay, long seq, string hash) => (_replay, _seq, _hash, _hasBegun) = (replay, seq, hash, true);

    private AuditReplay Empty()
    {
        AuditReplay? replay = null;
        replay = new() { Recall = Lack };
        return replay;

        RecordedCorrection? Lack(long id)
        {
            _lacks |= id <= replay!.Highest;
            return null;
        }
    }

    private AuditFault? Follow(DbConnection connection, DbTransaction transaction, CancellationToken stop)
    {
        var head = AuditRow.Head(connection, transaction, "");
        var entries = Cell.Rows.Stream(connection, AuditRow.Select + " WHERE seq > @_seq ORDER BY seq", AuditRow.ReadOrUnreadable,
            [("_seq", _seq)], transaction).Select(AuditChain.Looked);
        foreach (var (entry, isAsWritten) in head.Seq - _seq > PageLength ? ReadAhead.Of(entries) : entries)
        {
            if (!Follows(entry, isAsWritten, (_seq, _hash))) return StartOver();
            _replay.Add(entry);
            if (_lacks) return null;
            (_seq, _hash) = (entry.Seq, entry.Hash);
            if (_seq % PageLength == 0) stop.ThrowIfCancellationRequested();
            if (_forgets && _replay.Corrections.Count >= _settleAt) Settle();
        }

        return head.Seq == _seq && head.Hash == _hash && head.IsSealedBy(key) ? null : StartOver();
    }

    private void Settle()
    {
        _replay.Settle();
        _settleAt = (2 * _replay.Corrections.Count) + MostSettled;
    }

    private static bool Follows(AuditEntry entry, bool isAsWritten, (long Seq, string Hash) last) =>
        entry.Seq == last.Seq + 1 && entry.Previous == last.Hash && isAsWritten;

    // The next check starts with the first entry or the checkpoint: by then a backup may have replaced the store.
    private AuditFault StartOver()
    {
        var fault = Broken(_seq);
        BeginAt(new(), 0, AuditEntry.NoHash);
        _hasBegun = false;
        return fault;
    }

    private static AuditFault Broken(long seq) => new(AuditFaultKind.Changed, seq, Recorded.TrailBroken.With(seq + 1));

    private AuditFault? Rows(DbConnection connection, DbTransaction transaction, Correction correction)
    {
        var rows = new RecordedRows(connection, transaction, _replay, key);
        var found = Cell.Rows.Query(
            connection, CorrectionRow.SelectKept + " WHERE id = @Id", r =>
                RecordedRows.Read(r, CorrectionRow.ReadKept, "correction"), [("Id", correction.Id)], transaction);
        if (found is not [({ } row, _)]) return found is [(_, { } unreadable)] ? unreadable
            : RecordedRows.Unreadable("correction", CodedRow.Number(correction.Id));
        if (rows.OfCorrection(row) is { } fault) return fault;

        // The correction in memory is what will be sent. It was read earlier and must still match the row.
        if (CorrectionRow.Coded(correction).Code(key) != row.Code) return new(AuditFaultKind.RowDiffers, 0,
            Recorded.CorrectionDiffers.With(correction.Id, _seq));
        var (machine, name) = (correction.Machine ?? "", correction.Slot ?? "");
        var slot = Cell.Rows.Query(
            connection, SlotRow.SelectKept + SlotRow.One, r =>
                RecordedRows.Read(r, SlotRow.ReadKept, "slot"), [("Machine", machine), ("Slot", name)], transaction);
        return slot is [var (held, fault2)] ? fault2 ?? rows.OfSlot(held!) : rows.OfNoSlot(machine, name);
    }
}
