namespace ErrorMatching.Cell.Tests;

public sealed class ProposingTests
{
    private const string ByPerson = """{ "approve": "person" }""";

    [Theory]
    [InlineData("""{ "approve": "automatic", "limitMm": 0.001 }""")]
    [InlineData("""{ "approve": "automatic", "sumLimitMm": 0.001 }""")]
    public async Task What_was_proposed_goes_by_the_limits_that_hold_when_the_policy_approves_it(string narrower)
    {
        await using var cell = new RunningCell(ByPerson);
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Proposed);
        await cell.StopAsync();
        cell.Policy = narrower;
        cell.Start();
        await cell.UntilLookedAgain("approval");
        Assert.Equal(CorrectionState.Proposed, cell.Store.Find(1)!.State);
        await cell.StopAsync();
        cell.Policy = """{ "approve": "automatic", "limitMm": 0.5 }""";
        cell.Start();
        await cell.Until(1, CorrectionState.Verified);
        Assert.Contains(
            ("cell", "policy-within(0.5)"), cell.Store.Corrections.StepsOf(1).Select(s => (s.By, Stated.As(s.Basis))));
    }

    // The pair wants a gap along L1, which the compensation closes: its points stay outside their limits.
    [Fact]
    public async Task What_the_verdict_says_not_to_cut_waits_for_a_person()
    {
        await using var cell = new RunningCell();
        var job = File.ReadAllText(cell.PathOf("job/job.json"));
        var limits = job.IndexOf("[-0.05, 0.05]", job.IndexOf("\"name\": \"L1\"", StringComparison.Ordinal), StringComparison.Ordinal);
        File.WriteAllText(cell.PathOf("job/job.json"), job[..limits] + "[0.01, 0.05]" + job[(limits + "[-0.05, 0.05]".Length)..]);
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Proposed);
        await cell.StopAsync();
        cell.Start();
        await cell.UntilLookedAgain("approval");

        Assert.Equal(CorrectionState.Proposed, cell.Store.Find(1)!.State);
        Assert.StartsWith(
            "not-to-cut; ",
            Stated.As(cell.Store.Corrections.StepsOf(1).Single(s => s.To == CorrectionState.Proposed).Basis),
            StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_newer_measurement_takes_the_place_of_one_of_the_same_work_order_only()
    {
        await using var cell = new RunningCell(ByPerson);
        cell.Start();
        cell.Drop("b_S1_WO1.csv", 1);
        Assert.Equal(("S1", "WO1"), await cell.Until(1, CorrectionState.Proposed) is var first ? (first.Serial, first.WorkOrder) : default);
        cell.Drop("b_S1_WO2.csv", 2);
        await cell.Until(2, CorrectionState.Proposed);
        Assert.Equal(CorrectionState.Proposed, cell.Store.Find(1)!.State);
        cell.Drop("b_S1_WO1_again.csv", 3);
        await cell.Until(3, CorrectionState.Proposed);
        Assert.Equal((CorrectionState.Superseded, CorrectionState.Proposed), (cell.Store.Find(1)!.State, cell.Store.Find(2)!.State));
    }
}
