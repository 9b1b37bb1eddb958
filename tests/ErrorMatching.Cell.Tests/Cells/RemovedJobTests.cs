namespace ErrorMatching.Cell.Tests;

/// <summary>What waits for a gauge, a job or a slot that is not in the configuration any more is named by the running cell,
/// and goes on when it is back.</summary>
public sealed class RemovedJobTests
{
    private const string Right = """
        "gauges": [{ "name": "cmm", "incoming": "incoming", "files": "*.csv", "finished": "rename", "everyMs": 20 }],
        "machines": [{ "name": "m1", "dialect": "delta-nc300", "transport": { "kind": "folder", "folder": "m1" }, "attempts": 1, "slots": [{ "name": "A", "program": "P1.NC" }] }],
        "jobs": [{ "name": "a", "job": "job/job.json", "gauges": ["cmm"], "recognize": { "fileName": "a_" }, "machine": "m1", "slot": "A" }],
        "policy": { "approve": "person" }
        """;

    [Theory]
    [InlineData("\"name\": \"a\"", "\"name\": \"b\"", CorrectionState.Proposed, false, "job \"a\"")]
    [InlineData("\"name\": \"a\"", "\"name\": \"b\"", CorrectionState.Recognized, false, "job \"a\"")]
    [InlineData("\"name\": \"cmm\"", "\"name\": \"other\"", CorrectionState.Archived, false, "gauge \"cmm\"")]
    [InlineData("\"name\": \"A\"", "\"name\": \"B\"", CorrectionState.Proposed, true, "slot \"A\" of \"m1\"")]
    public async Task What_waits_for_what_is_gone_is_named_until_it_is_back(
        string there, string instead, CorrectionState state, bool isApproved, string named)
    {
        await using var cell = new ConfiguredCell(Right) { Opens = _ => new MemoryMachine("m1") };
        cell.Copy("complex-mating", "job");

        // The process ends before the next state.
        cell.AroundStep = (to, isDone) =>
        {
            if (!isDone && CorrectionSteps.Allows(state, to))
            {
                throw new OperationCanceledException("The process is gone.");
            }
        };
        cell.Start();
        cell.Drop("a_1.csv", PairedCell.Part);
        await cell.Until(1, state);
        await cell.BuryAsync();
        cell.AroundStep = null;
        if (isApproved)
        {
            new CorrectionDecisions(cell.Store).Approve(1, "sam", null);
        }

        cell.Configuration = Right.Replace(there, instead, StringComparison.Ordinal).Replace(
            "\"gauges\": [\"cmm\"]",
            instead.Contains("other", StringComparison.Ordinal) ? "\"gauges\": [\"other\"]" : "\"gauges\": [\"cmm\"]",
            StringComparison.Ordinal)
            .Replace(
                "\"slot\": \"A\"",
                instead.Contains('B', StringComparison.Ordinal) ? "\"slot\": \"B\"" : "\"slot\": \"A\"",
                StringComparison.Ordinal);
        cell.Start();
        await ConfiguredCell.Until(() => cell.Troubles.Any(t => t.Code == "not-configured"));
        var trouble = cell.Troubles.Single(t => t.Code == "not-configured");
        Assert.Contains(named, trouble.Message, StringComparison.Ordinal);
        Assert.StartsWith("Correction 1 (", trouble.Message, StringComparison.Ordinal);
        Assert.False(CellStatus.Of(cell.Settings, cell.Store, TimeProvider.System).IsHealthy);
        await cell.StopAsync();

        cell.Configuration = Right;
        cell.Start();
        await cell.Until(1, isApproved ? CorrectionState.Verified : CorrectionState.Proposed);
        await ConfiguredCell.Until(
            () => Heartbeat.Read(cell.PathOf("logs")) is { Troubles: [] },
            () => string.Join(" ", cell.Troubles));
    }
}
