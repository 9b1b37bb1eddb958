using System.Data.Common;

namespace ErrorMatching.Cell;

/// <summary>Adds codes to rows without one, which come from a store with an earlier schema. A row gets a code only if the trail is intact
/// and the row agrees with it; a row whose code the trail already names does not get another one. Data that entries of the earlier schema
/// do not cover (a password hash, a slot's previous program) are accepted as they are.</summary>
internal static class RowCoding
{
    private const int Most = 1000;
    private const string Uncoded =
        "SELECT EXISTS (SELECT 1 FROM correction WHERE row_code IS NULL) OR EXISTS (SELECT 1 FROM slot WHERE row_code IS NULL) OR "
            + "EXISTS (SELECT 1 FROM person WHERE row_code IS NULL)";

    /// <summary>Finds rows without codes and adds the codes.</summary>
    public static void Give(CellDatabase database, TimeProvider clock, byte[] key)
    {
        if (!database.Read(connection => Rows.Query(connection, Uncoded, r =>
            Convert.ToBoolean(r.GetValue(0), System.Globalization.CultureInfo.InvariantCulture))[0])) return;
        database.Write(clock, key, transaction =>
        {
            if (AuditReplay.Of(transaction) is { } replay) Give(transaction, replay, key);
            return true;
        });
    }

    private static void Give(StoreTransaction t, AuditReplay replay, byte[] key)
    {
        var rows = new RecordedRows(t, replay, key);
        var given = 0;
        Each(CorrectionRow.SelectKept, CorrectionRow.ReadKept, rows.OfCorrection, "correction", "id = @Id", c => [("Id", c.Id)]);
        Each(SlotRow.SelectKept, SlotRow.ReadKept, rows.OfSlotAndHolder, "slot", "machine = @Machine AND slot = @Slot", s =>
            [("Machine", s.Machine), ("Slot", s.Slot)]);
        Each(Person.SelectKept, Person.ReadKept, rows.OfPerson, "person", "name_key = @Key", p => [("Key", UserName.Key(p.Name))]);
        Name();

        void Each<T>(string select, Func<DbDataReader, StoredRow<T>> read, Func<StoredRow<T>, AuditFault?> fault, string table, string one,
            Func<T, SqlArguments> which)
        {
            foreach (var (row, _) in t.Query(select + " WHERE row_code IS NULL", r => RecordedRows.Read(r, read, table)))
            {
                if (row is null || fault(row) is not null) continue;
                SqlArguments parameters = [.. which(row.Value), ("GivenCode", t.CodeOf(row.Coded))];
                t.Execute($"UPDATE {table} SET row_code = @GivenCode WHERE {one}", parameters);
                if (++given == Most) Name();
            }
        }

        void Name()
        {
            if (given > 0) t.Audit(AuditEntry.ByCell, "rows-coded", null, Recorded.RowsCoded.With(given));
            given = 0;
        }
    }
}
