using System.Text;

namespace ErrorMatching.Cell.Tests;

/// <summary>Nothing is sent that the control would call otherwise than its slot, or as another program of the machine.</summary>
public sealed class SlotNamesTests
{
    [Fact]
    public async Task A_number_that_a_file_at_the_machine_has_too_is_not_sent_until_it_is_gone()
    {
        await using var cell = Cell();
        cell.Machine["m1"].Files["0211.TXT"] = [1];
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        var failed = await cell.Until(1, CorrectionState.Failed);
        Assert.Equal("program-name-taken", failed.Code);
        Assert.Contains("0211.TXT", failed.Reason!.Sentence, StringComparison.Ordinal);
        Assert.Equal(cell.OriginalHash, RunningCell.Hash(cell.Machine["m1"].Files[RunningCell.Program]));

        cell.Machine["m1"].Files.TryRemove("0211.TXT", out _);
        new CorrectionDecisions(cell.Store).Approve(1, "sam", "removed");
        await cell.Until(1, CorrectionState.Verified);
    }

    [Fact]
    public async Task A_number_of_another_slots_program_is_not_sent()
    {
        await using var cell = Cell();
        File.Copy(cell.PathOf("job/counterpart.nc"), cell.PathOf("job/counterpart-b.nc"), overwrite: true);
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        var failed = await cell.Until(1, CorrectionState.Failed);
        Assert.Equal("program-name-taken", failed.Code);
        Assert.Contains("slot B", failed.Reason!.Sentence, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("O0211.NC", null)]
    [InlineData("O2001.NC", "program-named-otherwise")]
    public async Task A_number_that_the_slots_file_denies_is_not_sent(string file, string? code)
    {
        await using var cell = Cell();
        cell.SlotFile = file;
        cell.Machine["m1"].Files.Clear();
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        var end = await cell.Until(1, code is null ? CorrectionState.Verified : CorrectionState.Failed);
        Assert.Equal(code, end.Code);
        Assert.Equal(code is null ? [file] : [], cell.Machine["m1"].Files.Keys);
    }

    // The original before had another number: a person looks once.
    [Fact]
    public async Task A_program_of_another_number_in_the_slot_is_replaced_only_if_a_person_means_it()
    {
        await using var cell = Cell();
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        new CorrectionDecisions(cell.Store).Release(1, "sam", "cut");
        var text = await File.ReadAllTextAsync(cell.PathOf("job/counterpart.nc"), TestContext.Current.CancellationToken);
        text = text.Replace("O0211", "O0777", StringComparison.Ordinal);
        await File.WriteAllTextAsync(cell.PathOf("job/counterpart.nc"), text, TestContext.Current.CancellationToken);
        cell.Drop("a_S2.csv", 2);
        var failed = await cell.Until(2, CorrectionState.Failed);
        Assert.Equal("program-named-otherwise", failed.Code);
        Assert.EndsWith(", m1, O0211, O0777)", Stated.As(failed.Reason), StringComparison.Ordinal);
        new CorrectionDecisions(cell.Store).Approve(2, "sam", "meant");
        await cell.Until(2, CorrectionState.Verified);
        Assert.Contains("O0777", Encoding.ASCII.GetString(cell.Machine["m1"].Files[RunningCell.Program]), StringComparison.Ordinal);
    }

    private static RunningCell Cell()
    {
        var cell = new RunningCell();
        cell.Machine["m1"].Files[RunningCell.Program] = File.ReadAllBytes(cell.PathOf("job/counterpart.nc"));
        return cell;
    }
}
