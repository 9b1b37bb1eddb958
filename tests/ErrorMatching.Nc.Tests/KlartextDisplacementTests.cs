using ErrorMatching.Geometry;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>New words of Klartext programs, their proof, and what is refused.</summary>
public sealed class KlartextDisplacementTests
{
    private const string Head = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X-9 Y-9 Z-1 R0 FMAX\n";

    [Theory]
    [InlineData("3 L X+0 Y+0 F100\n4 L X+10", "3 L X+0 Y+0.5 F100\n4 L X+10")]
    [InlineData("2 L X+0 Y+0 F100\n4 L X+10 RL", "2 L X+0 Y+0 F100\n4 L X+10 Y+0.5 RL")]
    [InlineData("2 L X+0 Y+0 F100\n4 L  X-10.000  RL", "2 L X+0 Y+0 F100\n4 L  X-10.000 Y+0.500  RL")]
    [InlineData("2 L X+0 Y+0 F100\n4 L X+1\n2 L X+10", "2 L X+0 Y+0 F100\n4 L X+1 Y+0.5\n2 L X+10 Y+0")]
    [InlineData("2 L X+0 Y-0.2 F100\n4 L X+1 Y-0.2", "2 L X+0 Y-0.2 F100\n4 L X+1 Y+0.3")]
    [InlineData("3 L X0 Y0 F100\n4 L IX10", "3 L X0 Y0.5 F100\n4 L IX10")]
    [InlineData(
        "3 L X+0 Y+0 F100\n4 L M8\n5 CC X+5 Y+0\n6 C X+10 Y+0 DR+", "3 L X+0 Y+0.5 F100\n4 L M8\n5 CC X+5 Y+0.5\n6 C X+10 Y+0.5 DR+")]
    [InlineData("3 L X+0 Y+0 F100\n5 CC IX+5 IY+0\n6 C X+10 Y+0 DR+", "3 L X+0 Y+0.5 F100\n5 CC IX+5 IY+0\n6 C X+10 Y+0.5 DR+")]
    [InlineData("3 L X+0 Y+0 F100\n4 CR X+6 Y+6 R+6 DR-", "3 L X+0 Y+0.5 F100\n4 CR X+6 Y+6.5 R+6 DR-")]
    [InlineData("3 APPR LT X+0 Y+0 LEN5 RL F100\n4 L X+10\n5 DEP LT LEN5", "3 APPR LT X+0 Y+0.5 LEN5 RL F100\n4 L X+10\n5 DEP LT LEN5")]
    public void Ends_that_move_change_these_words(string before, string after) => Assert.Equal(
        Head + after + "\n9 L Z+50 FMAX\n",
        By(Head + before + "\n9 L Z+50 FMAX\n", new(0, 0.5, 0), "/^[3-8] .*[XY]/"));

    [Fact]
    public void A_circle_grows_about_its_center_and_a_center_in_increments_stays_there()
    {
        const string Circle = "3 L X+0 Y+0 F100\n4 CC IX+5 IY+0\n5 C X+10 Y+0 DR+\n6 C X+0 Y+0 DR+\n7 L Y-9 FMAX\n";
        Assert.Equal(
            Head + "3 L X-0.5 Y+0 F100\n4 CC IX+5.5 IY+0\n5 C X+10.5 Y+0 DR+\n6 C X-0.5 Y+0 DR+\n7 L X+0 Y-9 FMAX\n",
            Bench.Normal(Head + Circle, -0.5, "N5..N6", NcDialects.HeidenhainKlartext));
    }

    // A quarter about a center that stays keeps its angle; one that moves keeps it, too; one that meets another line does not.
    [Theory]
    [InlineData("5..6", 0, "5 CC X+10 Y+10", "6 CP IPA+90 DR+", "7 L X+20 Y+30")]
    [InlineData("3..8", 0, "5 CC X+10 Y+10", "6 CP IPA+90 DR+", "7 L X+20.5 Y+30")]
    [InlineData("3..8", 1, "5 CC X+10.5 Y+10.25", "6 CP IPA+90 DR+", "7 L X+20.5 Y+30.25")]
    public void An_arc_to_an_angle_follows_its_center(string named, int by, string center, string arc, string behind)
    {
        const string Program = Head
            + "3 L X+0 Y+0 F100\n4 L X+10 Y+0\n5 CC X+10 Y+10\n6 CP IPA+90 DR+\n7 L X+20 Y+30\n8 L X+0 Y+30\n9 L Z+50 FMAX\n";
        var selector = "N" + named.Replace("..", "..N", StringComparison.Ordinal);
        var text = by > 0 ? Bench.By(Program, new(0.5, 0.25, 0), selector, NcDialects.HeidenhainKlartext)
            : Bench.Normal(Program, -0.5, selector, NcDialects.HeidenhainKlartext);
        var lines = text.Split('\n');
        Assert.Equal((center, arc), (lines[5], lines[6]));
        Assert.StartsWith(behind.Split(" Y")[0], lines[7], StringComparison.Ordinal);
    }

