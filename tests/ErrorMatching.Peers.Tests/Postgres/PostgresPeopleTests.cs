using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>People, secrets and evidence with a real PostgreSQL server: the statements are those of the embedded store.</summary>
[Collection(PostgresTests.Name)]
public sealed class PostgresPeopleTests : IDisposable
{
    private const string Annas = "correct horse battery";
    private const string Bens = "staple of the ox";
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-people-").FullName;
    private readonly CellStore _store;
    private readonly UserBook _users;

    public PostgresPeopleTests(PostgresServer server)
    {
        PostgresServer.IsNeeded();
        _store = CellStore.Open(server.NewDatabase(), TimeProvider.System, AuditKey.Open(Keys));
        _users = new UserBook(_store, TimeProvider.System, new PasswordHashes(10));
        _users.AddFirst("Anna", Annas);
        _users.Add(Anna(), "Ben", Role.Operator, Bens);
    }

    private string Keys => Path.Combine(_folder, "keys");

    public void Dispose()
    {
        _store?.Dispose();
        Directory.Delete(_folder, recursive: true);
    }

    [Fact]
    public void Users_are_kept_changed_and_held_to_their_roles()
    {
        Assert.Equal([("Anna", Role.Administrator), ("Ben", Role.Operator)], _users.List().Select(u => (u.Name, u.Role)));
        Assert.Equal(PeopleError.UserExists, Refused(() => _users.Add(Anna(), "BEN", Role.Setter, Bens)));
        Assert.Equal(PeopleError.NotAllowed, Refused(() => _users.Demand(_users.SignIn("ben", Bens), Act.Approve)));
        _users.SetRole(Anna(), "ben", Role.Setter);
        _users.Demand(_users.SignIn("ben", Bens), Act.Approve);
        Assert.True(_users.Disable(Anna(), "Ben").IsDisabled);
        Assert.Equal(PeopleError.UserDisabled, Refused(() => _users.SignIn("Ben", Bens)));
        Assert.Equal(PeopleError.LastAdministrator, Refused(() => _users.Disable(Anna(), "Anna")));
        _users.Enable(Anna(), "Ben");
        _users.SetPassword(_users.SignIn("Ben", Bens), "Ben", "a third one for Ben");
        Assert.NotNull(_users.SignIn("Ben", "a third one for Ben"));
    }

    [Theory]
    [InlineData("UPDATE person SET role = 'Administrator' WHERE name = 'Ben'", AuditFaultKind.RowDiffers,
        "The user Ben is Administrator in the store")]
    [InlineData("CREATE FUNCTION eve() RETURNS trigger LANGUAGE plpgsql AS 'BEGIN RETURN NEW; END'; CREATE TRIGGER eve BEFORE INSERT ON "
        + "correction FOR EACH ROW EXECUTE FUNCTION eve()", AuditFaultKind.FormDiffers, "it has the function eve")]
    [InlineData("CREATE TRIGGER eve BEFORE INSERT ON person FOR EACH ROW EXECUTE FUNCTION suppress_redundant_updates_trigger()",
        AuditFaultKind.FormDiffers, "it has the trigger person.eve")]
    [InlineData("ALTER TABLE audit DISABLE TRIGGER audit_change", AuditFaultKind.FormDiffers, "it has the trigger audit.audit_change 58 D")]
    [InlineData("CREATE OR REPLACE FUNCTION audit_is_append_only() RETURNS trigger LANGUAGE plpgsql AS 'BEGIN RETURN OLD; END'",
        AuditFaultKind.FormDiffers, "it has the function audit_is_append_only BEGIN RETURN OLD; END")]
    [InlineData("CREATE RULE eve AS ON UPDATE TO slot DO INSTEAD NOTHING", AuditFaultKind.FormDiffers, "it has the rule slot.eve")]
    [InlineData("CREATE VIEW eve AS SELECT 1", AuditFaultKind.FormDiffers, "it has the view eve")]
    [InlineData("ALTER TABLE person ALTER COLUMN role SET DEFAULT 'Administrator'", AuditFaultKind.FormDiffers,
        "it has the column person.role with a value of its own")]
    [InlineData("CREATE INDEX eve ON person (name)", AuditFaultKind.FormDiffers, "it has the index eve")]
    [InlineData("DROP INDEX correction_uncoded", AuditFaultKind.FormDiffers, "it lacks the index correction_uncoded")]
    public void What_somebody_else_wrote_to_the_server_is_found(string sql, AuditFaultKind kind, string message)
    {
        var whole = new AuditTrail(_store, Keys).Verify();
        Assert.True(whole.Holds, whole.Message);
        Assert.Empty(_store.Tampered());
        _store.Write(t => t.Execute(sql));
        var fault = new AuditTrail(_store, Keys).Verify().Fault;
        Assert.Equal(kind, fault?.Kind);
        Assert.Contains(message, fault!.Message, StringComparison.Ordinal);
        Assert.NotEmpty(_store.Tampered());
    }

    [Theory]
    [InlineData("Ben"), InlineData("Nobody")]
    public void A_name_is_locked_whether_it_is_a_users_or_not(string name)
    {
        for (var i = 0; i < 5; i++)
        {
            Assert.Equal(PeopleError.SignInRefused, Refused(() => _users.SignIn(name, "wrong")));
        }

        Assert.Equal(PeopleError.LockedOut, Refused(() => _users.SignIn(name, Bens)));
        Assert.NotNull(Anna());
    }

    [Fact]
    public async Task Many_tries_at_once_are_not_more_than_one_after_another()
    {
        var tries = await Task.WhenAll(Enumerable.Range(0, 16).Select(_ => Task.Run(() => Refused(() => _users.SignIn("Ben", "wrong")))));
        Assert.Equal((5, 11), (tries.Count(e => e == PeopleError.SignInRefused), tries.Count(e => e == PeopleError.LockedOut)));
    }

    [Fact]
    public void Secrets_are_kept_replaced_and_removed()
    {
        var secrets = new MachineSecrets(_store, Keys);
        secrets.Set("vmc1", "s3cret", "Anna");
        secrets.Set("vmc1", "another", "Anna");
        Assert.Equal(("another", null), (secrets.Get("vmc1"), secrets.Get("vmc2")));
        Assert.True(secrets.Remove("vmc1", "Anna"));
        Assert.Null(secrets.Get("vmc1"));
    }

    [Fact]
    public void The_trail_is_proved_and_exported()
    {
        var trail = new AuditTrail(_store, Keys);
        var finding = trail.Verify();
        Assert.Equal((true, 4L), (finding.Holds, finding.Entries));
        using var csv = new StringWriter();
        Assert.Equal(4, trail.Export(csv));
        Assert.Contains("\"Anna\",\"user-added\",\"Ben\",\"as operator\"", csv.ToString(), StringComparison.Ordinal);
        _store.Write(t => t.Execute("DROP TRIGGER audit_change ON audit"));
        _store.Write(t => t.Execute("UPDATE audit SET who = 'eve' WHERE seq = 2"));
        Assert.Equal((AuditFaultKind.Changed, 2L), trail.Verify().Fault is { } fault ? (fault.Kind, fault.Seq) : default);
    }

    private SignedIn Anna() => _users.SignIn("Anna", Annas);

    private static PeopleError Refused(Action act) => Assert.Throws<PeopleException>(act).Error;
}
