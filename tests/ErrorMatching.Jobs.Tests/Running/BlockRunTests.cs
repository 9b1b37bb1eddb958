using System.Text;
using System.Text.RegularExpressions;
using ErrorMatching.Mating;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Blocks are found for a job as a file, and a job is written that has them and is otherwise as it was.</summary>
public sealed class BlockRunTests
{
    [Theory]
    [InlineData("complex-mating", "N120", "N130..N160", "N170..N1190")]
    [InlineData("curve-mating", "N120..N1970")]
    public void A_sample_without_blocks_gets_those_of_the_paper_and_is_the_sample_again(string sample, params string[] blocks)
    {
        using var shop = Shop(sample);
        var original = File.ReadAllText(shop["job.json"]);
        var (missing, empty) = (shop.File("missing.json", Regex.Replace(original, "\"blocks\": \\[[^]]*\\], ", "", RegexOptions.None, TimeSpan.FromSeconds(1))), shop.File("empty.json", Regex.Replace(original, "\"blocks\": \\[[^]]*\\]", "\"blocks\": []", RegexOptions.None, TimeSpan.FromSeconds(1))));
        Assert.NotEqual(original, File.ReadAllText(missing));
        foreach (var job in new[] { missing, empty, shop["job.json"] })
        {
            var found = BlockRun.Of(job, CancellationToken.None).Result!;
            Assert.Equal(blocks, found.Features.Select(f => Assert.Single(f.Blocks)));
            Assert.Empty(found.Refusals);
            Assert.Equal(job == shop["job.json"], found.IsInJob(0));
            Assert.Equal(original, Encoding.UTF8.GetString(found.JobAt(shop["new.json"])));
            Assert.Equal([job, shop["theoretical.csv"], shop["counterpart.nc"]], found.Read);
        }
    }

    [Fact]
    public void Comments_and_everything_else_stay_and_words_for_the_same_motions_too()
    {
        using var shop = Shop("complex-mating");
        var text = "\uFEFF" + File.ReadAllText(shop["job.json"])
            .Replace("\"blocks\": [\"N120\"]", "\"blocks\" : /* by hand */ [ \"/^N12[0]\\\\b/\" ] // L1", StringComparison.Ordinal)
            .Replace("], \"toleranceMm\": [-0.05, 0.05] },\n    { \"name\": \"L2L3\"", "],\n\"toleranceMm\": [-0.05, 0.05] },\n    { \"name\": \"L2L3\"", StringComparison.Ordinal)
            .Replace("[\"N130..N160\"]", "[\"N130..N150\"]", StringComparison.Ordinal);
        text = text.Replace("// L1, \"toleranceMm\"", "// L1\n, \"toleranceMm\"", StringComparison.Ordinal);
        var found = BlockRun.Of(shop.File("mine.json", text.Replace("\n", "\r\n", StringComparison.Ordinal)), CancellationToken.None).Result!;

        // The expression names N120 alone, which is what was found; N130..N150 is short of a block.
        Assert.Equal([true, false, true], found.Features.Select(f => found.IsInJob(f.Feature)));
        Assert.Equal(text[1..].Replace("[\"N130..N150\"]", "[\"N130..N160\"]", StringComparison.Ordinal), Encoding.UTF8.GetString(found.JobAt(shop["new.json"])));
    }

    [Fact]
    public void In_another_folder_its_paths_lead_to_the_same_files()
    {
        using var shop = Shop("complex-mating");
        Directory.CreateDirectory(shop["elsewhere"]);
        var target = shop[Path.Combine("elsewhere", "job.json")];
        var found = BlockRun.Of(shop.File("mine.json", File.ReadAllText(shop["job.json"]).Replace("\"part.csv\"", "\"/abs/part.csv\"", StringComparison.Ordinal)), CancellationToken.None).Result!;
        var job = MatingJob.Parse(found.JobAt(target), target);
        Assert.Equal(("../theoretical.csv", "/abs/part.csv", "../counterpart.nc", "../counterpart.csv", "delta-nc300"), (job.Part.Theoretical, job.Part.Measured, job.Counterpart.Program, job.Counterpart.Measured, job.Counterpart.Dialect));
        Assert.Equal(Path.GetFullPath(shop["counterpart.nc"]), Path.GetFullPath(job.PathOf(job.Counterpart.Program)));
    }

