using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>Nearly all blocks are read in one pass and run on a short way. A comment behind a block makes it take the long one:
/// both must come to the same.</summary>
public sealed class ShortWayTests
{
    private static readonly string[] Words =
    [
        "G0", "G1", "G01", "g1", "G2", "G3", "G17", "G18", "G20", "G21", "G40", "G41", "G42", "G54", "G55", "G80", "G81", "G90", "G91",
        "G92", "G52", "G68", "G69", "G90.1", "G91.1", "G38.2", "G4", "G53", "G28", "G999",
        "X0", "X1.", "X-2.5", "X+10.", "x.5", "X007", "X 3", "Y0", "Y-.25", "Y10", "Y1 .5", "Z0", "Z5.", "Z-1.000", "Z-0", "I1.", "J-5.",
        "K1.", "R5.", "F100", "F.5", "F0", "N7", "N007", "S500", "T1", "M3", "M8", "P2", "Q1.", "A5.", "E1",
        "X1Y2", "X123456789012345.", "Y1234567890123456", "X", "X--1", "X1.2.3",
    ];

    private static readonly Gen<string[]> Programs = Gen.Frequency(
        (2, Gen.Elements(Words).ListOf(3).Select(w => string.Join(' ', w))),
        (1, Gen.Elements(Words).ListOf(3).Select(string.Concat)),
        (
            5,
            Gen.Elements(
                "X1.5 Y2.",
                "G1 X{0}",
                "N10 X{0} Y{1} Z-.5",
                "Y{1} F200.",
                "G0 X{0}",
                "X{0} A{1} C1.",
                "B{1}",
                "Z{1}",
                "G91 X{0}",
                "G90",
                "X{0}Y{1}").Zip(Gen.Choose(-9, 9).Two())
            .Select(
                p => p.Item1.Replace("{0}", p.Item2.Item1 + ".", StringComparison.Ordinal).Replace(
                    "{1}", p.Item2.Item2 + ".5", StringComparison.Ordinal)))).ArrayOf();

    [Fact]
    public void Plain_blocks_come_to_the_same_by_their_words_and_by_their_tokens() =>
        Check.One(
            Config.QuickThrowOnFailure.WithMaxTest(Depth.Of(4000, 20_000)).WithEndSize(40),
            Prop.ForAll(Programs.Zip(Gen.Choose(0, NcDialects.Names.Count - 1)).ToArbitrary(), p =>
        {
            var dialect = NcDialects.All[p.Item2];
            var (shortWay, longWay) = (
                Bench.Read(string.Join('\n', p.Item1), dialect), Bench.Read(string.Join('\n', p.Item1.Select(l => l + " ;C")), dialect));
            return shortWay.Motions.SequenceEqual(longWay.Motions)
                && shortWay.Motions.Select((_, i) => shortWay.Motions.AssumedEnd(i)).SequenceEqual(
                    longWay.Motions.Select((_, i) => longWay.Motions.AssumedEnd(i)))
                && shortWay.Problems.SequenceEqual(longWay.Problems)
                && shortWay.PlaceDependents.SequenceEqual(longWay.PlaceDependents)
                && shortWay.Refusal == longWay.Refusal;
        }));

    // What a shop states of its control: an axis of its own, a code that stops, a code that moves as G0 does. A comment changes nothing.
    [Theory]
    [InlineData("fanuc", "G0 X0. Y0.\nG1 X1. F100.\nG1 X5. E10.", """
        "letters": [{ "letters": "E", "role": "other-axis", "statement": "The table.", "source": "tried" }],
        "refusals": [{ "name": "own", "letters": "E", "values": { "most": 5 }, "statement": "E is at most 5.", "source": "tried" }]
        """, true)]
    [InlineData("fanuc", "G0 X0 Y0\nG60 X5.\nX7.", """
        "codes": [{ "codes": "G60", "means": "rapid", "statement": "From one side.", "source": "tried" }],
        "refusals": [{ "name": "own", "codes": "G60", "letters": "X", "values": { "most": 3 }, "statement": "X is at most 3.",
          "source": "tried" }]
        """, true)]
    [InlineData("fanuc", "G0 X0 Y0\nG60 X1.\nX7.", """
        "codes": [{ "codes": "G60", "means": "rapid", "statement": "From one side.", "source": "tried" }],
        "refusals": [{ "name": "own", "codes": "G60", "letters": "X", "values": { "most": 3 }, "statement": "X is at most 3.",
          "source": "tried" }]
        """, false)]
    public void What_a_shop_states_holds_on_the_short_way_too(string like, string program, string members, bool isRefused)
    {
        var dialect = OwnDialect.Of(", " + members, like);
        var plain = Bench.Read(program, dialect);
        var spelled = Bench.Read(string.Join('\n', program.Split('\n').Select(l => l + " (C)")), dialect);
        Assert.Equal(spelled.Problems, plain.Problems);
        Assert.Equal(isRefused, plain.Problems.Count > 0);
    }

