using System.Data.Common;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Compares the rows of a store with what its audit trail says of them.</summary>
/// <param name="connection">The store.</param>
/// <param name="transaction">One snapshot of it.</param>
/// <param name="replay">The state by the trail.</param>
/// <param name="key">The key of the row codes; null if missing: then codes are compared with the trail's, but not with the rows.</param>
internal sealed class RecordedRows(DbConnection connection, DbTransaction transaction, AuditReplay replay, byte[]? key)
{
    /// <summary>Compares the rows as a change in progress sees them.</summary>
    public RecordedRows(StoreTransaction change, AuditReplay replay, byte[]? key)
        : this(change.Connection, change.Transaction, replay, key)
    {
    }

    /// <summary>How many rows are read at once by their numbers.</summary>
    public const int AtOnce = 500;

    /// <summary>The first row that differs from the trail; null if none does.</summary>
    /// <param name="settled">Corrections whose rows were already compared, and which the replay has forgotten.</param>
    public AuditFault? Compare(NumberSet settled)
    {
        var slots = Query(SlotRow.SelectKept + " ORDER BY machine, slot", SlotRow.ReadKept, "slot");
        var holders = slots.Where(s => s.Row?.Value.Correction is not null)
            .ToLookup(s => s.Row!.Value.Correction!.Value, s => (s.Row!.Value.Machine, s.Row.Value.Slot));
        return Corrections(holders, settled)
            ?? slots.Select(s => s.Row is { } row ? OfSlot(row) : s.Fault).FirstOrDefault(f => f is not null)
            ?? People()
            ?? CredentialsAndMissing(slots.Select(s => s.Row!.Coded.Name));
    }

    /// <summary>What is wrong with the row of a correction; null if nothing is.</summary>
    public AuditFault? OfCorrection(StoredRow<Correction> row)
    {
        var c = row.Value;
        if (replay.Corrections.GetValueOrDefault(c.Id) is not { } recorded)
        {
            return Differs(0, Recorded.CorrectionUnrecorded.With(c.Id, c.State.ToString().ToLowerInvariant()));
        }

        if (c.State != recorded.State)
        {
            return Differs(recorded.Seq, Recorded.StateDiffers.With(c.Id, CorrectionRow.Word(c.State), recorded.Seq,
                CorrectionRow.Word(recorded.State)));
        }

        // A correction that ended without being sent may have lost its program, or never had one.
        if (c.ProgramSha256 != recorded.Program && !(c.ProgramSha256 is null && recorded.State is CorrectionState.Failed))
        {
            return Differs(recorded.Seq, Recorded.ProgramDiffers.With(c.Id, c.ProgramSha256 ?? "none", recorded.Seq, recorded.Program
                ?? "none"));
        }

        return c.MeasurementSha256 != recorded.File
            ? Differs(recorded.Seq, Recorded.FileDiffers.With(c.Id, c.MeasurementSha256, recorded.File))
            : OfCode(row.Coded, row.Code, seq => Recorded.CorrectionDiffers.With(c.Id, seq));
    }

    /// <summary>What is wrong with the row of a slot; null if nothing is.</summary>
    public AuditFault? OfSlot(StoredRow<SlotHolding> row)
    {
        var slot = row.Value;
        var holder = slot.Correction is { } id ? replay.Corrections.GetValueOrDefault(id) : null;
        return holder is not null && CorrectionSteps.Of(holder.State) is { HasSlot: false, WaitsForRelease: false }
            && slot.Correction is { } held
            ? Differs(holder.Seq, Recorded.SlotHeldByOther.With(slot.Slot, slot.Machine, held, CorrectionRow.Word(holder.State)))
            : OfCode(row.Coded, row.Code, seq => Recorded.SlotDiffers.With(slot.Slot, slot.Machine, seq));
    }

