namespace ErrorMatching.Cell.Tests;

/// <summary>Which part a counterpart is compared with.</summary>
public sealed class MeasuredPartTests
{
    [Theory]
    [InlineData("SN7_part.csv", "SN7_cp.csv")]
    [InlineData("WO1_part.csv", "WO1_cp.csv")]
    [InlineData("WO1_SN7_part.csv", "WO1_SN7_cp.csv")]
    [InlineData("WO1_part.csv", "WO1_SN7_cp.csv")]
    [InlineData("WO1_SN7_part.csv", "SN7_cp.csv")]
    [InlineData("part.csv", "cp.csv")]
    [InlineData("SN7_part.csv", "cp.csv")]
    public async Task A_counterpart_is_compared_with_the_part_of_its_number(string part, string counterpart)
    {
        await using var cell = PairedCell.Of(accumulates: false, new("m1"));
        cell.Start();
        cell.Drop(part, PairedCell.Part);
        await cell.Until(1, CorrectionState.Recorded);
        cell.Drop(counterpart, PairedCell.Counterpart);
        Assert.Equal(cell.Store.Find(1)!.MeasurementSha256, (await cell.Until(2, CorrectionState.Verified)).PartSha256);
    }

    [Theory]
    [InlineData("SN8_part.csv", "SN7_cp.csv", "serial number 7")]
    [InlineData("part.csv", "SN7_cp.csv", "serial number 7")]
    [InlineData("WO2_part.csv", "WO1_cp.csv", "work order WO1")]
    [InlineData("WO2_SN7_part.csv", "WO1_SN7_cp.csv", "serial number 7 and work order WO1")]
    [InlineData("WO1_SN8_part.csv", "WO1_SN7_cp.csv", "serial number 7 and work order WO1")]
    public async Task A_counterpart_of_another_number_is_refused_and_its_number_named(string part, string counterpart, string named)
    {
        var machine = new MemoryMachine("m1");
        await using var cell = PairedCell.Of(accumulates: false, machine);
        cell.Start();
        cell.Drop(part, PairedCell.Part);
        await cell.Until(1, CorrectionState.Recorded);
        cell.Drop(counterpart, PairedCell.Counterpart);
        var refused = await cell.Until(2, CorrectionState.Refused);
        Assert.Equal(("part-unmeasured", null), (refused.Code, refused.PartSha256));
        Assert.Contains($"with {named} is", refused.Reason!.Sentence, StringComparison.Ordinal);
        Assert.Empty(machine.Files);

        // Its own part, and the same file again.
        cell.Drop(counterpart.Replace("cp", "part", StringComparison.Ordinal), PairedCell.Part + "\n");
        await cell.Until(3, CorrectionState.Recorded);
        cell.Drop(counterpart, PairedCell.Counterpart);
        Assert.Equal(cell.Store.Find(3)!.MeasurementSha256, (await cell.Until(4, CorrectionState.Verified)).PartSha256);
    }

    [Fact]
    public async Task The_part_may_be_that_of_another_entry_for_the_same_job()
    {
        await using var cell = PairedCell.Of(accumulates: false, new("m1"), twice: true);
        cell.Start();
        cell.Drop("part.csv", PairedCell.Part);
        await cell.Until(1, CorrectionState.Recorded);
        cell.Drop("cp.csv", PairedCell.Counterpart);
        Assert.Equal(cell.Store.Find(1)!.MeasurementSha256, (await cell.Until(2, CorrectionState.Verified)).PartSha256);
    }

    [Theory]
    [InlineData("SN7_cp.csv", true)]
    [InlineData("SN8_cp.csv", false)]
    public async Task A_counterpart_of_a_feed_forward_job_verifies_the_program_of_its_part(string counterpart, bool isKnown)
    {
        await using var cell = new ConfiguredCell("""
            "gauges": [{ "name": "cmm", "incoming": "incoming", "files": "*.csv", "finished": "rename", "everyMs": 20 }],
            "machines": [{ "name": "m1", "dialect": "delta-nc300", "transport": { "kind": "folder", "folder": "m1" }, "slots": [{ "name": "A", "program": "P1.NC" }] }],
            "jobs": [
              { "name": "parts", "job": "job/job.json", "gauges": ["cmm"], "recognize": { "fileName": "^SN(?<serial>[0-9]+)_part" }, "machine": "m1", "slot": "A" },
              { "name": "counterparts", "job": "job/job.json", "gauges": ["cmm"], "recognize": { "fileName": "^SN(?<serial>[0-9]+)_cp" }, "piece": "counterpart", "machine": "m1", "slot": "A" }
            ],
            "policy": { "approve": "automatic" }
            """) { Opens = _ => new MemoryMachine("m1") };
        cell.Copy("complex-mating", "job");
        cell.Start();
        cell.Drop("SN7_part.csv", PairedCell.Part);
        var sent = await cell.Until(1, CorrectionState.Verified);
        cell.Drop(counterpart, PairedCell.Counterpart);
        var recorded = await cell.Until(2, CorrectionState.Recorded);
        Assert.Equal(isKnown ? sent.MeasurementSha256 : null, recorded.PartSha256);
        Assert.Equal(isKnown, recorded.ReportSha256 is not null);
        if (isKnown)
        {
            using var report = System.Text.Json.JsonDocument.Parse(cell.Store.Content(recorded.ReportSha256!));
            Assert.Equal("errormatch/verify/1", report.RootElement.GetProperty("schema").GetString());
            Assert.NotEmpty(cell.Store.Content(recorded.PageSha256!));
        }
    }
}
