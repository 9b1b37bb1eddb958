using System.Text;
using ErrorMatching.Cell;
using ErrorMatching.Json;
using ErrorMatching.Testing;
using Npgsql;

namespace ErrorMatching.Peers.Tests;

/// <summary>The roles that are installed with a store on PostgreSQL: each can do its work, and no more.</summary>
[Collection(PostgresTests.Name)]
public sealed class DatabaseRolesTests(PostgresServer server) : IDisposable
{
    private static readonly byte[] Key = [.. Enumerable.Range(1, 32).Select(i => (byte)i)];
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void A_reader_sees_everything_but_passwords_and_changes_nothing()
    {
        var reader = Role("errormatch_reader", out var cell);
        using var store = CellStore.OpenToRead(reader, TimeProvider.System, null);

        Assert.Equal([2, 1], store.Search(new HistoryQuery()).Select(c => c.Id));
        Assert.Equal("points", Encoding.UTF8.GetString(store.Content(store.Find(1)!.MeasurementSha256)));
        Assert.Equal(["archived", "failed"], store.Corrections.StepsOf(2).Select(s => CorrectionRow.Word(s.To)));
        Assert.Null(store.VerifyAudit());
        Assert.Equal(StoreError.Denied, Assert.Throws<StoreException>(() => store.Audit("ben", "approved", "")).Error);
        Denied(reader, "SELECT * FROM person", "SELECT * FROM machine_secret", "SELECT * FROM event_cursor", "DELETE FROM correction",
            "UPDATE slot SET correction = NULL", "CREATE TABLE x (y INT)");
        cell.Dispose();
    }

    [Fact]
    public void A_station_decides_and_can_neither_delete_nor_read_the_passwords_of_machines()
    {
        var station = Role("errormatch_station", out var cell);
        using var store = CellStore.Open(station, TimeProvider.System, Key);
        var users = new UserBook(store, TimeProvider.System, new PasswordHashes(10));

        Assert.Throws<PeopleException>(() => users.SignIn("ben", "a wrong password"));
        var by = users.SignIn("ben", "correct horse battery");
        users.Demand(by, Act.Reject);
        new CorrectionDecisions(store).Reject(2, by.Name, "scratched");

        Assert.Equal(CorrectionState.Rejected, cell.Find(2)!.State);

        // It stores files of its own, such as those of a job, and one that is there already stays as it is.
        store.Audit("ben", "noted", "", null, "a job"u8.ToArray());
        store.Audit("ben", "noted", "", null, "points"u8.ToArray());
        Assert.Equal("a job", Encoding.UTF8.GetString(cell.Content(ContentHash.Sha256("a job"u8))));
        Assert.Equal("points", Encoding.UTF8.GetString(cell.Content(cell.Find(1)!.MeasurementSha256)));
        Assert.Null(cell.VerifyAudit());
        Assert.Empty(cell.Tampered());
        Denied(station, "DELETE FROM correction", "DELETE FROM audit", "DELETE FROM person", "TRUNCATE step", "DROP TABLE slot",
            "ALTER TABLE audit DISABLE TRIGGER ALL", "SELECT * FROM machine_secret", "INSERT INTO person SELECT * FROM person",
            "UPDATE audit SET who = 'anna'", "DELETE FROM audit_checkpoint", "UPDATE audit_checkpoint SET seq = 1",
            "UPDATE content SET bytes = ''", "CREATE TABLE x (y INT)");
        cell.Dispose();
    }

    // A store of the cell with two files, one of which waits for a decision, and a login of a role.
    private PostgresSettings Role(string role, out CellStore cell)
    {
        PostgresServer.IsNeeded();
        var owner = server.NewDatabase();
        cell = CellStore.Open(owner, TimeProvider.System, Key);
        var users = new UserBook(cell, TimeProvider.System, new PasswordHashes(10));
        users.AddFirst("ben", "correct horse battery");
        for (var i = 0; i < 2; i++)
        {
            var name = FormattableString.Invariant($"{i}.csv");
            cell.Archive(new Arrival("cmm", name, name, "points"u8.ToArray()));
        }

        var state = cell.Find(2)!;
        cell.Step(state, CorrectionState.Failed, "cell", "the disk was full");
        server.Execute(owner.Database, File.ReadAllText(Repository.PathTo("deploy", "postgres-roles.sql")));
        var login = $"{role}_{owner.Database}";
        server.Execute(owner.Database, $"CREATE ROLE {login} LOGIN PASSWORD 'of a role' IN ROLE {role}");
        var file = _folder.File("pgpass", $"127.0.0.1:*:*:{login}:of a role\n");
        PostgresServer.SetMode(file, "600");
        return owner with { User = login, PasswordFile = file };
    }

    private static void Denied(PostgresSettings login, params string[] statements)
    {
        using var connection = new NpgsqlConnection(PostgresDatabase.Connection(login).ConnectionString + ";Pooling=false");
        connection.Open();
        foreach (var sql in statements)
        {
            using var command = new NpgsqlCommand(sql, connection);
            Assert.Equal("42501", Assert.Throws<PostgresException>(() => command.ExecuteNonQuery()).SqlState);
        }
    }
}
