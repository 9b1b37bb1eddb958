using System.Globalization;
using System.Text.Json;

namespace ErrorMatching.EndToEnd.Tests;

[Trait("Runs", "Console")]
public sealed class NcTests
{
    private const string Program = "samples/complex-mating/counterpart.nc";

    [Fact]
    public async Task Motions_have_the_columns_that_scripts_read()
    {
        using var shop = new Workshop();
        var lines = (
            await shop.Run($"nc motion {Program} --dialect delta-nc300")).Output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal("index,line,block,kind,x,y,z,cx,cy,cz,plane,turns,feed", lines[0]);

        // N140 G3 Y48.745 I2.941 J-5.23 from Y53.975, at Z-13.5.
        Assert.Contains("7,22,N140,arc-ccw,-48.334,48.745,-13.5,-42.334,48.745,-13.5,XY,0,500", lines);
        Assert.Contains("0,11,N60,rapid,-45,80,0,,,,XY,0,0", lines);
    }

    [Fact]
    public async Task The_json_of_motions_says_what_the_csv_says()
    {
        using var shop = new Workshop();
        var csv = (await shop.Run($"nc motion {Program}")).Output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        var motions = (await shop.Run($"nc motion {Program} --json")).Json.GetProperty("motions");
        Assert.Equal(csv.Length - 1, motions.GetArrayLength());
        var names = csv[0].Split(',');
        foreach (var (line, motion) in csv.Skip(1).Zip(motions.EnumerateArray()))
        {
            Assert.Equal([.. names, "unknown", "words"], motion.EnumerateObject().Select(p => p.Name));
            Assert.Equal(line.Split(','), motion.EnumerateObject().SkipLast(2).Select(p => p.Value.ToString()));
        }

        // N60 comes before any Z; G91 G28 Z0 ends where only the machine knows.
        Assert.Equal(["z"], Unknown(motions[0]));
        Assert.Empty(Unknown(motions[3]));
        Assert.Equal(["z"], Unknown(motions[motions.GetArrayLength() - 1]));

        static IEnumerable<string?> Unknown(JsonElement motion) =>
            motion.GetProperty("unknown").EnumerateArray().Select(a => a.GetString());
    }

    [Fact]
    public async Task A_displacement_warns_that_the_control_smooths_the_path()
    {
        using var shop = new Workshop();
        await File.WriteAllTextAsync(
            shop["smooth.mpf"], "N10 G17 G90 G71 G641 ADIS=0.1\nN20 G0 X0 Y0 Z5\nN30 G1 X10 F100\n", TestContext.Current.CancellationToken);
        var run = await shop.Run("nc displace smooth.mpf --dialect siemens-840d --blocks N30 --by 1,0 --out out.mpf --json");
        Assert.Equal(0, run.Exit);
        Assert.Equal("smoothing", Assert.Single(run.Json.GetProperty("notes").EnumerateArray()).GetProperty("code").GetString());
    }

    [Fact]
    public async Task A_check_counts_and_copies()
    {
        using var shop = new Workshop();
        File.WriteAllBytes(shop["p.nc"], "%\r\nN10 G0 X1. Y2 (\xE9)\r\nN20 G1 X5 CYCLE99(1) F100\nN30 Q=3\rN40 M30"u8.ToArray());
        var check = (await shop.Run("nc check p.nc --json")).Json;
        Assert.True(check.GetProperty("roundTrip").GetBoolean());
        Assert.Equal((5, 1), (check.GetProperty("blocks").GetInt32(), check.GetProperty("unknownWords").GetArrayLength()));
        Assert.Equal(
            (3, "N20"),
            (
                check.GetProperty("unknownWords")[0].GetProperty("line").GetInt32(),
                check.GetProperty("unknownWords")[0].GetProperty("block").GetString()));
    }

    [Fact]
    public async Task Located_blocks_have_their_text_and_motion()
    {
        using var shop = new Workshop();
        var blocks = (await shop.Run(["nc", "locate", Program, "--blocks", "N120..N130", "/^N10\\b/", "--json"])).Json.GetProperty("blocks")
            .EnumerateArray()
            .ToArray();
        Assert.Equal(["N10", "N120", "", "N130"], blocks.Select(b => b.GetProperty("block").GetString()));
        Assert.Equal(
            ["N10 G21", "N120 X-34.995 Y59.757", "(TOOTH L2 - TIP - L3)", "N130 X-45.275 Y53.975"],
            blocks.Select(b => b.GetProperty("text").GetString()));
        Assert.Equal(System.Text.Json.JsonValueKind.Null, blocks[0].GetProperty("motion").ValueKind);
        Assert.Equal(-45.275, blocks[3].GetProperty("motion").GetProperty("x").GetDouble());
    }

