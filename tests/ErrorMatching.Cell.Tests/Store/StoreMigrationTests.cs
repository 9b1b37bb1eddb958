
namespace ErrorMatching.Cell.Tests;

/// <summary>Stores of earlier forms.</summary>
public abstract class StoreMigrationTests(StoreKind kind) : StoreTest(kind)
{
    /// <summary>Rows of the tables that a migration made, by its number: they must come through all that follow.</summary>
    private static readonly Dictionary<int, string> RowsOf = new()
    {
        [1] = """
            INSERT INTO content (sha256, bytes) VALUES ('aa', 'one'), ('bb', 'two');
            INSERT INTO correction (state, version, arrival, gauge, file_name, arrived_at, changed_at, measurement_sha256, measurement_bytes, job, serial, identity, machine, slot, program, program_sha256, largest_mm)
            VALUES ('archived', 1, 'k1', 'gauge', 'one.csv', 1000000, 1000000, 'aa', 3, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL),
                   ('verified', 7, 'k2', 'gauge', 'two.csv', 2000000, 3000000, 'bb', 3, 'job', 'A-2', 'i2', 'mill', '1', 'O1.nc', 'bb', 0.125);
            INSERT INTO step (correction, from_state, to_state, at, who, basis) VALUES (1, NULL, 'archived', 1000000, 'cell', 'arrived'), (2, 'uploading', 'verified', 3000000, 'cell', 'read back');
            INSERT INTO slot (machine, slot, correction, program_sha256) VALUES ('mill', '1', 2, 'bb');
            """,

        // Anna's hash is of "correct horse battery", by hashlib.pbkdf2_hmac of Python with SHA-512, 1000 iterations and the bytes 0 to 15
        // as salt. Failures are by the SHA-256 of ANNA and EVE.
        [2] = """
            INSERT INTO person (name_key, name, role, password, is_disabled, added_at, password_at)
            VALUES ('ANNA', 'Anna', 'Administrator', 'AQAAAAIAAAPoAAAAEAABAgMEBQYHCAkKCwwNDg9OjEVSLnLd+mtlFb9XoK6lHa4gNh+7LmuWwX1ngTrjyQ==', 0, 1000000, 2000000),
                   ('BEN', 'Ben', 'Operator', 'none', 1, 3000000, 3000000);
            INSERT INTO sign_in_failure (name_hash, is_user, failures, failed_at) VALUES ('5c5a268702708ababeb96ed61de8b127c9f49bedc1effcd70d4aded37beace10', 1, 2, 4000000), ('6a049984467eca45e3e44ba87042a6ea68e9a6923a60f6f29fd4f74491840dec', 0, 1, 5000000);
            INSERT INTO machine_secret (machine, bytes) VALUES ('mill', 'sealed');
            """,
    };

    [Fact]
    public void Migrations_are_numbered_from_one_without_a_gap() =>
        Assert.Equal(Enumerable.Range(1, Migrations.All.Count), Migrations.All.Select(m => m.Number));

    [Fact]
    public void A_store_of_each_earlier_form_is_taken_to_the_present_one_with_all_its_rows()
    {
        foreach (var form in Migrations.All.Select(m => m.Number))
        {
            var settings = Kind.NewSettings();
            var before = Filled(settings, form);
            Assert.Equal(form, before["migration"].Count);
            using (var store = CellStore.Open(settings, Clock))
            {
                var after = Tables(store.Database);
                Assert.Equal(Migrations.All.Count, after["migration"].Count);
                foreach (var (table, rows) in before.Where(t => t.Key != "migration"))
                {
                    Assert.Equal(rows.Count, after[table].Count);
                    for (var i = 0; i < rows.Count; i++) Assert.All(
                        rows[i], column => Assert.Equal(column.Value, after[table][i][column.Key]));
                }

                Assert.Equal(
                    [(1L, CorrectionState.Archived), (2L, CorrectionState.Verified)],
                    store.Corrections.InState(Enum.GetValues<CorrectionState>()).Select(c => (c.Id, c.State)));
                Assert.Equal(new SlotHolding("mill", "1", 2, "bb", null), store.Slot("mill", "1"));
                store.Step(store.Find(2)!, CorrectionState.Released, "anna", "cut");
                Assert.Null(store.VerifyAudit());
            }

            using var again = CellStore.Open(settings, Clock);
            Assert.Equal(CorrectionState.Released, again.Find(2)!.State);
        }
    }

    [Fact]
    public void A_store_of_a_newer_program_is_left_alone()
    {
        using (var store = CellStore.Open(Settings, Clock)) store.Write(t => t.Execute(
            "INSERT INTO migration (number, name, at) VALUES (9999, 'tomorrow', 0)"));
        Assert.Equal(StoreError.TooNew, Assert.Throws<StoreException>(() => Open()).Error);
    }

    [Fact]
    public void People_of_an_earlier_form_sign_in_with_the_passwords_that_they_had()
    {
        var settings = Kind.NewSettings();
        Filled(settings, 2);
        using var store = CellStore.Open(settings, Clock);
        var users = new UserBook(store, Clock, new PasswordHashes(1000));
        Assert.Equal(
            [("Anna", Role.Administrator, false, 2), ("Ben", Role.Operator, true, 0)],
            users.List().Select(u => (u.Name, u.Role, u.IsDisabled, u.Failures)));
        Assert.Equal("Anna", users.SignIn("anna", "correct horse battery").Name);
        Assert.Equal(PeopleError.SignInRefused, Assert.Throws<PeopleException>(() => users.SignIn("anna", "correct horse")).Error);
        Assert.Null(store.VerifyAudit());
    }

    // Goes from form to form as stores did that were in use.
    private Dictionary<string, List<IDictionary<string, object>>> Filled(StoreSettings settings, int form)
    {
        for (var number = 1; number <= form; number++)
        {
            using var database = StoreOpening.Connect(settings, opened => Migrations.Apply(opened, Clock, null, number));
            if (RowsOf.TryGetValue(number, out var rows))
                database.Change((connection, transaction) => connection.Execute(rows, transaction: transaction));
        }

        using var filled = StoreOpening.Connect(settings, opened => Migrations.Apply(opened, Clock, null, form));
        return Tables(filled);
    }

    private Dictionary<string, List<IDictionary<string, object>>> Tables(CellDatabase database) => database.Read(connection => Rows
        .Query(connection, Kind.TablesSql, r => r.GetString(0))
        .ToDictionary(t => t, t => Rows
            .Query<IDictionary<string, object>>(
                connection,
                $"SELECT * FROM {t} ORDER BY 1, 2",
                r => Enumerable.Range(0, r.FieldCount).ToDictionary(r.GetName, i => r.IsDBNull(i) ? null! : r.GetValue(i)))
            .ToList()));
}
