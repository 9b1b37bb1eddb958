using System.Security.Cryptography;
using System.Text;
using System.Text.RegularExpressions;
using ErrorMatching.Mating;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Blocks are found for a job as a file, and a job is written that has them and is otherwise as it was.</summary>
public sealed class BlockRunTests
{
    private const string Round = "N50 X40. Y3.\nN60 G2 X53. Y-10. I0. J-13.\nN70 G1 Y-60.\n";

    private const string L2 = """, { "name": "L2", "kind": "line", "points": ["3", "4"], "toleranceMm": [0, 0] }""";

    [Theory]
    [InlineData("complex-mating", "N120", "N130..N160", "N170..N1190")]
    [InlineData("curve-mating", "N120..N1970")]
    [InlineData("circle-mating", "N120..N130")]
    [InlineData("slot-mating", "N120..N160")]
    public void A_sample_without_blocks_gets_those_of_the_paper_and_is_the_sample_again(string sample, params string[] blocks)
    {
        using var shop = Shop(sample);
        var original = File.ReadAllText(shop["job.json"]);
        var (missing, empty) = (
            shop.File("missing.json", Regex.Replace(original, "\"blocks\": \\[[^]]*\\], ", "", RegexOptions.None, TimeSpan.FromSeconds(1))),
            shop.File(
                "empty.json",
                Regex.Replace(original, "\"blocks\": \\[[^]]*\\]", "\"blocks\": []", RegexOptions.None, TimeSpan.FromSeconds(1))));
        Assert.NotEqual(original, File.ReadAllText(missing));
        foreach (var job in new[] { missing, empty, shop["job.json"] })
        {
            var found = BlockRun.Find(job, CancellationToken.None).Result!;
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
            .Replace(
                "], \"toleranceMm\": [-0.05, 0.05] },\n    { \"name\": \"L2L3\"",
                "],\n\"toleranceMm\": [-0.05, 0.05] },\n    { \"name\": \"L2L3\"",
                StringComparison.Ordinal)
            .Replace("[\"N130..N160\"]", "[\"N130..N150\"]", StringComparison.Ordinal);
        text = text.Replace("// L1, \"toleranceMm\"", "// L1\n, \"toleranceMm\"", StringComparison.Ordinal);
        var found = BlockRun.Find(
            shop.File("mine.json", text.Replace("\n", "\r\n", StringComparison.Ordinal)), CancellationToken.None).Result!;

        // The expression names N120 alone, which is what was found; N130..N150 is short of a block.
        Assert.Equal([true, false, true], found.Features.Select(f => found.IsInJob(f.Feature)));
        Assert.Equal(
            text[1..].Replace("[\"N130..N150\"]", "[\"N130..N160\"]", StringComparison.Ordinal),
            Encoding.UTF8.GetString(found.JobAt(shop["new.json"])));
    }

    [Fact]
    public void In_another_folder_its_paths_lead_to_the_same_files()
    {
        using var shop = Shop("complex-mating");
        Directory.CreateDirectory(shop["elsewhere"]);
        var target = shop[Path.Combine("elsewhere", "job.json")];
        var found = BlockRun.Find(
            shop.File(
                "mine.json", File.ReadAllText(shop["job.json"]).Replace("\"part.csv\"", "\"/abs/part.csv\"", StringComparison.Ordinal)),
            CancellationToken.None).Result!;
        var job = MatingJob.Parse(found.JobAt(target), target);
        Assert.Equal(
            ("../theoretical.csv", "/abs/part.csv", "../counterpart.nc", "../counterpart.csv", "delta-nc300"),
            (job.Part.Theoretical, job.Part.Measured, job.Counterpart.Program, job.Counterpart.Measured, job.Counterpart.Dialect));
        Assert.Equal(Path.GetFullPath(shop["counterpart.nc"]), Path.GetFullPath(job.PathOf(job.Counterpart.Program)));
    }

    [Fact]
    public void A_feature_without_blocks_says_why_and_makes_no_job()
    {
        using var shop = Shop("complex-mating");
        var found = BlockRun.Find(
            shop.File(
                "mine.json",
                File.ReadAllText(shop["job.json"]).Replace("\"toolDiameterMm\": 6", "\"toolDiameterMm\": 10", StringComparison.Ordinal)),
            CancellationToken.None).Result!;
        Assert.Equal(["boundary-not-found", "boundary-not-found", "boundary-not-found"], found.Refusals.Select(r => r.Code));
        Assert.All(found.Refusals, r => Assert.Equal(shop["counterpart.nc"], r.Place.File));

        // Point 2 is 3.000 mm from the path of N120, which stands in line 19.
        Assert.Equal((19, "N120"), (found.Refusals[0].Place.Line, found.Refusals[0].Place.Block));
        Assert.Matches(" 5 mm.* 0.5 mm", found.Refusals[0].Message);
        Assert.All(found.Features, f => Assert.Empty(f.Blocks));
        Assert.False(found.IsInJob(0));
        Assert.Throws<InvalidOperationException>(() => found.JobAt(shop["new.json"]));
    }

    [Fact]
    public void Blocks_that_read_the_same_as_others_are_named_by_line_with_the_hash_of_the_program()
    {
        // L1's only block has no number, and reads the same as the next one.
        using var shop = Shop("complex-mating");
        File.WriteAllText(
            shop["counterpart.nc"],
            File.ReadAllText(shop["counterpart.nc"]).Replace(
                "N120 X-34.995 Y59.757", "X-34.995 Y59.757\nX-34.995 Y59.757", StringComparison.Ordinal));
        var found = BlockRun.Find(shop["job.json"], CancellationToken.None).Result!;
        Assert.Empty(found.Refusals);
        Assert.Equal(["L19"], found.Features[0].Blocks);
        var counterpart = MatingJob.Parse(found.JobAt(shop["new.json"]), shop["new.json"]).Counterpart;
        Assert.Equal(Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(shop["counterpart.nc"]))), counterpart.ProgramSha256);