    /// <summary>What is wrong with the row of a slot, or with another correction that must have the slot; null if nothing is.</summary>
    public AuditFault? OfSlotAndHolder(StoredRow<SlotHolding> row) => OfSlot(row) ?? Query(
        CorrectionRow.SelectKept + $" WHERE {CorrectionRow.IsIn("state", CorrectionSteps.Where(s => s.HasSlot))}",
            CorrectionRow.ReadKept, "correction")
        .Select(c => c.Row?.Value).OfType<Correction>()
            .Where(c => c.Machine == row.Value.Machine && c.Slot == row.Value.Slot && c.Id != row.Value.Correction)
        .Select(c => Differs(0, Recorded.SlotNotHeld.With(c.Slot, c.Machine, c.Id, CorrectionRow.Word(c.State)))).FirstOrDefault();

    /// <summary>What is wrong with a missing slot row; null if the trail has no such row either.</summary>
    public AuditFault? OfNoSlot(string machine, string slot) =>
        replay.CodeOf(SlotRow.NameOf(machine, slot)) is { } code ? Differs(code.Seq, Recorded.SlotDiffers.With(slot, machine, code.Seq))
            : null;

    /// <summary>What is wrong with the row of a user; null if nothing is.</summary>
    public AuditFault? OfPerson(StoredRow<Person> row)
    {
        var person = row.Value;
        if (replay.People.GetValueOrDefault(UserName.Key(person.Name)) is not { } recorded)
        {
            return Differs(0, Recorded.UserUnrecorded.With(person.Name));
        }

        if (person.Role != recorded.Role)
        {
            return Differs(recorded.Seq, Recorded.RoleDiffers.With(person.Name, person.RoleWord, recorded.Seq,
                Rights.Word(recorded.Role)));
        }

        return person.IsDisabled != recorded.IsDisabled
            ? Differs(recorded.Seq, Recorded.DisabledDiffers.With(person.Name, person.IsDisabled ? "disabled" : "enabled", recorded.Seq))
            : OfCode(row.Coded, row.Code, seq => Recorded.UserDiffers.With(person.Name, seq));
    }

    /// <summary>The fault of a row that cannot be parsed.</summary>
    public static AuditFault Unreadable(string kind, string name) => Differs(0, Recorded.RowUnreadable.With(kind, name));

    /// <summary>Reads a row; one that cannot be parsed is a fault.</summary>
    public static (StoredRow<T>? Row, AuditFault? Fault) Read<T>(DbDataReader row, Func<DbDataReader, StoredRow<T>> read, string kind)
    {
        try
        {
            return (read(row), null);
        }
        catch (Exception e) when (e is InvalidCastException or FormatException or ArgumentException or OverflowException
            or InvalidOperationException or StoreException)
        {
            return (null, Unreadable(kind, row.GetValue(0) is IFormattable f
                ? f.ToString(null, System.Globalization.CultureInfo.InvariantCulture) : $"{row.GetValue(0)}"));
        }
    }

    /// <summary>The rows of some corrections, in order of their numbers.</summary>
    /// <param name="ids">Their numbers, in order.</param>
    public IEnumerable<(StoredRow<Correction>? Row, AuditFault? Fault)> Of(IReadOnlyList<long> ids)
    {
        for (var (from, to) = (0, 0); from < ids.Count; from = to)
        {
            for (to = from + 1; to < ids.Count && to - from < AtOnce && ids[to] - ids[to - 1] == 1; to++)
            {
            }

            foreach (var row in Rows.Query(
                connection,
                CorrectionRow.SelectKept + " WHERE id BETWEEN @First AND @Last ORDER BY id",
                r => Read(r, CorrectionRow.ReadKept, "correction"),
                [("First", ids[from]), ("Last", ids[to - 1])],
                transaction)) yield return row;
        }
    }

