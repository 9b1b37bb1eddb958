
namespace ErrorMatching.Cell.Tests;

/// <summary>Where corrections add up: which program cut the measured piece, and what becomes of corrections whose program was taken
/// back.</summary>
public sealed class ProgramThatCutTests : IDisposable
{
    private readonly MemoryMachine _machine = new("m1");

    public void Dispose() => ((IDisposable)_machine).Dispose();

    [Fact]
    public async Task While_nobody_says_that_a_piece_is_cut_nobody_knows_which_program_cut_the_measured_one()
    {
        await using var cell = await WithFirstSent("part.csv", "cp_1.csv");
        cell.Drop("cp_2.csv", PairedCell.Counterpart + "\n");
        var refused = await cell.Until(3, CorrectionState.Refused);
        Assert.Equal("not-released", refused.Code);
        Assert.Contains("release CONFIG 2", refused.Reason!.Sentence, StringComparison.Ordinal);
        var decisions = new CorrectionDecisions(cell.Store);
        decisions.Release(2, "olga", null);
        cell.Drop("cp_2.csv", PairedCell.Counterpart + "\n");

        // The same errors again, although they were corrected: points will be outside their limits, so a person decides.
        await cell.Until(4, CorrectionState.Proposed);
        decisions.Approve(4, "sam", null);
        Assert.Equal(cell.Store.Find(2)!.ProgramSha256, (await cell.Until(4, CorrectionState.Verified)).BaseSha256);
    }

    [Fact]
    public async Task A_piece_whose_own_program_is_released_does_not_wait_for_that_of_another()
    {
        await using var cell = await WithFirstSent("SN1_part.csv", "SN1_cp.csv");
        var decisions = new CorrectionDecisions(cell.Store);
        decisions.Release(2, "olga", null);
        cell.Drop("SN2_part.csv", PairedCell.Part + "\n");
        await cell.Until(3, CorrectionState.Recorded);
        cell.Drop("SN2_cp.csv", PairedCell.Counterpart + "\n");

        // The same errors again, although they were corrected: a person decides.
        await cell.Until(4, CorrectionState.Proposed);
        decisions.Approve(4, "sam", null);
        Assert.Equal(cell.Store.Find(2)!.ProgramSha256, (await cell.Until(4, CorrectionState.Verified)).BaseSha256);
        cell.Drop("SN1_cp_again.csv", NextCounterpart.Of(cell.Store.Content(cell.Store.Find(2)!.ReportSha256!), 1, 1));
        Assert.Equal(cell.Store.Find(2)!.ProgramSha256, (await cell.Until(5, CorrectionState.Approved)).BaseSha256);
        cell.Drop("SN2_cp_again.csv", PairedCell.Counterpart + "\n\n\n");
        Assert.Equal("not-released", (await cell.Until(6, CorrectionState.Refused)).Code);
    }

    [Fact]
    public async Task What_adds_to_a_program_that_is_reverted_meanwhile_is_not_sent()
    {
        await using var cell = await WithFirstSent("part.csv", "cp_1.csv", approve: "person");
        var decisions = new CorrectionDecisions(cell.Store);
        decisions.Release(2, "olga", null);
        cell.Drop("cp_2.csv", PairedCell.Counterpart + "\n");
        await cell.Until(3, CorrectionState.Proposed);
        await Revert(cell, 2);
        decisions.Approve(3, "sam", null);
        decisions.Release(2, "olga", null);
        var failed = await cell.Until(3, CorrectionState.Failed);
        Assert.Equal("base-reverted", failed.Code);
        Assert.Contains("correction 2", failed.Reason!.Sentence, StringComparison.Ordinal);
        Assert.Contains("chatter", failed.Reason!.Sentence, StringComparison.Ordinal);
        Assert.Equal(cell.Store.Find(2)!.PreviousSha256, Hash(_machine.Files["P1.NC"]));

        // Who approves again is told again; rejecting it frees the line, and the original is where corrections begin anew.
        decisions.Approve(3, "sam", null);
        await cell.Until(3, CorrectionState.Failed);
        decisions.Reject(3, "sam", "built on a reverted program");
        cell.Drop("cp_3.csv", PairedCell.Counterpart + "\n\n");
        var next = await cell.Until(4, CorrectionState.Proposed);
        Assert.Equal(cell.Store.Find(2)!.BaseSha256, next.BaseSha256);
    }

    [Fact]
    public async Task What_is_computed_on_a_program_that_is_reverted_meanwhile_is_refused()
    {
        await using var cell = await WithFirstSent("part.csv", "cp_1.csv");
        new CorrectionDecisions(cell.Store).Release(2, "olga", null);
        await cell.StopAsync();

        // The process ends where the next one is computed, and the revert comes before the next start.
        cell.AroundStep = (state, isDone) =>
        {
            if (state == CorrectionState.Proposed && !isDone)
            {
                throw new OperationCanceledException("The process is gone.");
            }
        };
        cell.Start();
        cell.Drop("cp_2.csv", PairedCell.Counterpart + "\n");
        await cell.Until(3, CorrectionState.Computed);
        await cell.BuryAsync();
        await Revert(cell, 2);
        cell.AroundStep = null;
        cell.Start();
        var refused = await cell.Until(3, CorrectionState.Refused);
        Assert.Equal(("base-reverted", null), (refused.Code, refused.Identity));
    }

    [Fact]
    public async Task While_a_reverted_correction_has_the_slot_nobody_knows_either()
    {
        await using var cell = await WithFirstSent("part.csv", "cp_1.csv");
        await Revert(cell, 2);
        cell.Drop("cp_2.csv", PairedCell.Counterpart + "\n");
        var refused = await cell.Until(3, CorrectionState.Refused);
        Assert.Equal("not-released", refused.Code);
        Assert.Contains("was reverted", refused.Reason!.Sentence, StringComparison.Ordinal);
        new CorrectionDecisions(cell.Store).Release(2, "olga", null);
        cell.Drop("cp_2.csv", PairedCell.Counterpart + "\n");
        Assert.Equal(cell.Store.Find(2)!.BaseSha256, (await cell.Until(4, CorrectionState.Verified)).BaseSha256);
    }

    // A part, and a counterpart whose correction is at the machine over the original.
    private async Task<ConfiguredCell> WithFirstSent(string part, string counterpart, string approve = "automatic")
    {
        var cell = PairedCell.Of(accumulates: true, _machine);
        cell.Configuration = cell.Configuration.Replace("automatic", approve, StringComparison.Ordinal);
        _machine.Files["P1.NC"] = File.ReadAllBytes(cell.PathOf("job/counterpart.nc"));
        cell.Start();
        cell.Drop(part, PairedCell.Part);
        await cell.Until(1, CorrectionState.Recorded);
        cell.Drop(counterpart, PairedCell.Counterpart);
        if (approve == "person")
        {
            await cell.Until(2, CorrectionState.Proposed);
            new CorrectionDecisions(cell.Store).Approve(2, "sam", null);
        }

        await cell.Until(2, CorrectionState.Verified);
        return cell;
    }

    private async Task Revert(ConfiguredCell cell, long id) =>
        await new SlotReversal(
            cell.Settings,
            cell.Store,
            _ => _machine,
            TimeProvider.System).RevertAsync(id, "sam", "chatter", TestContext.Current.CancellationToken);

    private static string Hash(byte[] bytes) => Convert.ToHexStringLower(System.Security.Cryptography.SHA256.HashData(bytes));
}