    [Fact]
    public void A_feature_without_blocks_says_why_and_makes_no_job()
    {
        using var shop = Shop("complex-mating");
        var found = BlockRun.Of(shop.File("mine.json", File.ReadAllText(shop["job.json"]).Replace("\"toolDiameterMm\": 6", "\"toolDiameterMm\": 10", StringComparison.Ordinal)), CancellationToken.None).Result!;
        Assert.Equal(["boundary-not-found", "boundary-not-found", "boundary-not-found"], found.Refusals.Select(r => r.Code));
        Assert.All(found.Refusals, r => Assert.Equal(shop["counterpart.nc"], r.File));

        // Point 2 is 3.000 mm from the path of N120, which stands in line 19.
        Assert.Equal((19, "N120"), (found.Refusals[0].Line, found.Refusals[0].Block));
        Assert.Contains("expected 5 mm, one tool radius (within 0.5 mm)", found.Refusals[0].Message, StringComparison.Ordinal);
        Assert.All(found.Features, f => Assert.Empty(f.Blocks));
        Assert.False(found.IsInJob(0));
        Assert.Throws<InvalidOperationException>(() => found.JobAt(shop["new.json"]));
    }

    [Fact]
    public void Blocks_that_nobody_can_name_are_refused_with_the_block()
    {
        // L1's only block has no number, and reads the same as the next one.
        using var shop = Shop("complex-mating");
        File.WriteAllText(shop["counterpart.nc"], File.ReadAllText(shop["counterpart.nc"]).Replace("N120 X-34.995 Y59.757", "X-34.995 Y59.757\nX-34.995 Y59.757", StringComparison.Ordinal));
        var found = BlockRun.Of(shop["job.json"], CancellationToken.None).Result!;
        var refusal = Assert.Single(found.Refusals);
        Assert.Equal(("block-ambiguous", 20), (refusal.Code, refusal.Line));
        Assert.StartsWith("L1: ", refusal.Message, StringComparison.Ordinal);
        Assert.Equal([0, 1, 1], found.Features.Select(f => f.Blocks.Count));
    }

    [Fact]
    public void Blocks_that_a_jump_puts_in_another_order_are_not_named_by_a_range()
    {
        using var shop = Shop("complex-mating");
        shop.File("theoretical.csv", "point,x_mm,y_mm\n1,5,0\n2,45,0\n");
        shop.File("counterpart.nc", "N10 G21 G90 G17\nN20 G0 X0. Y20.\nN30 G1 X0. Y3. F300\nGOTO 100\nN50 X50.\nGOTO 200\nN100 X25.\nGOTO 50\nN200 Y20.\nN210 M30\n");
        var job = shop.File("job.json", """
            { "kind": "mating", "name": "Jumps", "part": { "theoretical": "theoretical.csv", "measured": "part.csv" }, "gauge": { "format": "points", "uncertaintyMm": 0.001 },
              "features": [{ "name": "L1", "kind": "line", "points": ["1", "2"], "toleranceMm": [0, 0] }],
              "counterpart": { "program": "counterpart.nc", "dialect": "fanuc", "toolDiameterMm": 6 } }
            """);
        var refusal = Assert.Single(BlockRun.Of(job, CancellationToken.None).Result!.Refusals);
        Assert.Equal(("boundary-not-found", "N100", 7), (refusal.Code, refusal.Block, refusal.Line));
        Assert.Contains("by a jump or a call", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_program_that_cannot_be_followed_is_refused()
    {
        using var shop = Shop("complex-mating");
        File.WriteAllText(shop["counterpart.nc"], File.ReadAllText(shop["counterpart.nc"]).Replace("N90 Z2.", "N90 M98 P4711", StringComparison.Ordinal));
        var outcome = BlockRun.Of(shop["job.json"], CancellationToken.None);
        Assert.Null(outcome.Result);
        Assert.Equal(shop["counterpart.nc"], Assert.Single(outcome.Refusals).File);
    }

    [Fact]
    public void Points_that_the_theoretical_file_lacks_are_said_before_anything_is_sought()
    {
        using var shop = Shop("complex-mating");
        File.WriteAllText(shop["theoretical.csv"], File.ReadAllText(shop["theoretical.csv"]).Replace("\n2,", "\n22,", StringComparison.Ordinal));
        Assert.Equal("missing-point", Assert.Throws<Measurement.MeasurementException>(() => BlockRun.Of(shop["job.json"], CancellationToken.None)).Code);
    }

    private static TemporaryFolder Shop(string sample)
    {
        var folder = new TemporaryFolder();
        foreach (var file in new[] { "job.json", "theoretical.csv", "counterpart.nc" })
        {
            File.Copy(Repository.PathTo("samples", sample, file), folder[file]);
        }

        return folder;
    }
}
