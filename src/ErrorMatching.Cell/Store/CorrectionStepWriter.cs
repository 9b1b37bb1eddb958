using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Writes steps of corrections.</summary>
internal static class CorrectionStepWriter
{
    /// <summary>Takes one step of a correction.</summary>
    /// <param name="transaction">The change.</param>
    /// <param name="from">The correction as it was read.</param>
    /// <param name="to">The state after.</param>
    /// <param name="by">Who takes it.</param>
    /// <param name="basis">The basis.</param>
    /// <param name="wanted">The correction with its other changes.</param>
    public static Correction Take(
        StoreTransaction transaction, Correction from, CorrectionState to, string by, Statement basis, Correction wanted)
    {
        var after = wanted with
        {
            Id = from.Id,
            State = to,
            Version = from.Version + 1,
            Gauge = from.Gauge,
            FileName = from.FileName,
            ArrivedAt = from.ArrivedAt,
            ChangedAt = transaction.Now,
            MeasurementSha256 = from.MeasurementSha256,
            MeasurementBytes = from.MeasurementBytes,
            MeasuredAs = from.MeasuredAs,
        };
        if (after.Identity is { } identity && identity != from.Identity
            && transaction.Value<long?>(
                "SELECT id FROM correction WHERE identity = @identity AND id <> @Id",
                [("identity", identity), ("Id", after.Id)]) is { } existing)
        {
            throw new DuplicateCorrectionException(existing);
        }

        Update(transaction, from, after);
        SlotRow.Follow(transaction, from.State, after);
        Note(transaction, after, from.State, by, basis);
        return after;
    }

    /// <summary>Rejects a step that the table does not have.</summary>
    /// <exception cref="StoreException">With <see cref="StoreError.Conflict"/>.</exception>
    public static void DemandAllowed(Correction from, CorrectionState to)
    {
        if (!CorrectionSteps.Allows(from.State, to))
        {
            throw new StoreException(
                StoreError.Conflict,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"Correction {from.Id} is {CorrectionRow.Word(from.State)}: from there no step leads to {CorrectionRow.Word(to)}."));
        }
    }

    /// <summary>Changes the row of a correction, if it is still as it was read.</summary>
    /// <exception cref="StoreException">With <see cref="StoreError.Conflict"/> or <see cref="StoreError.Tampered"/>.</exception>
    public static void Update(StoreTransaction transaction, Correction from, Correction after)
    {
        DemandKept(transaction, from, after);
        var code = transaction.CodeOf(CorrectionRow.Coded(after));
        if (transaction.Execute(CorrectionRow.Update, CorrectionRow.Parameters(after, from.State, code)) != 1)
        {
            throw Conflict(transaction, from, after.State);
        }
    }

    /// <summary>Records a step, and in the audit trail who took it.</summary>
    public static void Note(StoreTransaction transaction, Correction after, CorrectionState? from, string by, Statement basis)
    {
        transaction.Execute(
            "INSERT INTO step (correction, from_state, to_state, at, who, basis) VALUES (@Id, @From, @To, @At, @By, @Basis)",
            [
                ("Id", after.Id),
                ("From", from is { } f ? CorrectionRow.Word(f) : null),
                ("To", CorrectionRow.Word(after.State)),
                ("At", StoredTime.Of(transaction.Now)),
                ("By", StoredText.Name(by)),
                ("Basis", StoredText.Of(basis).Text),
            ]);
        var subject = from is null
            ? Recorded.File.With(after.Id, after.MeasurementSha256)
            : after.ProgramSha256 is { } program
            ? Recorded.Program.With(after.Id, program)
            : Recorded.Correction.With(after.Id);
        transaction.Audit(by, CorrectionRow.Word(after.State), subject, basis);
    }

    /// <summary>The error if a correction is not, or no longer, as it was read.</summary>
    public static StoreException Conflict(StoreTransaction transaction, Correction from, CorrectionState to)
    {
        var now = transaction.First(CorrectionRow.Select + " WHERE id = @Id", CorrectionRow.Read, [("Id", from.Id)]);
        return now is null
            ? new StoreException(StoreError.Missing, string.Create(CultureInfo.InvariantCulture, $"There is no correction {from.Id}."))
            : new StoreException(
                StoreError.Conflict,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"Correction {from.Id} was {CorrectionRow.Word(from.State)} and is {CorrectionRow.Word(now.State)} meanwhile: it "
                        + $"cannot become {CorrectionRow.Word(to)}. Look at it again."));
    }

    // A step requires the row that the cell left. A step that ends a correction without sending it may start from any row: this is how a
    // person gets rid of a tampered correction, and the trail records what was found.
    private static void DemandKept(StoreTransaction transaction, Correction from, Correction after)
    {
        if (transaction.Key is not { } key || transaction.First(CorrectionRow.SelectKept + " WHERE id = @Id", CorrectionRow.ReadKept,
            [("Id", from.Id)]) is not { } row
            || row.Value.Version != from.Version || row.Value.State != from.State)
        {
            // A missing or changed row is a conflict, which the update itself detects.
            return;
        }

        if (row.Holds(key) && CorrectionRow.Coded(from).Code(key) == row.Code) return;
        var message = Recorded.CorrectionTampered.With(from.Id);
        if (!CorrectionSteps.Of(after.State).EndsTampered && after is not { State: CorrectionState.Failed, ProgramSha256: null })
        {
            throw new StoreException(StoreError.Tampered, message);
        }

        transaction.Audit(AuditEntry.ByCell, AuditLedger.Tampered, Recorded.Correction.With(from.Id), message);
    }
}

/// <summary>A correction with the same measurement, job and base program already exists: it must not be applied twice.</summary>
/// <param name="existing">Number of the existing correction.</param>
public sealed class DuplicateCorrectionException(long existing)
    : Exception(string.Create(
        CultureInfo.InvariantCulture,
        $"Correction {existing} has the same measurement, job and base program: a correction is applied once."))
{
    /// <summary>Number of the existing correction.</summary>
    public long Existing => existing;
}
