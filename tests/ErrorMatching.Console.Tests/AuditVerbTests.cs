using System.Security.Cryptography;
using ErrorMatching.Cell;

namespace ErrorMatching.Console.Tests;

public sealed class AuditVerbTests
{
    [Fact]
    public void A_whole_trail_is_exit_0_with_the_number_of_entries()
    {
        using var cell = CellFolder.WithPeople();
        var document = Shell.Json(0, "errormatch/audit-verify/1", "audit", "verify", cell.Config);
        Assert.Equal(
            (true, 4, true),
            (
                document.GetProperty("holds").GetBoolean(),
                document.GetProperty("entries").GetInt32(),
                document.GetProperty("isSealChecked").GetBoolean()));
        Assert.Equal(
            (0, $"4 entries, and all are as they were written.\nThe last one's hash is {document.Text("hash")}.\n", ""),
            Shell.Run("audit", "verify", cell.Config));
    }

    [Theory]
    [InlineData("UPDATE audit SET who = 'eve' WHERE seq = 3", "audit-changed", 3)]
    [InlineData("DELETE FROM audit WHERE seq = 2", "audit-removed", 2)]
    [InlineData(
        "INSERT INTO audit SELECT 5, at, who, what, subject, basis, previous, hash, row_codes FROM audit WHERE seq = 4",
        "audit-inserted",
        5)]
    [InlineData(
        "UPDATE audit SET seq = -2 WHERE seq = 2; UPDATE audit SET seq = 2 WHERE seq = 3; UPDATE audit SET seq = 3 WHERE seq = -2",
        "audit-reordered",
        2)]
    [InlineData("UPDATE audit_head SET seal = NULL", "audit-unsealed", 4)]
    public void A_broken_trail_is_exit_2_and_names_the_first_entry(string tampering, string code, int entry)
    {
        using var cell = CellFolder.WithPeople();
        Execute(cell, "DROP TRIGGER audit_update; DROP TRIGGER audit_delete; " + tampering);
        var error = Shell.Error(2, "audit", "verify", cell.Config);
        Assert.Equal(code, error.Text("code"));
        Assert.Contains($" {entry}", error.Text("message"), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("UPDATE person SET role = 'Administrator' WHERE name = 'Ben'", "audit-row-differs", "user-tampered")]
    [InlineData("UPDATE person SET role = 'wizard' WHERE name = 'Ben'", "audit-row-differs", "unknown-role")]
    [InlineData("UPDATE person SET password = (SELECT password FROM person WHERE name = 'Anna') WHERE name = 'Ben'", "audit-row-differs",
        "user-tampered")]
    [InlineData("CREATE TRIGGER eve AFTER INSERT ON audit BEGIN SELECT 1; END", "audit-form-differs", null)]
    public void A_store_that_somebody_else_wrote_to_is_exit_2_the_status_says_so_and_its_users_may_do_nothing(string tampering,
        string code, string? user)
    {
        using var cell = CellFolder.WithPeople();
        Execute(cell, tampering);
        Assert.Equal(code, Shell.Error(2, "audit", "verify", cell.Config).Text("code"));
        Assert.Contains("store-tampered", Shell.Json(3, "errormatch/cell-status/1", "cell", "status", cell.Config).GetProperty("problems")
            .EnumerateArray().Select(p => p.Text("code")));
        var text = Shell.Run("cell", "status", cell.Config);
        Assert.Contains(user is null ? "the trigger eve, which the cell did not make" : "user Ben", text.Output,
            StringComparison.Ordinal);
        Assert.Contains(user is null ? "the trigger eve, which the cell did not make" : "user Ben", text.Error,
            StringComparison.Ordinal);
        if (user is null) return;
        Assert.Equal([null, user], Shell.Json(2, "errormatch/user-list/1", "user", "list", cell.Config).GetProperty("users")
            .EnumerateArray()
            .Select(u => u.GetProperty("problem") is { ValueKind: System.Text.Json.JsonValueKind.Object } p ? p.Text("code") : null));
        var (exit, output, _) = cell.Piped([CellFolder.Annas], "cell", "reject", cell.Config, "1", "--user", "ben", "--reason", "x",
            "--json");
        Assert.Equal(2, exit);
        Assert.Contains(user, output, StringComparison.Ordinal);
    }

    [Fact]
    public void Without_the_keys_nothing_is_proved_nothing_starts_and_no_new_ones_are_made()
    {
        using var cell = CellFolder.WithPeople();
        Directory.Move(cell["keys"], cell["elsewhere"]);
        foreach (var verb in new[] { "audit verify", "cell run", "user list" })
        {
            var error = Shell.Error(2, [.. verb.Split(' '), cell.Config]);
            Assert.Equal("keys-missing", error.Text("code"));
            Assert.Contains(cell["keys"], error.Text("message"), StringComparison.Ordinal);
        }

        Assert.False(Directory.Exists(cell["keys"]));
    }

    [Fact]
    public void Without_what_says_how_far_the_trail_went_nothing_starts_until_somebody_takes_it_over_on_record()
    {
        using var cell = CellFolder.WithPeople();
        File.Delete(cell["keys/audit.seen"]);
        foreach (var verb in new[] { "audit verify", "cell run", "user list" })
        {
            Assert.Equal("audit-seen-missing", Shell.Error(2, [.. verb.Split(' '), cell.Config]).Text("code"));
        }

        Assert.False(File.Exists(cell["keys/audit.seen"]));
        Assert.True(
            Shell.Json(0, "errormatch/audit-take-over/1", "audit", "take-over", cell.Config, "--reason", "the disk was replaced")
                .GetProperty("takenOver")
                .GetBoolean());
        Assert.Equal(5, Shell.Json(0, "errormatch/audit-verify/1", "audit", "verify", cell.Config).GetProperty("entries").GetInt32());
        Assert.Contains("\"trail-set-back\"", Shell.Run("audit", "export", cell.Config).Output, StringComparison.Ordinal);
        Assert.False(
            Shell.Json(0, "errormatch/audit-take-over/1", "audit", "take-over", cell.Config, "--reason", "again")
                .GetProperty("takenOver")
                .GetBoolean());
    }

    [Fact]
    public void A_store_that_was_set_back_is_found_when_the_cell_starts()
    {
        using var cell = CellFolder.WithPeople();
        File.Copy(cell["cell.db"], cell["older.db"]);
        var settings = CellSettingsReader.Read(cell.Config);
        using (var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.OpenFor(settings), inspect: false))
        {
            store.Audit("Anna", "noted", "later");
            new AuditTrail(store, settings.KeysFolder).Remember();
        }

        File.Move(cell["older.db"], cell["cell.db"], overwrite: true);
        foreach (var verb in new[] { "cell run", "user list", "audit verify" })
        {
            var error = Shell.Error(2, [.. verb.Split(' '), cell.Config]);
            Assert.Equal("audit-removed", error.Text("code"));
            Assert.Contains("5", error.Text("message"), StringComparison.Ordinal);
        }
    }

