using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell.Tests;

/// <summary>What somebody can do to the rows of a store who can write its file and does not have the keys: none of it is sent, and all of
/// it is found.</summary>
public sealed class TamperedStoreTests : PeopleTest
{
    private const string Own = "G0 Z-500";
    private static readonly string OwnSha256 = Hash(Own);
    private readonly Correction _atMachine;
    private readonly Correction _proposed;
    private readonly Correction _approved;
    private readonly Correction _rejected;

    public TamperedStoreTests()
    {
        foreach (var (name, role) in new[] { ("Ben", Role.Operator), ("Sam", Role.Setter), ("Max", Role.Setter) })
        {
            Users.Add(Anna(), name, role, Other);
        }

        Users.Disable(Anna(), "Max");
        _atMachine = Step(Step(Step(Proposed("one"), CorrectionState.Approved, "Sam", "seen"), CorrectionState.Uploading),
            CorrectionState.Verified);
        _proposed = Proposed("two");
        _approved = Step(Proposed("three"), CorrectionState.Approved, "cell", Recorded.PolicyWithin.With(0.05));
        _rejected = Step(Step(Proposed("four"), CorrectionState.Approved, "Sam", "seen"), CorrectionState.Rejected, "Ben", "dirty");
    }

    private AuditTrail Evidence => new(Store, Keys);

    [Fact]
    public void What_the_cell_wrote_holds_and_may_be_sent()
    {
        var finding = Evidence.Verify();
        Assert.True(finding.Holds, finding.Message);
        Assert.Empty(Store.Tampered());
        Store.Outside.DemandRecorded(_approved);
        Store.Outside.DemandRecorded(_atMachine);
        var uploading = Step(Step(_atMachine, CorrectionState.Released, "Ben", "cut") with { }, CorrectionState.Reverted, "Sam", "chatter");
        Store.FreeSlot("mill", "1", uploading.Id, "Ben", "free");
        Store.Outside.DemandRecorded(Step(_approved, CorrectionState.Uploading));
        finding = Evidence.Verify();
        Assert.True(finding.Holds, finding.Message);
        Assert.Empty(Store.Tampered());
    }

