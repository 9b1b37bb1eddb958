using System.Globalization;
using System.Text;
using ErrorMatching.Cell;
using ErrorMatching.Cell.Tests;
using ErrorMatching.Nc;

namespace ErrorMatching.Peers.Tests;

/// <summary>What a cell delivers for an offset, and for its revert, on LinuxCNC's own interpreter: where the unchanged program then leads
/// the tool's center.</summary>
public sealed class DeliveredOffsetTests
{
    [Fact]
    public async Task A_delivered_offset_works_once_and_its_revert_leaves_the_control_as_before()
    {
        Rs274.IsNeeded();
        await using var cell = OffsetCell.Of();
        cell.Start();
        cell.Drop("part_S1.csv", OffsetCell.Grown(0.02));
        await cell.Until(1, CorrectionState.Verified);
        var wear = Text(cell);
        await cell.StopAsync();
        await new SlotReversal(cell.Settings, cell.Store, cell.Opens, TimeProvider.System).RevertAsync(
            1, "sam", "chatter", TestContext.Current.CancellationToken);
        var undo = Text(cell);
        new CorrectionDecisions(cell.Store).Release(1, "sam", null);
        cell.Start();
        cell.Drop("part_S2.csv", OffsetCell.Shifted(0.01, -0.02));
        await cell.Until(2, CorrectionState.Verified);
        var shift = Text(cell);

        // The tool's center goes 3 mm beside the rectangle of 40 by 30 mm, and farther by what the part has grown.
        Assert.Equal((-3, 43, 33), Sides());
        Assert.Equal((-3.02, 43.02, 33.02), Sides(wear));
        Assert.Equal((-3.02, 43.02, 33.02), Sides(wear, wear));
        Assert.Equal((-3, 43, 33), Sides(wear, undo));
        Assert.Equal((-3, 43, 33), Sides(wear, undo, undo));
        Assert.Equal((-3, 43, 33), Sides(undo));
        Assert.Equal((-3.02, 43.01, 32.98), Sides(wear, shift));
    }

    private static string Text(ConfiguredCell cell) => Encoding.ASCII.GetString(OffsetCell.Sent(cell));

    // Where the bottom, the right and the top are cut, in the coordinates of the machine.
    private static (double Bottom, double Right, double Top) Sides(params string[] offsets)
    {
        var text = "G21 G17 G40 G90 G54\nT1 M6\n" + string.Concat(offsets.Append(OffsetCell.Cutting)
            .Select((p, i) => Labeled(p, i))) + "M2\n";
        var run = Rs274.RunWithTools(text, $"T1 P1 D{(6 / 25.4).ToString("R", CultureInfo.InvariantCulture)} ;mill\n");
        Assert.Null(run.Refusal);
        var cuts = run.Motions.Where(m => m.Kind == MotionKind.Line).Select(m => m.End).ToArray();
        return (Side(cuts.Select(c => c.Y).Where(y => y is > -5 and < 0).Min() + run.Origin.Y),
            Side(cuts.Max(c => c.X) + run.Origin.X), Side(cuts.Max(c => c.Y) + run.Origin.Y));
    }

    // To a micrometer: the peer prints four decimals.
    private static double Side(double mm) => Math.Round(mm, 3);

    // Without what begins and ends a file, and with labels of its own.
    private static string Labeled(string program, int number) => string.Concat(program.Split('\n')
        .Where(l => l.Length > 0 && l[0] != '%' && l is not ("M2" or "T1 M6") && !l.StartsWith("o<offsets> ", StringComparison.Ordinal))
        .Select(l => (l[0] == 'o' && char.IsAsciiDigit(l[1]) ? FormattableString.Invariant($"o{number + 1}{l[1..]}") : l) + "\n"));
}