    [Fact]
    public void An_arc_to_an_angle_gets_another_one_where_it_meets_another_line()
    {
        // From (10, 0) about (0, 0) to (0, 10), where a line along y = 10 goes on and is moved by 0.5 to y = 10.5 - out of reach; a line at
        // 45 degrees is met elsewhere on the circle: y = x + 9.5 instead of y = x + 10.
        const string Program = Head + "3 L X+10 Y+0 F100\n4 CC X+0 Y+0\n5 CP IPA+90 DR+\n6 L X+10 Y+20\n7 L Z+50 FMAX\n";
        var text = Bench.Normal(Program, -0.5 / Math.Sqrt(2), "N6", NcDialects.HeidenhainKlartext);
        var angle = double.Parse(text.Split("IPA+")[1].Split(' ')[0], System.Globalization.CultureInfo.InvariantCulture);

        // x^2 + (x + 9.5)^2 = 100.
        var x = (-9.5 + Math.Sqrt((9.5 * 9.5) - (2 * ((9.5 * 9.5) - 100)))) / 2;
        Assert.Equal(Math.Atan2(x + 9.5, x) * 180 / Math.PI, angle, 0.005);
    }

    [Fact]
    public void A_center_in_a_loop_changes_once()
    {
        const string Loop =
            "3 L X+0 Y+0 F100\n4 LBL 1\n5 CC X+5 Y+0\n6 C X+10 Y+0 DR+\n7 C X+0 Y+0 DR+\n8 CALL LBL 1 REP 2\n9 L Y-9 FMAX\n";
        var text = Bench.By(Head + Loop, new(1, 0, 0), "N3..N7", NcDialects.HeidenhainKlartext);
        Assert.Contains("5 CC X+6 Y+0\n6 C X+11 Y+0 DR+\n7 C X+1 Y+0 DR+\n", text, StringComparison.Ordinal);
    }

    // The second arc about the same center stays; the polar end counts from it; the center is the place of the tool; the value is
    // computed; the element is computed; a radius near half a turn; a rounded corner.
    [Theory]
    [InlineData("4 CC X+5 Y+0\n5 C X+10 Y+0 DR+\n6 L X+10 Y-1\n7 L X+0 Y+0\n8 C X+10 Y+0 DR-", "N3..N5", "arc-form")]
    [InlineData("4 CC X+5 Y+0\n5 C X+10 Y+0 DR+\n6 L Y+20\n7 LP PR+3 PA+0", "N3..N5", "arc-form")]
    [InlineData("4 CC\n5 L X+5\n6 C X+0 Y+5 DR+", "N5..N6", "arc-form")]
    [InlineData("4 FN 0: Q1 = +5\n5 CC X+Q1 Y+0\n6 C X+10 Y+0 DR+", "N3..N6", "expression")]
    [InlineData("4 CC X+5 Y+0\n5 CP IPA+90 DR+ IZ+1", "N5", "no-positioning")]
    [InlineData("4 CC X+5 Y+0\n5 CP IPA+450 DR+", "N3..N5", "active-transform")]
    [InlineData("4 CC X+5 Y+0\n5 LP PR+5 PA+90", "N3..N5", "active-transform")]
    [InlineData("4 FN 0: Q1 = +90\n5 CC X+5 Y+0\n6 CP IPA+Q1 DR+\n7 L X+20 Y+20", "N3..N6", "expression")]
    [InlineData("4 CC X+5 Y+0\n5 CP IPA+77.7 DR+\n7 L X+20 Y+20", "N3", "arc-form")]
    [InlineData("4 CC X+5 Y+0\n5 CP IPA+77.7 DR+\n7 L IX+20 Y+20", "N3", "arc-form")]
    [InlineData("4 L X+10\n5 RND R2\n6 L Y+10", "N4..N6", "corner-word")]
    [InlineData("4 CYCL DEF 10.1 ROT+5\n5 L X+1 Y+1 Z+1\n6 L X+10", "N6", "active-transform")]
    [InlineData("4 CYCL DEF 19.1 A+45 C+0\n5 L X+1 Y+1 Z+1\n6 L X+10", "N6", "active-transform")]
    [InlineData("4 CYCL DEF 26.1 X1.1 Y1.1\n5 L X+1 Y+1 Z+1\n6 L X+10", "N6", "active-transform")]
    [InlineData("4 CYCL DEF 8.1 X\n5 L X+1 Y+1 Z+1\n6 L X+10", "N6", "active-transform")]
    [InlineData("4 PLANE SPATIAL SPA+45 SPB+0 SPC+0 STAY\n5 L X+1 Y+1 Z+1\n6 L X+10", "N6", "active-transform")]
    [InlineData("4 M128\n5 L X+1 Y+1 Z+1\n6 L X+10", "N6", "active-transform")]
    [InlineData("4 L X+10 B+5", "N4", "other-axis")]
    [InlineData("4 TCH PROBE 0.0 REF\n5 L X+1 Y+1 Z+1 R0\n6 L X+10", "N6", "unknown-state")]
    public void What_cannot_change_is_refused(string blocks, string named, string code)
    {
        var program = Head + "3 L X+0 Y+0 F100\n" + blocks + "\n";
        Assert.Equal(code, Bench.RefusedBy(program, new(0.5, 0.25, 0), named, NcDialects.HeidenhainKlartext).Code);
    }

