using System.Data.Common;
using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Checks whether what an intact audit trail says is allowed, and whether the store matches it: its schema, its rows, and the
/// individual steps.</summary>
internal sealed class RecordedMeaning
{
    private readonly List<(long Seq, long Digest)> _steps = [];

    /// <summary>Creates an empty replay; the caller adds the entries.</summary>
    public RecordedMeaning() => Replay = new()
    {
        Stepped = (entry, id, from, to) => _steps.Add((entry.Seq, Digest(id, from, to, entry.At, entry.Who, entry.Basis))),
    };

    /// <summary>The state that results from the entries.</summary>
    public AuditReplay Replay { get; }

    /// <summary>The first fault, after all entries have been added; null if there is none.</summary>
    public AuditFault? Fault(CellDatabase database, DbConnection connection, DbTransaction transaction, byte[]? key) =>
        database.FormFault(connection, transaction) ?? Replay.Fault ?? new RecordedRows(connection, transaction, Replay, key).Compare()
            ?? Steps(connection, transaction);

    // Each step is written with its entry, so both are in the same order.
    private AuditFault? Steps(DbConnection connection, DbTransaction transaction)
    {
        var count = 0;
        foreach (var step in Rows.Stream(connection, "SELECT correction, from_state, to_state, at, who, basis FROM step ORDER BY id",
            CorrectionRow.ReadStep, null, transaction))
        {
            if (count == _steps.Count) return new(AuditFaultKind.RowDiffers, 0, Recorded.StepUnrecorded.With(count + 1, _steps.Count));
            var (seq, digest) = _steps[count++];
            if (digest != Digest(step.Correction, step.From, step.To, step.At, step.By, step.Basis))
            {
                return new(AuditFaultKind.RowDiffers, seq,
                    Recorded.StepDiffers.With(count, seq, step.Correction, CorrectionRow.Word(step.To)));
            }
        }

        return count == _steps.Count ? null : new(AuditFaultKind.RowDiffers, _steps[count].Seq,
            Recorded.StepUnrecorded.With(count, _steps.Count));
    }

    private static long Digest(long id, CorrectionState? from, CorrectionState to, DateTimeOffset at, string who, string basis) =>
        BitConverter.ToInt64(
        SHA256.HashData(Encoding.UTF8.GetBytes(
            FormattableString.Invariant($"{id}\n{from}\n{to}\n{StoredTime.Of(at)}\n{who.Length}\n{who}\n{basis}"))));
}
