using System.Security.Cryptography;
using System.Text;
using Microsoft.Data.Sqlite;

namespace ErrorMatching.Cell.Tests;

/// <summary>A cell whose store somebody writes to on the command line of SQLite, while it runs: nothing of that reaches a
/// machine.</summary>
public sealed class TamperedCellTests
{
    private const string Own = "G0 Z-500";

    [Theory]
    [InlineData("UPDATE correction SET state = 'approved', version = version + 1 WHERE id = 1")]
    [InlineData("UPDATE correction SET state = 'approved', version = version + 1, program_sha256 = @own WHERE id = 1")]
    [InlineData("CREATE TRIGGER eve AFTER UPDATE ON correction WHEN new.state = 'uploading' BEGIN UPDATE correction SET program_sha256 "
        + "= (SELECT sha256 FROM content LIMIT 1) WHERE id = new.id; END;"
        + "UPDATE correction SET state = 'approved', version = version + 1 WHERE id = 1")]
    public async Task A_correction_that_a_statement_approves_is_not_sent_and_the_cell_says_so(string sql)
    {
        await using var cell = new RunningCell(policy: """{ "approve": "person" }""");
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Proposed);
        Tamper(cell, sql);
        await RunningCell.Until(
            () => TroublesOf(cell).Select(t => t.Where).Intersect(["record", CellTrouble.OfSlot("m1", "A")]).Count() == 2);
        Assert.All(TroublesOf(cell), t => Assert.Equal("store-tampered", t.Code));
        Assert.False(cell.Machine["m1"].Files.ContainsKey(RunningCell.Program));
        Assert.DoesNotContain("write", cell.Machine["m1"].Done);
        Assert.Contains(cell.Store.AuditEntries(0, 100), e => e is { Who: "cell", What: "tampered", Subject.Sentence: "correction 1" });
        Assert.False(CellStatus.Of(cell.Settings, cell.Store, TimeProvider.System).IsHealthy);

        // A person gets rid of it, and the line goes on, unless the database itself was changed.
        new CorrectionDecisions(cell.Store).Reject(1, "sam", "not ours");
        if (sql.StartsWith("CREATE", StringComparison.Ordinal)) Tamper(cell, "DROP TRIGGER eve");
        cell.Drop("a_S2.csv", 2);
        await cell.Until(2, CorrectionState.Proposed);
        new CorrectionDecisions(cell.Store).Approve(2, "sam", null);
        await cell.Until(2, CorrectionState.Verified);
    }

    [Fact]
    public async Task A_slot_that_a_statement_frees_gets_no_other_program()
    {
        await using var cell = new RunningCell();
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        var before = cell.Machine["m1"].Files[RunningCell.Program];
        Tamper(cell, "UPDATE slot SET correction = NULL");
        cell.Drop("a_S2.csv", 2);
        await cell.Until(2, CorrectionState.Approved);
        await RunningCell.Until(() => TroublesOf(cell).Any(t => t is { Code: "store-tampered", Where: "slot m1/A" }));
        Assert.Equal(before, cell.Machine["m1"].Files[RunningCell.Program]);
    }

    [Fact]
    public async Task A_previous_program_that_a_statement_names_is_not_brought_back()
    {
        await using var cell = new RunningCell();
        cell.Machine["m1"].Files[RunningCell.Program] = File.ReadAllBytes(cell.PathOf("job/counterpart.nc"));
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        await cell.StopAsync();
        Tamper(cell, "UPDATE correction SET previous_sha256 = @own WHERE id = 1");
        var reversal = new SlotReversal(cell.Settings, cell.Store, m => cell.Machine[m.Name], TimeProvider.System);
        Assert.Equal(StoreError.Tampered, (await Assert.ThrowsAsync<StoreException>(() =>
            reversal.RevertAsync(1, "sam", "chatter", TestContext.Current.CancellationToken))).Error);
        Assert.NotEqual(Encoding.UTF8.GetBytes(Own), cell.Machine["m1"].Files[RunningCell.Program]);
        Tamper(cell, $"UPDATE correction SET previous_sha256 = '{cell.OriginalHash}' WHERE id = 1");
        await reversal.RevertAsync(1, "sam", "chatter", TestContext.Current.CancellationToken);
        Assert.Equal(File.ReadAllBytes(cell.PathOf("job/counterpart.nc")), cell.Machine["m1"].Files[RunningCell.Program]);
    }

    [Fact]
    public async Task A_cell_keeps_a_checkpoint_and_says_so_if_somebody_else_wrote_it()
    {
        await using var cell = new RunningCell();
        cell.Store.Write(transaction =>
        {
            for (var i = 0; i < OutsideChanges.Rhythm; i++) transaction.Audit("cell", "noted", null, "as it goes");
            return true;
        });
        cell.Start();
        await RunningCell.Until(() => cell.Store.Read("SELECT seq FROM audit_checkpoint", r => r.GetInt64(0)).Count == 1);
        await cell.StopAsync();
        Assert.DoesNotContain(cell.Store.AuditEntries(OutsideChanges.Rhythm, 100), e => e.What == "tampered");

        Tamper(cell, "UPDATE audit_checkpoint SET seq = seq + 1");
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        await RunningCell.Until(() => cell.Store.AuditEntries(OutsideChanges.Rhythm, 100).Any(e =>
            e is { Who: "cell", What: "tampered", Subject: null } && e.Basis.Is(RecordedCheckpoint.Foreign)));
        await cell.StopAsync();

        // The one that it made instead holds.
        using var next = cell.Open();
        next.Outside.DemandRecorded(next.Find(1)!);
        Assert.Null(next.Outside.WhyWhole);
    }

    private static IReadOnlyList<CellTrouble> TroublesOf(RunningCell cell) => Heartbeat.Read(cell.PathOf("logs"))?.Troubles ?? [];

    private static void Tamper(RunningCell cell, string sql)
    {
        var bytes = Encoding.UTF8.GetBytes(Own);
        using var connection = new SqliteConnection($"Data Source={cell.PathOf("cell.db")};Pooling=False");
        connection.Open();
        connection.Execute("PRAGMA busy_timeout = 15000; INSERT OR IGNORE INTO content (sha256, bytes) VALUES (@own, @bytes); " + sql,
            [("own", Convert.ToHexStringLower(SHA256.HashData(bytes))), ("bytes", bytes)]);
    }
}