    [Fact]
    public async Task Displaced_ends_are_what_the_difference_shows()
    {
        using var shop = new Workshop();
        var run = await shop.Run($"nc displace {Program} --dialect delta-nc300 --blocks N170..N190 --by -0.1,0.05 --out out/d.nc --json");
        Assert.Equal((0, ""), (run.Exit, run.Error));
        Assert.True(run.Json.GetProperty("proof").GetProperty("holds").GetBoolean());
        var moved = (await shop.Run($"nc diff {Program} out/d.nc --json")).Json.GetProperty("motions").EnumerateArray().ToArray();
        Assert.Equal(["N170", "N180", "N190"], moved.Select(m => m.GetProperty("block").GetString()));
        Assert.All(moved, m => Assert.Equal((-0.1, 0.05, 0.0), (
            m.GetProperty("displacement").GetProperty("x").GetDouble(), m.GetProperty("displacement").GetProperty("y").GetDouble(),
            m.GetProperty("displacement").GetProperty("z").GetDouble())));
    }

    [Fact]
    public async Task A_normal_offset_keeps_the_center_and_changes_the_radius()
    {
        // Figure 9 of Wang 2021: an offset by 0.02 to the inside of the tooth turns its arcs of radius 6 into 5.98 about the same center.
        using var shop = new Workshop();
        var run = await shop.Run($"nc displace {Program} --blocks N130..N160 --normal 0.02 --out d.nc --json");
        Assert.Equal(0, run.Exit);
        var arcs = (await shop.Run("nc motion d.nc")).Output.Split('\n')
            .Where(l => l.Contains("arc-", StringComparison.Ordinal))
            .Select(l => l.Split(','))
            .ToArray();
        Assert.Equal(2, arcs.Length);
        foreach (var arc in arcs)
        {
            var (x, y, cx, cy) = (Number(arc[4]), Number(arc[5]), Number(arc[7]), Number(arc[8]));
            Assert.Equal(5.98, Math.Sqrt(((x - cx) * (x - cx)) + ((y - cy) * (y - cy))), 0.0015);
            Assert.True(Math.Abs(cx - -42.334) < 0.0015 && Math.Abs(cy - 48.745) < 0.0015);
        }
    }

    [Fact]
    public async Task Points_displace_along_the_path_and_far_ones_are_refused()
    {
        using var shop = new Workshop();
        File.WriteAllText(shop["near.csv"], "x,y,dx,dy\n-34.995,59.757,0.05,0\n-34.939,80,0.05,0\n");
        Assert.Equal(0, (await shop.Run($"nc displace {Program} --blocks N120 --along near.csv --out d.nc")).Exit);
        Assert.Contains(",N120,line,-34.945,", (await shop.Run("nc motion d.nc")).Output, StringComparison.Ordinal);
        File.WriteAllText(shop["far.csv"], "x,y,dx,dy\n-34.4,70,0.05,0\n");
        var run = await shop.Run($"nc displace {Program} --blocks N120 --along far.csv --out e.nc --json");
        Assert.Equal(
            (2, "point-off-path", "N120"),
            (run.Exit, run.SingleError.GetProperty("code").GetString(), run.SingleError.GetProperty("block").GetString()));
        Assert.False(File.Exists(shop["e.nc"]));
    }

    [Theory]
    [InlineData("--by 1,x --out d.nc", "command-line")]
    [InlineData("--normal 0.1 --by 1,1 --out d.nc", "command-line")]
    [InlineData("--out d.nc", "command-line")]
    [InlineData("--normal 0.1", "command-line")]
    [InlineData("--normal 0,1 --out d.nc", "command-line")]
    [InlineData("--normal 0.1 --out " + Program, "output-is-input")]
    [InlineData("--along samples/fits/line.csv --out d.nc", "missing-column")]
    [InlineData("--normal 0.1 --out d.nc --dialect heidenhain", "unknown-dialect")]
    public async Task A_wrong_wish_is_exit_1(string options, string code)
    {
        using var shop = new Workshop();
        var before = shop.State();
        var run = await shop.Run($"nc displace {Program} --blocks N130 {options} --json");
        Assert.Equal((1, code), (run.Exit, run.Json.GetProperty("errors")[0].GetProperty("code").GetString()));
        Assert.Equal(before, shop.State());
    }

