using System.Data.Common;

namespace ErrorMatching.Cell;

/// <summary>Checks whether what an intact audit trail says is allowed, and whether the store matches it: its schema, its rows, and the
/// individual steps. A correction that has ended and whose row is as recorded is forgotten at once, so memory does not grow with the
/// trail.</summary>
internal sealed class RecordedMeaning
{
    private const int PageLength = 4096;
    private readonly DbConnection _connection;
    private readonly DbTransaction _transaction;
    private readonly RecordedRows _rows;
    private readonly NumberSet _settled = new();
    private readonly List<(long Seq, StepText Step)> _steps = [];
    private readonly List<long> _ended = [];
    private long _lastStep;
    private long _stepCount;
    private long _stepRows;
    private AuditFault? _stepFault;
    private long? _shortOf;

    /// <summary>Creates an empty replay; the caller adds the entries.</summary>
    /// <param name="connection">The store, for nothing else meanwhile.</param>
    /// <param name="transaction">The snapshot that the entries are from.</param>
    /// <param name="key">The key of the row codes; null if missing.</param>
    public RecordedMeaning(DbConnection connection, DbTransaction transaction, byte[]? key)
    {
        (_connection, _transaction) = (connection, transaction);
        Replay = new() { Stepped = Step, Recall = Recall };
        _rows = new(connection, transaction, Replay, key);
    }

    /// <summary>The state that results from the entries, without corrections that have been settled.</summary>
    public AuditReplay Replay { get; }

    /// <summary>Adds the next entry.</summary>
    public void Add(AuditEntry entry)
    {
        Replay.Add(entry);
        if (_steps.Count >= PageLength) Compare();
    }

    /// <summary>The first fault, after all entries have been added; null if there is none.</summary>
    public AuditFault? Fault(CellDatabase database)
    {
        Compare();
        return database.FormFault(_connection, _transaction) ?? Replay.Fault ?? _rows.Compare(_settled) ?? StepFault();
    }

    private void Step(AuditEntry entry, long id, CorrectionState? from, CorrectionState to)
    {
        _stepCount++;
        var step = new StepText(
            id, from is { } f ? CorrectionRow.Word(f) : null, CorrectionRow.Word(to), StoredTime.Of(entry.At), entry.Who, entry.Basis.Text);
        _steps.Add((entry.Seq, step));
        if (CorrectionSteps.Of(to).IsSettled) _ended.Add(id);
    }

    // A row that is as its last entry says cannot be as a later entry says, too: if one comes, the row is compared with that at the end.
    private RecordedCorrection? Recall(long id) => !_settled.Contains(id) ? null
        : Rows.Query(_connection, CorrectionRow.Select + " WHERE id = @id", CorrectionRow.Read, [("id", id)], _transaction) is [var row]
        ? new(row.MeasurementSha256) { State = row.State, Program = row.ProgramSha256 }
        : null;

    private void Compare()
    {
        CompareSteps();
        foreach (var (row, _) in _rows.Of([.. _ended.Distinct().Where(Replay.Corrections.ContainsKey).Order()]))
        {
            if (row is null || Replay.Corrections.GetValueOrDefault(row.Value.Id) is not { Fault: null } recorded
                || !CorrectionSteps.Of(recorded.State).IsSettled
                || _rows.OfCorrection(row) is not null) continue;
            _settled.Add(row.Value.Id);
            Replay.Forget(row.Value.Id);
        }

        _ended.Clear();
    }

    // Each step is written with its entry, so both are in the same order.
    private void CompareSteps()
    {
        if (_steps.Count > 0 && _stepFault is null && _shortOf is null)
        {
            var at = 0;
            foreach (var (id, step) in Rows.Query(
                _connection,
                "SELECT id, correction, from_state, to_state, at, who, basis FROM step WHERE id > @_lastStep ORDER BY id LIMIT @Count",
                r => (
                    r.GetInt64(0),
                    new StepText(r.GetInt64(1), r.TextOrNull(2), r.GetString(3), r.GetInt64(4), r.GetString(5), r.GetString(6))),
                [("_lastStep", _lastStep), ("Count", _steps.Count)],
                _transaction))
            {
                (_lastStep, _stepRows) = (id, _stepRows + 1);
                var (seq, expected) = _steps[at++];
                if (step == expected) continue;
                _stepFault = new(AuditFaultKind.RowDiffers, seq, Recorded.StepDiffers.With(_stepRows, seq, step.Correction, step.To));
                break;
            }

            if (_stepFault is null && at < _steps.Count) _shortOf = _steps[at].Seq;
        }

        _steps.Clear();
    }

    private AuditFault? StepFault()
    {
        if (_stepFault is not null) return _stepFault;
        if (_shortOf is { } seq) return new(AuditFaultKind.RowDiffers, seq, Recorded.StepUnrecorded.With(_stepRows, _stepCount));
        return Rows.Query(
            _connection,
            "SELECT id FROM step WHERE id > @_lastStep ORDER BY id LIMIT 1",
            r => r.GetInt64(0),
            [("_lastStep", _lastStep)],
            _transaction) is [_]
            ? new(AuditFaultKind.RowDiffers, 0, Recorded.StepUnrecorded.With(_stepRows + 1, _stepCount))
            : null;
    }

    private readonly record struct StepText(long Correction, string? From, string To, long At, string Who, string Basis);
}
