using System.Text;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi.Tests;

public sealed class ProgramLinesTests
{
    [Fact]
    public void Changed_and_inserted_blocks_stand_beside_the_original_ones()
    {
        var lines = Of(
            "%\nN10 G0\nN20 X1.\nM30\n",
            "%\n(MARK)\nN10 G0\nN20 X1.5\nM30\n",
            new ReportBlock("N20", 3, "N20 X1.", "N20 X1.5", [new(4, 3)], [new(4, 4)]));
        Assert.Equal(["%|%", "|(MARK)", "N10 G0|N10 G0", "N20 X1.|N20 X1.5", "M30|M30"], lines.Select(l => $"{l.Original}|{l.Modified}"));
        Assert.Equal([1, 3], lines.Changes);
    }

    [Fact]
    public void Each_side_counts_the_lines_of_its_own_program()
    {
        var lines = Of("%\nN10 G0\n\nM30\n", "%\n(MARK)\nN10 G0\n\n(DONE)\nM30\n");
        Assert.Equal(["1|1", "|2", "2|3", "3|4", "|5", "4|6"], lines.Select(l => $"{l.OriginalNumber}|{l.Number}"));
    }

    [Fact]
    public void A_block_a_line_and_a_text_are_found_either_way_and_around_the_end()
    {
        var lines = Of(
            "%\nN1 G0\n/N12 X1.\nN120 X2. (roughing)\nN12X3.\nM30\n",
            "%\n(MARK)\nN1 G0\n/N12 X1.\nN120 X2.5 (roughing)\nN12X3.\nM30\n",
            new ReportBlock("N120", 4, "N120 X2. (roughing)", "N120 X2.5 (roughing)", [new(5, 3)], [new(5, 4)]));

        // N12 is not N120, with a slash before it or without a blank behind it.
        Assert.Equal([3, 5, 3], Walk("N12", 1, 3));
        Assert.Equal([5, 3], Walk("n12", -1, 2));
        Assert.Equal(4, lines.Find("N120", -1, 1));
        Assert.Null(lines.Find("N1200", -1, 1));

        // The number of a line in the new program, which the control's screen counts.
        Assert.Equal((1, 6), (lines.Find("2", 5, 1), lines.Find(" 7 ", -1, -1)));
        Assert.Null(lines.Find("8", -1, 1));
        Assert.Null(lines.Find("0", -1, 1));

        // Whatever stands in one of the two programs.
        Assert.Equal((4, 4, 1), (lines.Find("ROUGH", -1, 1), lines.Find("X2. ", -1, 1), lines.Find("mark", -1, -1)));
        Assert.Null(lines.Find("finishing", 2, 1));
        Assert.Null(lines.Find("  ", -1, 1));
        Assert.Null(Of("", "").Find("N1", -1, 1));

        IEnumerable<int?> Walk(string words, int step, int times)
        {
            for (int? at = -1; times > 0; times--)
            {
                yield return at = lines.Find(words, at!.Value, step);
            }
        }
    }

    [Fact]
    public void A_million_blocks_are_counted_and_read_by_number_without_being_made_into_text()
    {
        var program = Encoding.ASCII.GetBytes(string.Concat(Enumerable.Repeat("G1 X1. Y2.\n", 1_000_000)));
        var lines = new ProgramLines(program, program, []);
        Assert.Equal(1_000_000, lines.Count);
        Assert.Equal("G1 X1. Y2.", lines[999_999].Modified);
        var before = GC.GetAllocatedBytesForCurrentThread();
        _ = lines[500_000];
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 2_000);
    }

    [Fact]
    public void The_marker_of_a_displaced_surface_is_no_change_to_step_to()
    {
        var folder = Path.Combine(AppContext.BaseDirectory, "samples", "surface-one");
        var files = new FreeformFiles(Path.Combine(folder, "job.json"));
        var (job, dialect) = (
            files.Job with { Toolpath = files.Job.Toolpath with { ScallopMm = 0.1, ChordMm = 0.05 } }, files.ToolpathDialect());
        var cam = FinishingProgram.Write(ToolPathPlanner.Plan(files.Surface(), job.Tool, job.Toolpath, 0, dialect).Path!, job, dialect);
        var displaced = SurfaceRun.Displace(
            files,
            new() { Measured = [new(Path.Combine(folder, "measured.csv"))] },
            new("cam.nc", cam),
            TestContext.Current.CancellationToken).Result!;
        var kept = StoredReport.Read(displaced.ReportJson()).Surface!;
        Assert.StartsWith("; ERRORMATCH MEASUREMENT=", kept.Proof!.Marker, StringComparison.Ordinal);
        Assert.Empty(new ProgramLines(cam, displaced.Program, [], kept.Proof.Marker).Changes);
    }

    private static ProgramLines Of(string original, string modified, params ReportBlock[] blocks) =>
        new(Encoding.ASCII.GetBytes(original), Encoding.ASCII.GetBytes(modified), blocks);
}
