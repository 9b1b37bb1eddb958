using System.Data.Common;
using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Rows of slots, which change with the states of corrections in the same transaction.</summary>
internal static class SlotRow
{
    public const string Select =
        "SELECT machine, slot, correction, program_sha256, previous_sha256 FROM slot WHERE machine = @Machine AND slot = @Slot";

    private const string NamePrefix = "slot ";

    private const string Take =
        "INSERT INTO slot (machine, slot, correction) VALUES (@Machine, @Slot, @Id) "
        + "ON CONFLICT (machine, slot) DO UPDATE SET correction = excluded.correction WHERE slot.correction IS NULL OR slot.correction = "
            + "excluded.correction";

    private const string GiveBack = "UPDATE slot SET correction = NULL WHERE machine = @Machine AND slot = @Slot AND correction = @Id";

    private const string Verify =
        "UPDATE slot SET previous_sha256 = COALESCE(@PreviousSha256, program_sha256), program_sha256 = @ProgramSha256 WHERE machine = "
            + "@Machine AND slot = @Slot AND correction = @Id";

    private const string Revert =
        "UPDATE slot SET program_sha256 = COALESCE(@UndoSha256, previous_sha256), previous_sha256 = NULL, correction = @Id "
        + "WHERE machine = @Machine AND slot = @Slot AND program_sha256 = @ProgramSha256 AND (correction IS NULL OR correction = @Id)";

    public const string SelectKept = "SELECT machine, slot, correction, program_sha256, previous_sha256, row_code FROM slot";

    /// <summary>The condition that selects one slot.</summary>
    public const string One = " WHERE machine = @Machine AND slot = @Slot";

    /// <summary>The row in coded form.</summary>
    public static CodedRow Coded(SlotHolding slot) => new(
        NameOf(slot.Machine, slot.Slot), [slot.Machine, slot.Slot, CodedRow.Number(slot.Correction), slot.ProgramSha256,
            slot.PreviousSha256]);

    /// <summary>The row's name among coded rows.</summary>
    public static string NameOf(string machine, string slot) =>
        string.Create(CultureInfo.InvariantCulture, $"{NamePrefix}{machine.Length} {machine.ReplaceLineEndings(" ")} "
            + $"{slot.ReplaceLineEndings(" ")}");

    /// <summary>True if a name is that of a slot's row.</summary>
    public static bool IsName(string name) => name.StartsWith(NamePrefix, StringComparison.Ordinal);

    /// <summary>The row with its code.</summary>
    public static StoredRow<SlotHolding> ReadKept(DbDataReader row) => new(Read(row), Coded, row.TextOrNull(5));

    /// <summary>Codes a slot's current row; the audit entry that follows names the code.</summary>
    public static void Code(StoreTransaction transaction, string machine, string slot)
    {
        var row = transaction.Key is null ? null : transaction.First(SelectKept + One, ReadKept, [("Machine", machine), ("Slot", slot)]);
        transaction.Execute("UPDATE slot SET row_code = @Code" + One,
            [("Machine", machine), ("Slot", slot), ("Code", row is null ? null : transaction.CodeOf(row.Coded))]);
    }

    /// <summary>Verifies that a slot's row is as the cell wrote it, before it is changed.</summary>
    /// <exception cref="StoreException">With <see cref="StoreError.Tampered"/>.</exception>
    public static void Demand(StoreTransaction transaction, string machine, string slot)
    {
        if (transaction.Key is not null && transaction.First(SelectKept + One, ReadKept, [("Machine", machine), ("Slot", slot)]) is { } row
            && !row.Holds(transaction.Key))
        {
            throw Tampered(row);
        }
    }

    /// <summary>The error for a row that was changed outside the cell.</summary>
    public static StoreException Tampered(StoredRow<SlotHolding> row) =>
        new(StoreError.Tampered, Recorded.SlotTampered.With(row.Value.Slot, row.Value.Machine));

    /// <summary>Frees a slot of the correction that has it; otherwise the slot stays as it is.</summary>
    /// <returns>True if it was freed.</returns>
    public static bool Free(StoreTransaction transaction, string machine, string slot, long correction, string by, Statement basis)
    {
        Demand(transaction, machine, slot);
        if (transaction.Execute(GiveBack, [("Machine", machine), ("Slot", slot), ("Id", correction)]) != 1) return false;
        Code(transaction, machine, slot);
        transaction.Audit(by, "freed", Recorded.Slot.With(slot, machine), basis);
        return true;
    }

    public static SlotHolding Read(DbDataReader row) =>
        new(row.GetString(0), row.GetString(1), row.IsDBNull(2) ? null : row.GetInt64(2), row.TextOrNull(3), row.TextOrNull(4));

    /// <summary>Applies a correction's step to its slot.</summary>
    public static void Follow(StoreTransaction transaction, CorrectionState from, Correction to)
    {
        var sql = to.State switch
        {
            CorrectionState.Uploading => Take,
            CorrectionState.Verified => Verify,
            CorrectionState.Reverted => Revert,
            _ => CorrectionSteps.Of(from).HasSlot ? GiveBack : null,
        };
        if (sql is null) return;
        if (to.Machine is null || to.Slot is null || to.ProgramSha256 is null)
        {
            throw new ArgumentException(
                string.Create(
                    CultureInfo.InvariantCulture, $"Correction {to.Id} cannot become {to.State} without machine, slot and program."),
                nameof(to));
        }

        Demand(transaction, to.Machine, to.Slot);
        SqlArguments holding = [
            ("Machine", to.Machine),
            ("Slot", to.Slot),
            ("Id", to.Id),
            ("ProgramSha256", to.ProgramSha256),
            ("PreviousSha256", to.PreviousSha256),
            ("UndoSha256", to.UndoSha256),
        ];
        if (transaction.Execute(sql, holding) == 1)
        {
            Code(transaction, to.Machine, to.Slot);
            return;
        }

        var slot = transaction.First(Select, Read, [("Machine", to.Machine), ("Slot", to.Slot)]);
        if (slot?.Correction is { } holder && holder != to.Id) throw new SlotTakenException(to.Machine, to.Slot, holder);
        throw new StoreException(
            StoreError.Conflict,
            string.Create(
                CultureInfo.InvariantCulture,
                $"Slot {to.Slot} of {to.Machine} no longer holds the program of correction {to.Id}, which therefore cannot become "
                    + $"{CorrectionRow.Word(to.State)}."));
    }
}

/// <summary>Another correction has the slot.</summary>
/// <param name="machine">The machine.</param>
/// <param name="slot">Its slot.</param>
/// <param name="holder">Number of the correction that has it.</param>
public sealed class SlotTakenException(string machine, string slot, long holder)
    : Exception(string.Create(
        CultureInfo.InvariantCulture, $"Slot {slot} of {machine} is taken by correction {holder} until that is released."))
{
    /// <summary>Number of the correction that has the slot.</summary>
    public long Holder => holder;
}