    private AuditFault? Corrections(ILookup<long, (string Machine, string Slot)> holders, NumberSet settled)
    {
        var seen = new HashSet<long>();
        var unknown = Unrecorded(settled);
        foreach (var ids in replay.Corrections.Keys.Order().Chunk(AtOnce))
        {
            foreach (var (row, fault) in Of(ids))
            {
                if (unknown is { } first && row?.Value.Id > first) break;
                if ((fault ?? OfCorrection(row!)) is { } differs) return differs;
                var c = row!.Value;
                seen.Add(c.Id);
                if (CorrectionSteps.Of(c.State).HasSlot
                    && !holders[c.Id].Contains((c.Machine ?? "", c.Slot ?? "")))
                {
                    return Differs(replay.Corrections[c.Id].Seq,
                        Recorded.SlotNotHeld.With(c.Slot ?? "", c.Machine ?? "", c.Id, CorrectionRow.Word(c.State)));
                }
            }
        }

        if (unknown is { } other)
        {
            var (row, unreadable) = Of([other]).Single();
            return row is null ? unreadable : OfCorrection(row);
        }

        return replay.Corrections.Where(c => !seen.Contains(c.Key)).OrderBy(c => c.Key)
            .Select(c => Differs(c.Value.Seq, Recorded.CorrectionMissing.With(c.Key, c.Value.Seq))).FirstOrDefault();
    }

    // The number of the first row that no entry names; null if there is none.
    private long? Unrecorded(NumberSet settled)
    {
        foreach (var id in Rows.Stream(connection, "SELECT id FROM correction ORDER BY id", r => r.GetInt64(0), null, transaction))
        {
            if (!settled.Contains(id) && !replay.Corrections.ContainsKey(id)) return id;
        }

        return null;
    }

    private AuditFault? People()
    {
        var rows = Query(Person.SelectKept + " ORDER BY name_key", Person.ReadKept, "user");
        var seen = rows.Select(r => r.Row?.Value.Name).OfType<string>().Select(UserName.Key).ToHashSet(StringComparer.Ordinal);
        return rows.Select(r => r.Row is { } row ? OfPerson(row) : r.Fault).FirstOrDefault(f => f is not null)
            ?? replay.People.Where(p => !seen.Contains(p.Key)).OrderBy(p => p.Key, StringComparer.Ordinal)
                .Select(p => Differs(p.Value.Seq, Recorded.UserMissing.With(p.Value.Name, p.Value.Seq))).FirstOrDefault();
    }

    /// <summary>What is wrong with the row of a PIN or badge; null if nothing is.</summary>
    public AuditFault? OfCredential(StoredRow<CredentialRow> row) => OfCode(
        row.Coded, row.Code, seq => Recorded.CredentialDiffers.With(CredentialRow.Word(row.Value.Kind), row.Value.NameKey, seq));

    // The trail knows slots, PINs and badges only by their codes.
    private AuditFault? CredentialsAndMissing(IEnumerable<string> slots)
    {
        var credentials = Query(CredentialRow.SelectKept + " ORDER BY name_key, kind", CredentialRow.ReadKept, "credential");
        if (credentials.Select(c => c.Row is { } row ? OfCredential(row) : c.Fault).FirstOrDefault(f => f is not null) is { } fault)
        {
            return fault;
        }

        var there = slots.Concat(credentials.Select(c => c.Row!.Coded.Name)).ToHashSet(StringComparer.Ordinal);
        return replay.CodedRows.Where(r => (SlotRow.IsName(r) || CredentialRow.IsName(r)) && !there.Contains(r))
            .Order(StringComparer.Ordinal)
            .Select(r => Differs(replay.CodeOf(r)!.Value.Seq, Recorded.RowMissing.With(r, replay.CodeOf(r)!.Value.Seq))).FirstOrDefault();
    }

    private AuditFault? OfCode(CodedRow coded, string? code, Func<long, Statement> message) =>
        replay.CodeOf(coded.Name) is var (expected, seq)
        ? code == expected && (key is null || coded.Code(key) == expected) ? null : Differs(seq, message(seq))
        : code is null ? null : Differs(0, message(0));

    private List<(StoredRow<T>? Row, AuditFault? Fault)> Query<T>(string sql, Func<DbDataReader, StoredRow<T>> read, string kind) =>
        [.. Stream(sql, read, kind)];

    private IEnumerable<(StoredRow<T>? Row, AuditFault? Fault)> Stream<T>(string sql, Func<DbDataReader, StoredRow<T>> read, string kind) =>
        Rows.Stream(connection, sql, r => Read(r, read, kind), null, transaction);

    private static AuditFault Differs(long seq, Statement message) => new(AuditFaultKind.RowDiffers, seq, message);
}