    [Theory]
    [InlineData("N7", 2, "block-not-found")]
    [InlineData("N130..N120", 2, "block-not-found")]
    [InlineData("/nothing/", 2, "block-not-found")]
    [InlineData("130", 1, "bad-selector")]
    [InlineData("/(/", 1, "bad-selector")]
    public async Task A_selector_that_names_nothing_is_refused(string selector, int exit, string code)
    {
        using var shop = new Workshop();
        var run = await shop.Run(["nc", "locate", Program, "--blocks", selector, "--json"]);
        Assert.Equal((exit, code), (run.Exit, run.SingleError.GetProperty("code").GetString()));
    }

    [Fact]
    public async Task Figure_9_differs_in_every_block_and_lost_one()
    {
        using var shop = new Workshop();
        var run = await shop.Run("nc diff samples/figure-nine/original.nc samples/figure-nine/modified.nc --json");
        Assert.Equal(0, run.Exit);
        Assert.Equal(
            ["N8970"],
            run.Json.GetProperty("motions")
                .EnumerateArray()
                .Where(m => m.GetProperty("change").GetString() == "removed")
                .Select(m => m.GetProperty("block").GetString()));
    }

    [Fact]
    public async Task A_difference_counts_first_and_shows_both_programs_with_changed_words_marked()
    {
        using var shop = new Workshop();
        File.Copy(shop["samples/complex-mating/counterpart.nc"], shop["d.nc"]);
        shop.Edit("d.nc", "N130 X-45.275", "N135 X-45.265");
        shop.Edit("d.nc", "N160 G1", "M8\nN160 G1");
        var text = await shop.Run($"nc diff {Program} d.nc --html d.html");
        Assert.Equal((0, ""), (text.Exit, text.Error));
        Assert.DoesNotContain('\u001b', text.Output);
        var lines = text.Output.Split('\n');
        Assert.StartsWith("3 motions differ", lines[0], StringComparison.Ordinal);
        Assert.Contains("identical  114", lines);
        Assert.Contains("largest    0.0100 mm, N130", lines);
        Assert.Contains(
            lines,
            l => l.StartsWith("~  21  N130 {X-45.275} Y53.975", StringComparison.Ordinal)
                && l.EndsWith(" 21  N135 {X-45.265} Y53.975", StringComparison.Ordinal));
        Assert.Contains(lines, l => l.StartsWith("+ ", StringComparison.Ordinal) && l.EndsWith(" 24  M8", StringComparison.Ordinal));
        Assert.Contains(lines, l => l.StartsWith("   22  N140", StringComparison.Ordinal));

        var json = (await shop.Run($"nc diff {Program} d.nc --json")).Json;
        var summary = json.GetProperty("summary");
        Assert.Equal(
            (114, 2, 1, 0.01),
            (Count("identical"), Count("moved"), Count("words"), summary.GetProperty("largestDisplacementMm").GetDouble()));
        var words = json.GetProperty("motions").EnumerateArray().Single(m => m.GetProperty("change").GetString() == "words");
        Assert.Equal(
            ("N160", "[\"M8\"]"),
            (
                words.GetProperty("block").GetString(),
                System.Text.RegularExpressions.Regex.Replace(
                    words.GetProperty("functions").GetProperty("after").ToString(),
                    "\\s",
                    "",
                    System.Text.RegularExpressions.RegexOptions.None,
                    TimeSpan.FromSeconds(1))));

        var page = System.Xml.Linq.XDocument.Load(shop["d.html"]);
        Assert.Contains(page.Descendants("ins"), e => e.Value == "X-45.265");
        Assert.Contains(page.Descendants("del"), e => e.Value == "X-45.275");
        Assert.Empty(page.Descendants("script"));

        int Count(string name) => summary.GetProperty(name).GetInt32();
    }

    [Fact]
    public async Task Dialects_state_facts_with_sources()
    {
        using var shop = new Workshop();
        var dialects = (await shop.Run("nc dialects --json")).Json.GetProperty("dialects").EnumerateArray().ToArray();
        Assert.Equal(
            [
                "generic", "fanuc", "delta-nc300", "haas", "mazak-eia", "mitsubishi-m80", "okuma-osp", "siemens-840d", "linuxcnc", "grbl",
                "heidenhain-klartext",
            ],
            dialects.Select(d => d.GetProperty("name").GetString()));
        Assert.All(
            dialects.SelectMany(d => d.GetProperty("facts").EnumerateArray()),
            f => Assert.NotEqual("", f.GetProperty("source").GetString()));
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