    [Fact]
    public void A_control_that_stops_at_G1_under_compensation_does_so_in_plain_blocks()
    {
        var dialect = OwnDialect.Of(
            """, "settings": { "compensationStops": { "value": "G1", "statement": "Stops.", "source": "tried" } }""",
            "generic").With(ToolRadii.Of(1));
        const string Program = "G90 G17 G0 X0. Y0. Z0.\nG1 X1. F100.\nG41 D1 X10.\nY10.\nX20.\nG1 Y20.\nX30.\nG40 X40.";
        string[] programs = [Program, string.Join('\n', Program.Split('\n').Select(l => l + " (C)"))];
        Assert.All(programs, p => Assert.Equal(
            "compensation-stop", CompensatedPath.Of(Bench.Read(p, dialect), TestContext.Current.CancellationToken).Refusal?.Code));
    }

    // A block is on the short way or not, which no later branch may notice.
    [Theory]
    [InlineData("fanuc", "G1 X5. F100.\nIF [#500 EQ 1] GOTO 10\nG1 X5. F100. M8\nN10 G1 Y5. F100.\nM30")]
    [InlineData("siemens-840d", "G1 X5 F100 M8\nIF R5==1 GOTOF WEITER\nG1 X5\nWEITER:\nG1 Y5 F100 ;CUT\nM30")]
    [InlineData("siemens-840d", "G1 X5 F100\nIF R5==1 GOTOF WEITER\nG1 X5 M8\nWEITER:\nG1 Y5 F100\nM30")]
    public void Two_ways_that_meet_do_so_whichever_way_their_blocks_are_run(string dialect, string program) =>
        Assert.Null(Bench.Read("G90 G17 G40 G0 X0. Y0. Z5.\n" + program, NcDialects.Named(dialect)).Refusal);

    [Fact]
    public void A_census_counts_plain_blocks_as_it_counts_their_tokens() =>
        Check.One(
            Config.QuickThrowOnFailure.WithMaxTest(Depth.Of(1000, 5000)).WithEndSize(40),
            Prop.ForAll(Programs.Zip(Gen.Choose(0, NcDialects.Names.Count - 1)).ToArbitrary(), p =>
        {
            var program = NcProgram.FromText(string.Join('\n', p.Item1), NcDialects.All[p.Item2].Syntax);
            var words = 0;
            for (var block = 0; block < program.BlockCount; block++)
            {
                foreach (var token in program.Tokens(program[block]))
                {
                    words += token.Kind is NcTokenKind.Word or NcTokenKind.ExpressionWord or NcTokenKind.Keyword ? 1 : 0;
                }
            }

            return NcCensus.Of(program) == new NcCensus(program.BlockCount, words, true);
        }));

    [Fact]
    public void A_long_program_is_counted_in_two_halves()
    {
        var text = string.Concat(Enumerable.Repeat("N1 X1.5 Y2\r\nX3 (c)\n\n", 10_001));
        Assert.Equal(new NcCensus(30_003, 40_004, true), NcCensus.Of(NcProgram.FromText(text)));
    }

    [Fact]
    public void A_straight_move_that_starts_elsewhere_says_so_on_the_short_way()
    {
        var path = Bench.Read("G90 G17 G21\nG0 X10. Y0. Z0.\nG92 X0.\nG1 X5. F100.\nX6.\n");
        Assert.Equal((0, 5), (path.Motions[1].Start.X, path.Motions[1].End.X));
        Assert.True(path.Motions[1].Has(MotionFlags.StartsElsewhere));
        Assert.False(path.Motions[2].Has(MotionFlags.StartsElsewhere));
    }
}
