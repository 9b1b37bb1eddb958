using System.Security.Cryptography;
using ErrorMatching.Reporting;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>A store that the version before wrote, which recorded English sentences: what it holds was read out of a store of that
/// version.</summary>
public sealed class EarlierStoreTests : IDisposable
{
    private const long Entries = 40;
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-earlier-").FullName;
    private readonly WorkClock _clock = new();

    public EarlierStoreTests()
    {
        var key = SHA256.HashData("earlier version"u8);
        var keys = new KeyRing(PathOf("keys"));
        AuditWitness.Begin(PathOf("keys"));
        keys.WriteNew("audit.key", keys.Protect(["seal of the audit trail"], Convert.ToBase64String(key)));
        Fill(new SqliteSettings(PathOf("cell.db")));
        Store = CellStore.Open(new SqliteSettings(PathOf("cell.db")), _clock, key);
    }

    private CellStore Store { get; }

    private AuditTrail Evidence => new(Store, PathOf("keys"));

    public void Dispose()
    {
        Store.Dispose();
        Directory.Delete(_folder, recursive: true);
    }

    [Fact]
    public void It_verifies_and_nothing_in_it_is_changed()
    {
        var before = Store.AuditHead();
        var finding = Evidence.Verify();
        Assert.True(finding.Holds, finding.Message);
        Assert.Equal((Entries, before.Hash), (finding.Entries, finding.Hash));
        Assert.Empty(Store.Tampered());
        Assert.Equal(before, Store.AuditHead());
    }

    [Fact]
    public void Its_sentences_are_words_as_they_were_written()
    {
        Assert.All(Store.AuditEntries(0, 100), e => Assert.NotNull(e.Basis.Words));
        Assert.All(Store.AuditEntries(0, 100).Where(e => e.Subject is not null), e => Assert.NotNull(e.Subject!.Words));
        Assert.Equal(
            [
                "arrived from gauge as two.csv",
                "part of job",
                "displaced by at most 0.0125 mm at block N150. C1 has 3 key points on 40 mm; one per 5 mm is recommended.",
                "displaced by at most 0.0125 mm",
                "policy: automatic within 0.05 mm",
            ],
            Store.Corrections.StepsOf(2).Select(s => s.Basis.Words));
        Assert.Equal(
            "Correction 1 (one.csv, released) has the same measurement, job and program: a correction is applied once.",
            Store.Find(4)!.Reason!.Words);
        using var csv = new StringWriter();
        Assert.Equal(Entries, Evidence.Export(csv));
        Assert.Contains(
            "\"slot 1 of mill\",\"O1.nc at mill is the program of correction 1 again.\",", csv.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Its_approvals_are_known_and_it_goes_on_with_statements()
    {
        // By the policy, in English, before this version; by a setter whose role was given in English.
        var approved = Store.Find(2)!;
        Store.Outside.DemandRecorded(approved);
        var uploading = Store.Step(approved, CorrectionState.Uploading, "cell", Recorded.SlotEmpty.With());
        Store.Outside.DemandRecorded(uploading);
        Store.Step(uploading, CorrectionState.Verified, "cell", Recorded.ReadBack.With());
        Assert.Equal(Role.Setter, new UserBook(Store, _clock, new PasswordHashes(10)).List().Single(u => u.Name == "Sam").Role);
        var finding = Evidence.Verify();
        Assert.True(finding.Holds, finding.Message);
        Assert.Equal("\u001e[\"program\",\"2\",\"" + approved.ProgramSha256 + "\"]", Store.AuditEntries(Entries, 1)[0].Subject!.Text);
    }

    [Theory]
    [InlineData("UPDATE audit SET basis = 'seen twice' WHERE basis = 'seen'", AuditFaultKind.Changed)]
    [InlineData("UPDATE step SET basis = 'seen twice' WHERE basis = 'seen'", AuditFaultKind.RowDiffers)]
    [InlineData("UPDATE correction SET reason = 'clean' WHERE reason = 'dirty'", AuditFaultKind.RowDiffers)]
    [InlineData("UPDATE step SET basis = '\u001e[\"policy-within\",\"0.05\"]' WHERE basis LIKE 'policy%'", AuditFaultKind.RowDiffers)]
    public void Who_changes_a_sentence_in_it_is_found(string sql, AuditFaultKind kind)
    {
        Execute(Store.Database, "DROP TRIGGER audit_update", sql, Trigger("update"));
        Assert.Equal(kind, Evidence.Verify().Fault?.Kind);
    }

    [Fact]
    public void The_versions_of_its_jobs_are_found()
    {
        var saved = Store.AuditEntries(0, 100).Single(e => e.What == "job-edited");
        Assert.Equal(["theoretical.csv", "job.json"], EnglishRecord.JobFilesOf(saved.Basis).Select(f => f.Name));
        Assert.All(EnglishRecord.JobFilesOf(saved.Basis), f => Assert.NotEmpty(Store.Content(f.Sha256)));
    }

    [Theory]
    [InlineData("correction 5", 5L, null, null)]
    [InlineData("correction 5 file ab c", 5L, "ab c", null)]
    [InlineData("correction 5 program ab", 5L, null, "ab")]
    [InlineData("correction 5 program", null, null, null)]
    [InlineData("correction 5\n", null, null, null)]
    [InlineData("correction -5", null, null, null)]
    [InlineData("correction 55555555555555555555", null, null, null)]
    [InlineData("my correction 5", null, null, null)]
    public void The_replay_reads_the_subjects_of_earlier_entries_strictly(string subject, long? id, string? file, string? program) =>
        Assert.Equal(id is { } known ? (known, file, program) : null, EnglishRecord.CorrectionOf(subject));

    [Fact]
    public void The_replay_reads_no_statement_as_an_earlier_sentence()
    {
        Assert.Null(EnglishRecord.CorrectionOf(Recorded.Correction.With(5)));
        Assert.False(EnglishRecord.IsPolicy(Statement.InARow("policy: automatic", "and more")));
        Assert.True(EnglishRecord.IsPolicy("policy: automatic"));
        Assert.False(EnglishRecord.IsPolicy("by policy: automatic"));
        Assert.Equal("setter", EnglishRecord.RoleOf("to setter"));
        Assert.Null(EnglishRecord.RoleOf("into setter"));
    }

    private string PathOf(string name) => Path.Combine(_folder, name);

    private void Fill(SqliteSettings settings)
    {
        using var database = StoreOpening.Connect(settings, d => Migrations.Apply(d, _clock, null, upTo: 5));
        Execute(database, "DROP TRIGGER audit_update", "DROP TRIGGER audit_delete", "DELETE FROM audit", "DELETE FROM audit_head",
            File.ReadAllText(Repository.PathTo("tests", "ErrorMatching.Cell.Tests", "Evidence", "earlier-store.sql")), Trigger("update"),
            Trigger("delete"));
    }

    // Word for word as the migration makes it.
    private static string Trigger(string change) =>
        $"CREATE TRIGGER audit_{change} BEFORE {change.ToUpperInvariant()} ON audit BEGIN SELECT RAISE(ABORT, 'audit is append-only'); END";

    private static void Execute(CellDatabase database, params string[] statements)
    {
        foreach (var statement in statements)
        {
            database.Change((connection, transaction) => connection.Execute(statement, transaction: transaction));
        }
    }
}