    // Each is one statement on the command line of SQLite. The number is of the correction that it is about; quick: a look at the status
    // finds it, without going through the trail.
    [Theory]
    [InlineData("UPDATE correction SET state = 'approved', version = version + 1 WHERE id = 2", 2, AuditFaultKind.RowDiffers,
        "Correction 2 is approved in the store; entry 21 of the audit trail left it proposed.", true)]
    [InlineData("UPDATE correction SET program_sha256 = @own WHERE id = 3", 3, AuditFaultKind.RowDiffers,
        "Correction 3 has the program @own in the store; by entry", true)]
    [InlineData("UPDATE correction SET slot = '2', program = 'O9.nc' WHERE id = 3", 3, AuditFaultKind.RowDiffers,
        "The row of correction 3 is not the one that entry", true)]
    [InlineData("UPDATE correction SET previous_sha256 = @own WHERE id = 1", 1, AuditFaultKind.RowDiffers,
        "The row of correction 1 is not the one that entry", true)]
    [InlineData("UPDATE correction SET measurement_sha256 = @own WHERE id = 3", 3, AuditFaultKind.RowDiffers,
        "Correction 3 has the file @own", true)]
    [InlineData("UPDATE correction SET row_code = NULL WHERE id = 3", 3, AuditFaultKind.RowDiffers, "The row of correction 3", true)]
    [InlineData("UPDATE correction SET version = 'six' WHERE id = 3", 3, AuditFaultKind.RowDiffers,
        "The row of correction 3 is not the one that entry", true)]
    [InlineData("UPDATE correction SET state = 'sent' WHERE id = 2", 2, AuditFaultKind.RowDiffers,
        "The row of correction 2 cannot be read", false)]
    [InlineData("DELETE FROM step WHERE correction = 4; DELETE FROM correction WHERE id = 4", 4, AuditFaultKind.RowDiffers,
        "Correction 4 is not in the store any more", false)]
    [InlineData("INSERT INTO correction (state, version, arrival, gauge, file_name, arrived_at, changed_at, measurement_sha256, "
        + "measurement_bytes) "
        + "VALUES ('approved', 1, 'x', 'g', 'f', 0, 0, @own, 8)", 5, AuditFaultKind.RowDiffers,
            "Correction 5 (approved) is in the store, and no entry", true)]
    [InlineData("UPDATE slot SET correction = NULL", 3, AuditFaultKind.RowDiffers, "Slot 1 of mill is not held by correction 1", true)]
    [InlineData("UPDATE slot SET correction = 3", 3, AuditFaultKind.RowDiffers, "Slot 1 of mill is not held by correction 1", true)]
    [InlineData("UPDATE slot SET previous_sha256 = @own", 3, AuditFaultKind.RowDiffers,
        "The row of slot 1 of mill is not the one that entry", true)]
    [InlineData("DELETE FROM slot", 3, AuditFaultKind.RowDiffers, "Slot 1 of mill is not held by correction 1", false)]
    [InlineData("UPDATE person SET role = 'Administrator' WHERE name = 'Ben'", 0, AuditFaultKind.RowDiffers,
        "The user Ben is Administrator in the store; by entry 4 of the audit trail it is operator.", true)]
    [InlineData("UPDATE person SET role = 'Wizard' WHERE name = 'Ben'", 0, AuditFaultKind.RowDiffers,
        "The user Ben is Wizard in the store", true)]
    [InlineData("UPDATE person SET is_disabled = 0 WHERE name = 'Max'", 0, AuditFaultKind.RowDiffers,
        "The user Max is enabled in the store", true)]
    [InlineData("UPDATE person SET password = (SELECT password FROM person WHERE name = 'Ben') WHERE name = 'Sam'", 0,
        AuditFaultKind.RowDiffers, "The row of the user Sam is not the one that entry", true)]
    [InlineData("DELETE FROM person WHERE name = 'Ben'", 0, AuditFaultKind.RowDiffers, "The user Ben is not in the store any more", false)]
    [InlineData(
        "INSERT INTO person SELECT 'EVE', 'Eve', role, password, 0, added_at, password_at, row_code FROM person WHERE name = 'Anna'", 0,
        AuditFaultKind.RowDiffers, "The user Eve is in the store, and no entry", true)]
    [InlineData("CREATE TRIGGER eve AFTER UPDATE ON correction BEGIN UPDATE correction SET program_sha256 = 'x' WHERE id = new.id; END", 3,
        AuditFaultKind.FormDiffers, "it has the trigger eve, which the cell did not make", true)]
    [InlineData("CREATE VIEW eve AS SELECT 1", 3, AuditFaultKind.FormDiffers, "it has the view eve", true)]
    [InlineData("CREATE TABLE eve (a)", 3, AuditFaultKind.FormDiffers, "it has the table eve", true)]
    [InlineData("CREATE INDEX eve ON person (name)", 3, AuditFaultKind.FormDiffers, "it has the index eve", true)]
    [InlineData("DROP INDEX step_who", 3, AuditFaultKind.FormDiffers, "it lacks the index step_who", true)]
    [InlineData("DROP TRIGGER audit_update", 3, AuditFaultKind.FormDiffers, "it lacks the trigger audit_update", true)]
    [InlineData("ALTER TABLE person ADD COLUMN eve TEXT", 3, AuditFaultKind.FormDiffers, "its table person is another one", true)]
    [InlineData("UPDATE step SET who = 'Sam' WHERE correction = 3 AND to_state = 'approved'", 0, AuditFaultKind.RowDiffers,
        "Step 16 of the store is not what entry", false)]
    [InlineData("INSERT INTO step (correction, from_state, to_state, at, who, basis) VALUES (2, 'proposed', 'approved', 0, 'Sam', 'seen')",
        0, AuditFaultKind.RowDiffers, "The store has 23 steps; the audit trail has 22.", false)]
    public void What_somebody_else_wrote_is_found_and_not_sent(string sql, long correction, AuditFaultKind kind, string message,
        bool isQuick)
    {
        Store.Outside.DemandRecorded(_approved);
        Tamper("INSERT INTO content (sha256, bytes) VALUES (@own, @bytes)", sql);
        var fault = Evidence.Verify().Fault;
        Assert.Equal(kind, fault?.Kind);
        Assert.Contains(message.Replace("@own", OwnSha256, StringComparison.Ordinal), fault!.Message, StringComparison.Ordinal);
        Assert.Equal(isQuick, Store.Tampered().Count > 0);
        if (correction == 0) return;
        Assert.Equal(
            StoreError.Tampered,
            Assert.Throws<StoreException>(() => Store.Outside.DemandRecorded(AsTheWorkerReadsIt(correction))).Error);

        // A process that begins later finds the same.
        using var later = CellStore.Open(new SqliteSettings(PathOf("cell.db")), Clock, Key);
        Assert.Equal(
            StoreError.Tampered,
            Assert.Throws<StoreException>(() => later.Outside.DemandRecorded(AsTheWorkerReadsIt(correction))).Error);
        Assert.Equal(kind, new AuditTrail(later, Keys).Verify().Fault?.Kind);
    }