    [Theory]
    [InlineData("4 CC X+5 Y+0.5", "4 CC X+5.01 Y+0.5")]
    [InlineData("4 CC X+5 Y+0.5", "4 CC X+5 Y+0.500")]
    [InlineData("4 CC X+5 Y+0.5", "4 CC X+5  Y+0.5")]
    [InlineData("4 CC X+5 Y+0.5", "4 CC X+5 Y+0.5 ; C")]
    [InlineData("4 CC X+5 Y+0.5", "4 CC Y+0.5 X+5")]
    [InlineData("4 CC X+5 Y+0.5", "4 CC X+5 IY+0")]
    [InlineData("DR+", "DR-")]
    [InlineData("IPA+10 ", "IPA+11 ")]
    [InlineData("IPA+10 ", "IPA+10.0 ")]
    [InlineData("IPA+10 ", "PA+190 ")]
    [InlineData("9 CC X+1 Y+1", "9 CC X+1 Y+2")]
    public void A_tampered_result_is_not_proved(string was, string now)
    {
        var path = Bench.Read(
            Head + "3 L X+0 Y+0 F100\n4 CC X+5 Y+0\n5 C X+10 Y+0 DR+\n6 CP IPA+10 DR+\n7 L Z+50 FMAX\n9 CC X+1 Y+1\n",
            NcDialects.HeidenhainKlartext);
        var wish = DisplacementWish.EndsBy(path, Bench.Blocks(path, "N3", "N5", "N6"), new(0, 0.5, 0)).Result!;
        var text = Bench.Text(Bench.Rewritten(path, wish).Program);
        Assert.Contains(was, text, StringComparison.Ordinal);
        var tampered = NcProgram.FromText(text.Replace(was, now, StringComparison.Ordinal), NcSyntax.Klartext);
        var proof = Prover.Check(path, tampered, wish, 0.001);
        Assert.Equal(now == "4 CC X+5 Y+0.500", proof.Holds);
    }

    [Fact]
    public void Blocks_are_named_by_their_numbers()
    {
        var program = NcProgram.FromText("0 BEGIN PGM A MM\n1 L X+1\n2 L X+2\n3 L X+3\n", NcSyntax.Klartext);
        Assert.Equal(["N1..N3"], BlockNames.Of(program, 1, 3));
        Assert.Equal([1, 2], BlockSelector.Select(program, [BlockSelector.Parse("N1..N2")]).Result!);
    }

