namespace ErrorMatching.Cell.Tests;

/// <summary>The right to a slot is lost between the look at the machine and the sending: then another cell may be sending.</summary>
public sealed class LostRightTests
{
    [Fact]
    public async Task Without_the_right_to_the_slot_nothing_is_sent()
    {
        if (OperatingSystem.IsWindows())
        {
            return;
        }

        await using var cell = new RunningCell();
        var (machine, isLost) = (cell.Machine["m1"], true);
        machine.Around = (what, isDone) =>
        {
            if (Volatile.Read(ref isLost) && isDone && what == "read " + RunningCell.Program)
            {
                foreach (var file in Directory.EnumerateFiles(cell.Folder, "cell.db.*.lock"))
                {
                    File.Delete(file);
                }
            }
        };
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Approved);
        await cell.UntilLookedAgain("slot m1/A");
        await cell.UntilLookedAgain("slot m1/A");

        // What was seen without the right is not recorded either.
        Assert.Equal(CorrectionState.Approved, cell.Store.Find(1)!.State);
        Assert.DoesNotContain("write", machine.Done);

        Volatile.Write(ref isLost, false);
        await cell.Until(1, CorrectionState.Verified);
        Assert.Contains("write", machine.Done);
        Assert.Null(machine.Broken);
    }
}