    [Fact]
    public void A_row_that_is_put_back_with_its_genuine_code_is_not_sent()
    {
        var before = Step(Proposed("five"), CorrectionState.Approved, "Sam", "seen");
        Tamper("CREATE TEMP TABLE kept AS SELECT * FROM correction WHERE id = 5");
        Step(before, CorrectionState.Rejected, "Ben", "dirty");
        Tamper("UPDATE correction SET (state, version, changed_at, code, reason, row_code) = (SELECT state, version, changed_at, code, "
            + "reason, row_code FROM kept) WHERE id = 5");
        Assert.Equal(before, Store.Find(5));
        Assert.Empty(Store.Tampered());
        Assert.StartsWith(
            "not-sent(state-differs(5, approved, ",
            Stated.As(Assert.Throws<StoreException>(() => Store.Outside.DemandRecorded(before)).Statement),
            StringComparison.Ordinal);
        Assert.Equal(AuditFaultKind.RowDiffers, Evidence.Verify().Fault?.Kind);
    }

    [Theory]
    [InlineData("Ben", "who was operator then, and this takes setter")]
    [InlineData("Max", "who was disabled then")]
    [InlineData("Eve", "who was no user then")]
    [InlineData("cell", "and names no policy")]
    public void An_approval_by_nobody_who_may_is_not_sent(string who, string why)
    {
        var approved = Step(_proposed, CorrectionState.Approved, who, "looks right");
        Assert.Contains(why, Assert.Throws<StoreException>(() => Store.Outside.DemandRecorded(approved)).Message, StringComparison.Ordinal);
        var fault = Evidence.Verify().Fault;
        Assert.Equal((AuditFaultKind.NotAllowed, Store.ChangeCount()), fault is null ? default : (fault.Kind, fault.Seq));

        // What else waits is not held up by it, and who is promoted later was not entitled then.
        Store.Outside.DemandRecorded(_approved);
        if (who == "Ben") Users.SetRole(Anna(), "Ben", Role.Setter);
        Assert.Contains(why, Assert.Throws<StoreException>(() => Store.Outside.DemandRecorded(approved)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Who_is_demoted_after_an_approval_was_entitled_to_it()
    {
        var approved = Step(_proposed, CorrectionState.Approved, "Sam", "seen");
        Users.SetRole(Anna(), "Sam", Role.Operator);
        Store.Outside.DemandRecorded(approved);
        Assert.True(Evidence.Verify().Holds);
    }

    [Fact]
    public void The_approval_of_another_correction_is_none_of_this_one()
    {
        // Eve hashes the chain anew as far as she can: the seal she cannot make.
        var (last, of) = (Store.AuditHead(), Store.AuditEntries(0, 100).Last(e => e.What == "approved" && e.Who == "Sam"));
        var copied = AuditEntry.After(last.Hash, last.Seq + 1, of.At, of.Who, of.What, Recorded.Program.With(2, Hash("program two")),
            of.Basis);
        Tamper(
            string.Create(CultureInfo.InvariantCulture, $"INSERT INTO audit (seq, at, who, what, subject, basis, previous, hash) VALUES "
                + $"({copied.Seq}, {StoredTime.Of(copied.At)}, '{copied.Who}', 'approved', '{copied.Subject!.Text}', '{copied.Basis}', "
                + $"'{copied.Previous}', '{copied.Hash}')"),
            string.Create(CultureInfo.InvariantCulture, $"UPDATE audit_head SET seq = {copied.Seq}, hash = '{copied.Hash}'"),
            "UPDATE correction SET state = 'approved', version = version + 1 WHERE id = 2");
        Assert.StartsWith(
            "not-sent(trail-broken(",
            Stated.As(Assert.Throws<StoreException>(() => Store.Outside.DemandRecorded(Store.Find(2)!)).Statement),
            StringComparison.Ordinal);
        Assert.Equal(AuditFaultKind.Unsealed, Evidence.Verify().Fault?.Kind);
    }

    [Theory]
    [InlineData(true), InlineData(false)]
    public void A_trail_without_its_end_sends_nothing(bool hasLooked)
    {
        if (hasLooked) Store.Outside.DemandRecorded(_approved);
        var end = Store.AuditEntries(Store.AuditHead().Seq - 2, 1)[0];
        Tamper(
            "DROP TRIGGER audit_delete",
            string.Create(CultureInfo.InvariantCulture, $"DELETE FROM audit WHERE seq > {end.Seq}"),
            string.Create(CultureInfo.InvariantCulture, $"UPDATE audit_head SET seq = {end.Seq}, hash = '{end.Hash}'"),
            "UPDATE correction SET state = 'approved', version = version - 1 WHERE id = 4");
        Assert.Equal(StoreError.Tampered, Assert.Throws<StoreException>(() => Store.Outside.DemandRecorded(Store.Find(4)!)).Error);
        Assert.Equal(AuditFaultKind.Unsealed, Evidence.Verify().Fault?.Kind);
    }

    [Fact]
    public void A_store_that_is_set_back_as_a_whole_is_found_whatever_checkpoint_it_has()
    {
        Store.Outside.KeepCheckpoint(TestContext.Current.CancellationToken, 0);
        Store.Backup(PathOf("earlier.db"));
        Step(_approved, CorrectionState.Rejected, "Ben", "dirty");
        Store.Outside.KeepCheckpoint(TestContext.Current.CancellationToken, 0);
        Evidence.Remember();
        var later = Store.Database.Snapshot((connection, transaction) => AuditCheckpoint.Find(connection, transaction, Key).Found)!;

        // With its own checkpoint, and with the one of later.
        foreach (var checkpoint in new[] { null, later })
        {
            using var earlier = CellStore.Open(new SqliteSettings(PathOf("earlier.db")), Clock, Key);
            checkpoint?.Keep(earlier.Database, Key);
            Assert.Equal(AuditFaultKind.Removed, new AuditTrail(earlier, Keys).EndFault()?.Kind);
            Assert.Equal(AuditFaultKind.Removed, new AuditTrail(earlier, Keys).Verify().Fault?.Kind);
            earlier.Outside.DemandRecorded(_approved);
            Assert.Equal(checkpoint is not null, earlier.Outside.WhyWhole?.Is(RecordedCheckpoint.Astray) == true);
        }
    }

    [Theory]
    [InlineData("UPDATE audit_checkpoint SET seq = seq - 1")]
    [InlineData("UPDATE audit_checkpoint SET state = x'00'")]
    [InlineData("UPDATE audit_checkpoint SET seq = 'none'")]
    public void A_checkpoint_that_somebody_else_wrote_is_a_fault_of_the_store(string sql)
    {
        Store.Outside.KeepCheckpoint(TestContext.Current.CancellationToken, 0);
        Assert.True(Evidence.Verify().Holds);
        Tamper(sql);
        var fault = Evidence.Verify().Fault;
        Assert.True(fault?.Statement.Is(RecordedCheckpoint.Foreign), fault?.Message);
        using var later = CellStore.Open(new SqliteSettings(PathOf("cell.db")), Clock, Key);
        later.Outside.DemandRecorded(_approved);
        Assert.True(later.Outside.WhyWhole?.Is(RecordedCheckpoint.Foreign));
    }

    [Fact]
    public void No_step_is_taken_from_a_row_that_somebody_else_wrote_but_one_that_ends_it()
    {
        Tamper("INSERT INTO content (sha256, bytes) VALUES (@own, @bytes)", "UPDATE correction SET program_sha256 = @own WHERE id = 2");
        var tampered = Store.Find(2)!;
        Assert.Equal(StoreError.Tampered, Assert.Throws<StoreException>(() => Step(tampered, CorrectionState.Approved, "Sam", "seen"))
            .Error);
        Assert.Equal(tampered, Store.Find(2));
        Step(tampered, CorrectionState.Rejected, "Ben", "not ours");
        Assert.Contains("cell tampered correction(2) correction-tampered(2)", Trail);
        Assert.True(Evidence.Verify().Holds);
        Assert.Empty(Store.Tampered());
    }

    [Theory]
    [InlineData("UPDATE person SET role = 'Administrator' WHERE name = 'Ben'", PeopleError.Tampered)]
    [InlineData("UPDATE person SET password = (SELECT password FROM person WHERE name = 'Anna') WHERE name = 'Ben'", PeopleError.Tampered)]
    [InlineData("UPDATE person SET role = 'Wizard' WHERE name = 'Ben'", PeopleError.UnknownRole)]
    public void A_user_whose_row_somebody_else_wrote_may_do_nothing_until_the_password_is_set_anew(string sql, PeopleError error)
    {
        var signedIn = Users.SignIn("Ben", Other);
        Tamper(sql);
        Refused(error, () => Users.SignIn("Ben", Right));
        Refused(error, () => Users.SignIn("Ben", Other));
        Refused(error, () => Users.Demand(signedIn, Act.See));
        Refused(error, () => Users.SetPassword(signedIn, "Ben", Right));
        Assert.Equal(error, Users.List().Single(u => u.Name == "Ben").Problem?.Error);

        // Nothing of what was written is taken over.
        Users.Enable(Anna(), "Ben");
        Refused(PeopleError.SignInRefused, () => Users.SignIn("Ben", Right));
        Users.SetPassword(Anna(), "Ben", "pickled herring pie");
        Assert.Equal(Role.Operator, Users.SignIn("Ben", "pickled herring pie").Role);
        Assert.True(Evidence.Verify().Holds);
    }

    [Fact]
    public void A_role_that_is_none_is_named_with_its_user_and_gives_no_rights()
    {
        // Without a key nothing but the word itself tells.
        using var store = CellStore.Open(new SqliteSettings(PathOf("other.db")), Clock);
        var users = new UserBook(store, Clock, new PasswordHashes(10));
        users.AddFirst("Anna", Right);
        users.Add(users.SignIn("Anna", Right), "Ben", Role.Operator, Other);
        var signedIn = users.SignIn("Ben", Other);
        store.Write(t => t.Execute("UPDATE person SET role = 'wizard' WHERE name = 'Ben'"));
        foreach (var act in new Action[] { () => users.SignIn("Ben", Other), () => users.Demand(signedIn, Act.See) })
        {
            var refused = Refused(PeopleError.UnknownRole, act);
            Assert.Contains("Ben is \"wizard\"", refused.Message, StringComparison.Ordinal);
        }

        Assert.Equal([(null, "administrator"), (PeopleError.UnknownRole, "wizard")],
            users.List().Select(u => (u.Problem?.Error, u.RoleWord)));
        users.SetRole(users.SignIn("Anna", Right), "Ben", Role.Setter);
        Assert.Equal(Role.Setter, users.SignIn("Ben", Other).Role);
    }

    [Fact]
    public void Users_that_are_removed_on_purpose_to_begin_anew_leave_a_trail_that_holds()
    {
        Tamper("DELETE FROM person");
        Assert.Equal(AuditFaultKind.RowDiffers, Evidence.Verify().Fault?.Kind);
        Users.AddFirst("Zoe", Right);
        var finding = Evidence.Verify();
        Assert.True(finding.Holds, finding.Message);
        Step(_proposed, CorrectionState.Approved, "Sam", "seen");
        Assert.Equal(AuditFaultKind.NotAllowed, Evidence.Verify().Fault?.Kind);
    }

    [Theory]
    [InlineData(null, true)]
    [InlineData("UPDATE correction SET state = 'approved' WHERE id = 2", false)]
    [InlineData("UPDATE person SET role = 'Administrator' WHERE name = 'Ben'", false)]
    [InlineData("UPDATE slot SET correction = NULL", false)]
    public void Rows_of_an_earlier_form_get_codes_only_if_they_are_what_the_trail_says(string? sql, bool holds)
    {
        // As an earlier version left it: no codes, neither in rows nor in entries.
        using (var earlier = Earlier())
        {
            if (sql is not null) Execute(earlier, sql);
        }

        using var store = CellStore.Open(new SqliteSettings(PathOf("earlier.db")), Clock, Key);
        Assert.Equal(holds, store.Tampered().Count == 0);
        var finding = new AuditTrail(store, PathOf("keys")).Verify();
        Assert.True(holds == finding.Holds, finding.Message);
        var approved = store.Find(3)!;
        if (sql is null)
        {
            store.Outside.DemandRecorded(approved);
            Execute(store.Database, "UPDATE correction SET slot = '2', row_code = NULL WHERE id = 3");
            using var again = CellStore.Open(new SqliteSettings(PathOf("earlier.db")), Clock, Key);
            Assert.Equal(StoreError.Tampered, Assert.Throws<StoreException>(() => again.Outside.DemandRecorded(again.Find(3)!)).Error);
        }
    }

    private CellDatabase Earlier()
    {
        Store.Backup(PathOf("earlier.db"));
        var database = StoreOpening.Connect(new SqliteSettings(PathOf("earlier.db")), _ => { });
        Execute(database, "DROP TRIGGER audit_update", "DROP TRIGGER audit_delete", "UPDATE correction SET row_code = NULL",
            "UPDATE slot SET row_code = NULL", "UPDATE person SET row_code = NULL");
        var (previous, last) = (AuditEntry.NoHash, 0L);
        foreach (var e in Store.AuditEntries(0, 1000))
        {
            var plain = AuditEntry.After(previous, e.Seq, e.At, e.Who, e.What, e.Subject, e.Basis);
            database.Change((connection, transaction) => connection.Execute("UPDATE audit SET row_codes = NULL, previous = @Previous, "
                + "hash = @Hash WHERE seq = @Seq", [("Previous", plain.Previous), ("Hash", plain.Hash), ("Seq", plain.Seq)], transaction));
            (previous, last) = (plain.Hash, plain.Seq);
        }

        Execute(database, $"UPDATE audit_head SET hash = '{previous}', seal = '{AuditHead.SealOf(Key, last, previous)}'");
        foreach (var trigger in new[] { "update", "delete" })
        {
            // Word for word as the migration makes it.
            Execute(database, $"CREATE TRIGGER audit_{trigger} BEFORE {trigger.ToUpperInvariant()} ON audit BEGIN SELECT RAISE(ABORT, "
                + $"'audit is append-only'); END");
        }

        return database;
    }

    // Read as the cell reads it; what cannot be read any more is asked for as it was.
    private Correction AsTheWorkerReadsIt(long id)
    {
        try
        {
            return Store.Find(id) ?? _rejected;
        }
        catch (Exception e) when (e is StoreException or InvalidCastException or FormatException)
        {
            return id == 2 ? _proposed : _approved;
        }
    }

    private Correction Proposed(string name)
    {
        var (program, file) = (Encoding.UTF8.GetBytes("program " + name), new Arrival("gauge", name, name, Encoding.UTF8.GetBytes(name)));
        var c = Step(
            Store.Archive(file).Correction,
            CorrectionState.Recognized,
            with: c => c with
            {
                Job = "job",
                Piece = "part",
                Identity = "identity " + name,
                Machine = "mill",
                Slot = "1",
                Program = "O1.nc",
            });
        c = Store.Step(c, CorrectionState.Computed, "cell", "computed", c =>
            c with { ProgramSha256 = Hash("program " + name), LargestMm = 0.0125 }, [program]);
        return Step(c, CorrectionState.Proposed);
    }

    private Correction Step(Correction from, CorrectionState to, string by = "cell", Statement? basis = null, Func<Correction,
        Correction>? with = null) => Store.Step(from, to, by, basis ?? "as it goes", with);

    private void Tamper(params string[] statements) => Execute(Store.Database, statements);

    private static void Execute(CellDatabase database, params string[] statements)
    {
        foreach (var statement in statements)
        {
            database.Change((connection, transaction) =>
                connection.Execute(statement, [("own", OwnSha256), ("bytes", Encoding.UTF8.GetBytes(Own))], transaction));
        }
    }

    private static string Hash(string text) => Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(text)));
}