    [Fact]
    public void Nothing_throws_and_what_is_rewritten_reads_as_the_same_blocks()
    {
        string[] lines =
        [
            "3 L X+{0} Y+{1} F100", "4 L IX+{0}", "5 CC X+{0} Y+{1}", "6 C X+{0} Y+{1} DR+", "7 CR X+{0} Y+{1} R+9 DR-", "8 CT X+{0}",
            "9 CC",
            "10 CC IX+{0} IY+{1}", "11 CP IPA+90 DR+", "12 LP PR+5 PA+{0}", "13 RND R1", "14 CHF 1", "15 L Z+{1} FMAX",
            "16 APPR LT X+{0} Y+{1} LEN2 RL", "17 DEP LCT X+{0} Y+{1} R2", "18 L X+{0} RL", "19 L Y+{1} R0", "20 LBL 1",
            "21 CALL LBL 1 REP 1",
            "22 FN 0: Q1 = +{0}", "23 L X+Q1", "24 L X+{0} M99", "25 TOOL CALL 2 Z", "26 CYCL DEF 7.1 X+{0}",
            "27 L X+{0} Y+{1} Z+1 R0 FMAX",
            "28 M30", "29 ?", "30 L X+{0},5", "31 C X+{0} DR-", "32 L A+5 X+{0}",
        ];
        var line = Gen.Elements(lines).Zip(Gen.Choose(-9, 9).Two()).Select(p => p.Item1
            .Replace("{0}", p.Item2.Item1.ToString(System.Globalization.CultureInfo.InvariantCulture), StringComparison.Ordinal)
            .Replace("{1}", p.Item2.Item2.ToString(System.Globalization.CultureInfo.InvariantCulture), StringComparison.Ordinal)
            .Replace("+-", "-", StringComparison.Ordinal));
        var tries = Config.QuickThrowOnFailure.WithMaxTest(Depth.Of(1000, 5000)).WithEndSize(30);
        Check.One(tries, Prop.ForAll(line.ArrayOf().ToArbitrary(), p =>
        {
            var path = Bench.Read(Head + string.Join('\n', p) + "\n", NcDialects.HeidenhainKlartext);
            var blocks = Enumerable.Range(3, path.Program.BlockCount - 3).Where(b => b % 3 > 0).ToArray();
            foreach (var wish in (Outcome<DisplacementWish>[])[
                DisplacementWish.Normal(path, blocks, 0.1), DisplacementWish.EndsBy(path, blocks, new(0.1, -0.2, 0))])
            {
                if (wish.IsUsable && Rewriter.Apply(path, wish.Result) is { IsUsable: true, Result: var rewrite })
                {
                    Prover.Check(path, rewrite.Program, wish.Result, rewrite.LeastIncrementMm);
                    Assert.Equal(path.Program.BlockCount, rewrite.Program.BlockCount);
                }
            }

            return true;
        }));
    }

    [Fact]
    public void Mutated_programs_are_read_without_loss_and_displaced_or_refused()
    {
        var sample = File.ReadAllBytes(Repository.PathTo("samples", "klartext-mating", "counterpart.h"));
        var random = new Random(28);
        var (displaced, refused) = (0, 0);
        for (var i = 0; i < 2000; i++)
        {
            var bytes = sample.ToList();
            for (var n = random.Next(1, 4); n > 0; n--)
            {
                var at = random.Next(bytes.Count);
                switch (random.Next(4))
                {
                    case 0: bytes[at] = (byte)random.Next(256); break;
                    case 1: bytes.RemoveAt(at); break;
                    case 2: bytes.Insert(at, bytes[random.Next(bytes.Count)]); break;
                    default: bytes.RemoveRange(at, Math.Min(bytes.Count - at, random.Next(40))); break;
                }
            }

            var path = NcInterpreter.Run(NcProgram.Read(bytes.ToArray(), NcSyntax.Klartext), NcDialects.HeidenhainKlartext);
            Assert.True(NcCensus.Of(path.Program).RoundTrips);
            var blocks = Enumerable.Range(0, path.Program.BlockCount).Where(b => b is > 8 and < 20).ToArray();
            var wish = DisplacementWish.Normal(path, blocks, 0.05);
            var rewrite = wish.IsUsable ? Rewriter.Apply(path, wish.Result) : wish.Refusal;
            (displaced, refused) = rewrite.IsUsable ? (displaced + 1, refused) : (displaced, refused + 1);
            var hasPlace = rewrite.IsUsable || rewrite.Refusal.Place.Line > 0 || rewrite.Refusal.Code == "no-motion";
            Assert.True(hasPlace, rewrite.Refusal?.ToString());
        }

        Assert.True(displaced > 400 && refused > 400, $"{displaced} displaced, {refused} refused");
    }

    private static string By(string text, Vector3 by, string selector) =>
        Bench.By(text, by, selector, NcDialects.HeidenhainKlartext);
}