        // After an edit of the program they are found in other lines, with another hash.
        File.WriteAllBytes(shop["new.json"], found.JobAt(shop["new.json"]));
        File.WriteAllText(shop["counterpart.nc"], "(EDITED)\n" + File.ReadAllText(shop["counterpart.nc"]));
        var again = BlockRun.Find(shop["new.json"], CancellationToken.None).Result!;
        Assert.Empty(again.Refusals);
        Assert.Equal(["L20"], again.Features[0].Blocks);
        Assert.False(again.IsInJob(0));
        Assert.Equal(
            Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(shop["counterpart.nc"]))),
            MatingJob.Parse(again.JobAt(shop["newer.json"]), shop["newer.json"]).Counterpart.ProgramSha256);
    }

    [Fact]
    public void Blocks_that_a_jump_puts_in_another_order_are_not_named_by_a_range()
    {
        using var shop = Shop("complex-mating");
        shop.File("theoretical.csv", "point,x_mm,y_mm\n1,5,0\n2,45,0\n");
        shop.File(
            "counterpart.nc",
            "N10 G21 G90 G17\nN20 G0 X0. Y20.\nN30 G1 X0. Y3. F300\nGOTO 100\nN50 X50.\nGOTO 200\nN100 X25.\nGOTO 50\nN200 Y20.\nN210 "
                + "M30\n");
        var job = shop.File("job.json", """
            { "kind": "mating", "name": "Jumps", "part": { "theoretical": "theoretical.csv", "measured": "part.csv" }, "gauge": { "format": "points", "uncertaintyMm": 0.001 },
              "features": [{ "name": "L1", "kind": "line", "points": ["1", "2"], "toleranceMm": [0, 0] }],
              "counterpart": { "program": "counterpart.nc", "dialect": "fanuc", "toolDiameterMm": 6 } }
            """);
        var refusal = Assert.Single(BlockRun.Find(job, CancellationToken.None).Result!.Refusals);
        Assert.Equal(("boundary-not-found", "N100", 7), (refusal.Code, refusal.Place.Block, refusal.Place.Line));
        Assert.Contains("by a jump or a call", refusal.Message, StringComparison.Ordinal);
    }

    /// <summary>
    /// A tool of 6 mm cuts a counterpart below y = 0, whose boundary turns down or up at x = 50;
    /// the corner is rounded, cut off, or neither. The part is 0.1 mm higher along the first line and 0.05 mm further along the second:
    /// blocks of the lines alone can follow both.
    /// </summary>
    [Theory]
    [InlineData("N50 X40. Y3.\nN60 G2 X53. Y-10. I0. J-13.\nN70 G1 Y-60.\n", -1, "N50", "N70")] // convex, 10 mm
    [InlineData("N50 X50. Y3.\nN60 G2 X53. Y0. I0. J-3.\nN70 G1 Y-60.\n", -1, "N50", "N70")] // sharp: the tool rolls around it
    [InlineData("N50 X40. Y3.\nN60 G3 X47. Y10. I0. J7.\nN70 G1 Y60.\n", 1, "N50", "N70")] // concave, 10 mm
    [InlineData("N50 X46.5 Y3.\nN60 G3 X47. Y3.5 I0. J0.5\nN70 G1 Y60.\n", 1, "N50", "N70")] // concave, hardly larger than the tool
    [InlineData("N50 X46.95 Y3.\nN60 G3 X47. Y3.05 I0. J0.05\nN70 G1 Y60.\n", 1, "N50", "N70")] // an arc smaller than what moves
    [InlineData("N50 X47. Y3.\nN70 Y60.\n", 1, "N50", "N70")] // concave and sharp: the tool leaves it round
    [InlineData("N50 X40. Y3.\nN60 X53. Y-10.\nN70 Y-60.\n", -1, "N50", "N70")] // a chamfer of 45 degrees
    [InlineData("N50 X48. Y3.\nN60 X53. Y-2.\nN70 Y-60.\n", -1, "N50", "N70")] // a short one
    [InlineData("N50 X40. Y3.\nN60 X46.5 Y1.258\nN61 X51.258 Y-3.5\nN62 X53. Y-10.\nN70 Y-60.\n", -1, "N50", "N70")] // an arc in pieces
    [InlineData("N50 X20. Y3.\nN55 X40.\nN60 G2 X53. Y-10. I0. J-13.\nN65 G1 Y-12.\nN70 Y-60.\n", -1, "N50..N55", "N65..N70")] // in pieces
    public void A_corner_between_two_lines_is_proposed_to_neither_and_the_match_takes_the_proposal(
        string cut, int up, params string[] blocks)
    {
        using var shop = Corner(cut, $"point,x_mm,y_mm\n1,0,0\n2,35,0\n3,50,{up * 15}\n4,50,{up * 50}\n");
        var found = BlockRun.Find(shop["job.json"], CancellationToken.None).Result!;
        Assert.Empty(found.Refusals);
        Assert.Equal(blocks, found.Features.Select(f => Assert.Single(f.Blocks)));
        var job = shop.File("with-blocks.json", Encoding.UTF8.GetString(found.JobAt(shop["with-blocks.json"])));
        shop.File("part.csv", $"point,x_mm,y_mm\n1,0,0.1\n2,35,0.1\n3,50.05,{up * 15}\n4,50.05,{up * 50}\n");
        var matched = MatingRun.Run(new(job), new(), CancellationToken.None);
        Assert.True(matched.Result is not null, string.Join('\n', matched.Refusals.Select(r => r.Message)));
        Assert.True(matched.Result.Match.Proof.Holds);
        Assert.Equal([Decision.Compensated, Decision.Compensated], matched.Result.Match.Decision.Features.Select(f => f.Decision));
    }

    [Fact]
    public void A_corner_that_is_named_with_a_line_is_refused_with_what_helps()
    {
        using var shop = Corner(Round, "point,x_mm,y_mm\n1,0,0\n2,35,0\n3,50,-15\n4,50,-50\n");
        shop.File("part.csv", "point,x_mm,y_mm\n1,0,0.1\n2,35,0.1\n3,50.05,-15\n4,50.05,-50\n");
        var found = BlockRun.Find(shop["job.json"], CancellationToken.None).Result!;
        var text = Encoding.UTF8.GetString(found.JobAt(shop["job.json"]));
        var wide = shop.File("wide.json", text.Replace("\"N50\"", "\"N50..N60\"", StringComparison.Ordinal));
        var refusal = Assert.Single(MatingRun.Run(new(wide), new(), CancellationToken.None).Refusals);
        Assert.Equal(("no-intersection", "N70"), (refusal.Code, refusal.Place.Block));
        Assert.Contains(" N60 ", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_point_of_a_line_on_a_rounded_corner_is_named_and_one_that_hardly_lies_there_is_none()
    {
        // About (40, -10) with a radius of 10 mm, 50 degrees around the corner.
        using var beyond = Corner(Round, "point,x_mm,y_mm\n1,0,0\n2,47.660,-3.572\n3,50,-15\n4,50,-50\n");
        var found = BlockRun.Find(beyond["job.json"], CancellationToken.None).Result!;
        var refusal = Assert.Single(found.Refusals);
        Assert.Equal(
            ("point-on-corner", "L1", "N60", 5, "2"),
            (refusal.Code, refusal.Place.Feature, refusal.Place.Block, refusal.Place.Line, refusal.Place.Point));
        Assert.Empty(found.Features[0].Blocks);

        // What a coordinate is rounded by, behind the place where the arc begins.
        using var at = Corner(Round, "point,x_mm,y_mm\n1,0,0\n2,40.0004,0\n3,50,-15\n4,50,-50\n");
        var both = BlockRun.Find(at["job.json"], CancellationToken.None).Result!.Features;
        Assert.Equal(["N50", "N70"], both.Select(f => Assert.Single(f.Blocks)));
    }

    [Fact]
    public void What_the_mapping_of_a_match_refuses_is_not_proposed()
    {
        // The subprogram cuts the boundary, and 40 mm below it the same once more: its blocks cannot be named for one of both.
        using var shop = Corner("", "point,x_mm,y_mm\n1,5,0\n2,15,0\n3,25,0\n4,45,0\n");
        shop.File(
            "counterpart.nc",
            "%\nO1\nN10 G21 G90 G17\nN20 G0 X0. Y3.\nN30 M98 P2\nN35 G0 X0. Y-37.\nN40 M98 P2\nN45 M30\n"
            + "O2\nN50 G91 G1 X50. F300\nN60 G90 M99\n%\n");
        var text = File.ReadAllText(shop["job.json"]).Replace(L2, "", StringComparison.Ordinal);
        var job = shop.File("one.json", text.Replace("[\"1\", \"2\"]", "[\"1..4\"]", StringComparison.Ordinal));
        var found = BlockRun.Find(job, CancellationToken.None).Result!;
        var refusal = Assert.Single(found.Refusals);
        Assert.Equal(("point-off-path", "N50"), (refusal.Code, refusal.Place.Block));
        Assert.EndsWith("A match refuses N50: name the blocks yourself.", refusal.Message, StringComparison.Ordinal);
        Assert.Empty(Assert.Single(found.Features).Blocks);
    }

    [Fact]
    public void A_program_that_cannot_be_followed_is_refused()
    {
        using var shop = Shop("complex-mating");
        File.WriteAllText(
            shop["counterpart.nc"], File.ReadAllText(shop["counterpart.nc"]).Replace("N90 Z2.", "N90 M98 P4711", StringComparison.Ordinal));
        var outcome = BlockRun.Find(shop["job.json"], CancellationToken.None);
        Assert.Null(outcome.Result);
        Assert.Equal(shop["counterpart.nc"], Assert.Single(outcome.Refusals).Place.File);
    }

    [Fact]
    public void Points_that_the_theoretical_file_lacks_are_said_before_anything_is_sought()
    {
        using var shop = Shop("complex-mating");
        File.WriteAllText(
            shop["theoretical.csv"], File.ReadAllText(shop["theoretical.csv"]).Replace("\n2,", "\n22,", StringComparison.Ordinal));
        Assert.Equal(
            "missing-point",
            Assert.Throws<InputException>(() => BlockRun.Find(shop["job.json"], CancellationToken.None)).Code);
    }

    private static TemporaryFolder Corner(string cut, string theoretical)
    {
        var folder = new TemporaryFolder();
        folder.File("theoretical.csv", theoretical);
        folder.File("counterpart.nc", $"N10 G21 G90 G17\nN20 G0 X-30. Y20.\nN30 G1 X-10. Y3. F300\n{cut}N80 G1 X90.\nN90 M30\n");
        folder.File("job.json", $$"""
            { "kind": "mating", "name": "Corner",
              "part": { "theoretical": "theoretical.csv", "measured": "part.csv" }, "gauge": { "format": "points", "uncertaintyMm": 0.001 },
              "features": [{ "name": "L1", "kind": "line", "points": ["1", "2"], "toleranceMm": [0, 0] }{{L2}}],
              "counterpart": { "program": "counterpart.nc", "dialect": "fanuc", "toolDiameterMm": 6 } }
            """);
        return folder;
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