    [Fact]
    public void The_export_goes_to_standard_output_or_into_a_file()
    {
        using var cell = CellFolder.WithPeople();
        var (exit, csv, error) = Shell.Run("audit", "export", cell.Config);
        Assert.Equal((0, ""), (exit, error));
        Assert.StartsWith(
            "\"number\",\"time\",\"who\",\"what\",\"subject\",\"basis\",\"previous\",\"hash\",\"rows\",\"subjectRecorded\","
                + "\"basisRecorded\"\r\n\"1\",\"2",
            csv,
            StringComparison.Ordinal);
        Assert.Equal(6, csv.Split("\r\n").Length);
        Assert.Contains("\"Anna\",\"user-added\",\"Ben\",\"as operator\"", csv, StringComparison.Ordinal);
        Assert.Contains("\",\"Ben\",\"\u001e[\"\"as-role\"\",\"\"operator\"\"]\"\r\n", csv, StringComparison.Ordinal);

        var document = Shell.Json(0, "errormatch/audit-export/1", "audit", "export", cell.Config, "--out", cell["audit.csv"]);
        Assert.Equal(csv, File.ReadAllText(cell["audit.csv"]));
        Assert.Equal(
            (cell["audit.csv"], 4, Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(cell["audit.csv"])))),
            (document.Text("file"), document.GetProperty("entries").GetInt32(), document.Text("sha256")));
        Assert.Equal(csv, Shell.Json(0, "errormatch/audit-export/1", "audit", "export", cell.Config).Text("csv"));
        Assert.Equal("output-is-input", Shell.Error(1, "audit", "export", cell.Config, "--out", cell.Config).Text("code"));
    }

    [Fact]
    public void A_long_trail_is_written_in_parts_and_is_never_in_memory_as_a_whole()
    {
        using var cell = CellFolder.WithPeople();
        var settings = CellSettingsReader.Read(cell.Config);
        using (var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.Open(settings.KeysFolder), inspect: false))
        {
            // Characters of one to four bytes, so that parts end inside of them too.
            for (var i = 0; i < 25; i++) store.Audit("Anna", "noted", string.Concat(Enumerable.Repeat("aé圖🔧\"", 1000)));
        }

        var (text, json) = (new Written(), new Written());
        Assert.Equal(
            0,
            Application.Run(
                ["audit", "export", cell.Config], new(text, TextWriter.Null, HasColor: false), TestContext.Current.CancellationToken));
        Assert.Equal(
            0,
            Application.Run(
                ["audit", "export", cell.Config, "--json"],
                new(json, TextWriter.Null, HasColor: false),
                TestContext.Current.CancellationToken));
        Shell.Json(0, "errormatch/audit-export/1", "audit", "export", cell.Config, "--out", cell["audit.csv"]);

        var csv = File.ReadAllText(cell["audit.csv"]);
        using var document = System.Text.Json.JsonDocument.Parse(json.ToString());
        Assert.Equal((csv, csv), (text.ToString(), document.RootElement.Text("csv")));
        Assert.InRange(csv.Length, 150_000, int.MaxValue);
        Assert.All([text, json], w => Assert.InRange(w.Longest, 1, 50_000));
    }

    [Fact]
    public void Looking_makes_no_store()
    {
        using var cell = new CellFolder();
        Assert.Equal("store-missing", Shell.Error(1, "audit", "verify", cell.Config).Text("code"));
        Assert.Equal("store-missing", Shell.Error(1, "audit", "export", cell.Config).Text("code"));
        Assert.False(File.Exists(cell["cell.db"]));
    }

    [Fact]
    public void Each_code_about_people_store_and_trail_is_in_the_reference()
    {
        var reference = File.ReadAllText(ErrorMatching.Testing.Repository.PathTo("docs", "reference-console.md"));
        var codes = Enum.GetValues<PeopleError>().Select(CellCodes.Of)
            .Concat(Enum.GetValues<StoreError>().Select(CellCodes.Of))
            .Concat(Enum.GetValues<AuditFaultKind>().Select(CellCodes.Of));
        Assert.All(
            codes.Concat(["no-password", "unknown-machine"]), c => Assert.Contains($"| `{c}` |", reference, StringComparison.Ordinal));
    }

    private static void Execute(CellFolder cell, string sql)
    {
        using var store = Microsoft.Data.Sqlite.SqliteFactory.Instance.CreateConnection();
        store.ConnectionString = $"Data Source={cell["cell.db"]};Pooling=False";
        store.Open();
        using var command = store.CreateCommand();
        command.CommandText = sql;
        command.ExecuteNonQuery();
    }

    private sealed class Written : StringWriter
    {
        public int Longest { get; private set; }

        public override void Write(string? value) => Write(value.AsSpan());

        public override void Write(ReadOnlySpan<char> buffer)
        {
            Longest = Math.Max(Longest, buffer.Length);
            base.Write(buffer);
        }
    }
}
