using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>Inserted roundings and chamfers: a block beside one is displaced only where the corner stays as it is.</summary>
public sealed class CornerWordTests
{
    public static TheoryData<string, string> Corners => new()
    {
        { "siemens-840d", "X10. RND=2" },
        { "siemens-840d", "X10. RNDM=2" },
        { "siemens-840d", "X10. CHF=2" },
        { "siemens-840d", "X10. CHR=2" },
        { "fanuc", "X10. ,R2." },
        { "fanuc", "X10. ,C2." },
    };

    [Fact]
    public void The_block_behind_a_rounding_is_not_turned()
    {
        var path = WrongProgram.Read("rnd-before.mpf", "siemens-840d");
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N20"), new(1, 0.5, 0)));
        var refusal = Bench.Refused(Rewriter.Apply(path, wish));

        Assert.Equal((NcRefusalCodes.CornerWord, "N10", 3), (refusal.Code, refusal.Place.Block, refusal.Place.Line));
    }

    [Theory]
    [MemberData(nameof(Corners))]
    public void Blocks_on_both_sides_of_a_corner_word_are_refused_by_its_block(string dialect, string corner)
    {
        var program = $"G90 G17 G0 X0. Y0. Z0.\nG1 F100 Y0.\nN5 X1. Y1.\nN10 {corner}\nN20 Y10.\nN30 X0.\nG0 Z5.\n";
        foreach (var named in (string[])["N5", "N10", "N20"])
        {
            foreach (var by in (Vector3[])[new(1, 0.5, 0), new(0, 0, 0.5)])
            {
                Assert.Equal(NcRefusalCodes.CornerWord, Bench.RefusedBy(program, by, named, NcDialects.Named(dialect)).Code);
            }

            foreach (var left in (double[])[0.1, -0.1])
            {
                Assert.Equal(NcRefusalCodes.CornerWord, Bench.RefusedNormal(program, left, named, NcDialects.Named(dialect)).Code);
            }
        }
    }

    // The corner needs 2 mm of the line behind it; what is left of it must be longer.
    [Theory]
    [InlineData(5, "N20 Y15.")]
    [InlineData(-7.9, "N20 Y2.1")]
    [InlineData(-8.1, null)]
    [InlineData(-12, null)]
    public void A_line_along_an_axis_may_get_longer_or_shorter_behind_a_corner(double by, string? expected)
    {
        const string Program = "G90 G17 G0 X0. Y0. Z0.\nN10 G1 X10. ,R2. F100\nN20 Y10.\nG0 Z5.\n";
        if (expected is null)
        {
            Assert.Equal(NcRefusalCodes.CornerWord, Bench.RefusedBy(Program, new(0, by, 0), "N20", NcDialects.FanucMill).Code);
            return;
        }

        var wanted = Program.Replace("N20 Y10.", expected, StringComparison.Ordinal);
        Assert.Equal(wanted, Bench.By(Program, new(0, by, 0), "N20", NcDialects.FanucMill));
    }

    [Fact]
    public void A_line_that_slides_along_an_axis_keeps_the_corner_before_it() =>
        Assert.Equal(
            "G90 G17 G0 X0. Y0. Z0.\nN10 G1 X10. ,R2. F100\nN20 Y9.9\nN30 X0. Y9.9\nG0 Z5.\n",
            Bench.Normal(
                "G90 G17 G0 X0. Y0. Z0.\nN10 G1 X10. ,R2. F100\nN20 Y10.\nN30 X0. Y10.\nG0 Z5.\n", 0.1, "N30", NcDialects.FanucMill));

    // N30 goes 0.4 mm up, and the end of N20 0.5 mm along its own direction (3, 4)/5, to (25.3, 20.4):
    // no digit is rounded here, but it could be.
    [Theory]
    [InlineData("N20 X25. Y20.", false)]
    [InlineData("N20 Y20.", true)]
    public void A_line_that_slides_aslant_does_not_keep_the_corner_before_it(string line, bool isUsable)
    {
        var program = $"G90 G17 G0 X0. Y0. Z0.\nN10 G1 X10. ,R2. F100\n{line}\nN30 X0. Y20.\nG0 Z5.\n";
        var path = Bench.Read(program, NcDialects.FanucMill);
        var outcome = Rewriter.Apply(path, Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N30"), -0.4)));

        Assert.Equal(isUsable ? null : NcRefusalCodes.CornerWord, outcome.Refusal?.Code);
    }

    // The rounding is computed from the blocks on both sides: one increment of its end turns it.
    [Theory]
    [InlineData("N20 Y19.999", true)]
    [InlineData("N20 X10.001 Y20.", false)]
    public void A_rounding_that_moved_is_not_proved(string line, bool holds)
    {
        const string Before = "G90 G17 G0 X0. Y0. Z0.\nN10 G1 X10. ,R2. F100\nN20 Y20.\nG0 Z5.\n";
        var path = Bench.Read(Before, NcDialects.FanucMill);
        var by = holds ? new Vector3(0, -0.001, 0) : new Vector3(0.001, 0, 0);
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N20"), by));
        var result = NcProgram.FromText(Before.Replace("N20 Y20.", line, StringComparison.Ordinal));

        Assert.Equal(holds, Prover.Check(path, result, wish, 0.001).Holds);
    }
}
