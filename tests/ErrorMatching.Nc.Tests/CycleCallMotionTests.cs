using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// Siemens deep holes and patterns of holes as motions, worked out by hand from the rules that docs/dialects.md states. Each program begins
/// at the origin; the tool goes to 10 above it.
/// </summary>
public sealed class CycleCallMotionTests
{
    [Theory]

    // Return plane 10, reference plane 0, safety 2, depth -10, first depth -5 (or 5 below the reference plane), no degression:
    // strokes to -5 and -10. VARI=0 lifts by 1 at feed, VARI=1 goes to 2 and back to 0.6 above the last depth (holes up to 30 deep).
    [InlineData("CYCLE83(10,0,2,-10,,-5)", "R1,0,2 L1,0,-5 L1,0,-4 L1,0,-10 R1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,,5)", "R1,0,2 L1,0,-5 L1,0,-4 L1,0,-10 R1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,-5,,0,0,0,1,1)", "R1,0,2 L1,0,-5 R1,0,2 R1,0,-4.4 L1,0,-10 R1,0,10")]
    [InlineData("CYCLE83(10,0,2,,10,,5,0,0,0,1,0,3)", "R1,0,2 L1,0,-5 L1,0,-4 L1,0,-10 R1,0,10")]

    // The last stroke ends at the depth: 4, 4, 2.
    [InlineData("CYCLE83(10,0,2,-10,,-4)", "R1,0,2 L1,0,-4 L1,0,-3 L1,0,-8 L1,0,-7 L1,0,-10 R1,0,10")]

    // One stroke where the first depth is not above the depth.
    [InlineData("CYCLE83(10,0,2,-10,,-10)", "R1,0,2 L1,0,-10 R1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,-12,,3)", "R1,0,2 L1,0,-10 R1,0,10")]

    // Lift (15th argument) 0.5; rapid ends 2 above the last depth (17th argument).
    [InlineData("CYCLE83(10,0,2,-10,,-5,,0,0,0,1,0,0,0,0.5)", "R1,0,2 L1,0,-5 L1,0,-4.5 L1,0,-10 R1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,-5,,0,0,0,1,1,0,0,0,0,2)", "R1,0,2 L1,0,-5 R1,0,2 R1,0,-3 L1,0,-10 R1,0,10")]

    // 145 deep from 150 with first 50 and degression 20: 50, 30, 20, 20 leave 25, not more than twice 20: 12.5 and 12.5.
    // 100 -> 70 -> 50 -> 30 -> 17.5 -> 5. Rapids end 145 / 50 = 2.9 above the last depth.
    [InlineData(
        "CYCLE83(155,150,1,5,,100,,20,0,0,1,1)",
        "R1,0,151 L1,0,100 R1,0,151 R1,0,102.9 L1,0,70 R1,0,151 R1,0,72.9 L1,0,50 R1,0,151 R1,0,52.9 L1,0,30 R1,0,151 R1,0,32.9 "
            + "L1,0,17.5 R1,0,151 R1,0,20.4 L1,0,5 R1,0,155")]

    // 400 deep: 400 / 50 = 8 would be more than 7.
    [InlineData("CYCLE83(10,0,2,-400,,-200,,0,0,0,1,1)", "R1,0,2 L1,0,-200 R1,0,2 R1,0,-193 L1,0,-400 R1,0,10")]

    // In inches all lengths are.
    [InlineData("G70\nCYCLE83(1,0,0.1,-1,,-0.5,,0,0,0,1,0,0,0,0.1)", "R1,0,2.54 L1,0,-12.7 L1,0,-10.16 L1,0,-25.4 R1,0,25.4")]

    // Upwards: from a reference plane below to a depth above.
    [InlineData("CYCLE83(-10,0,2,10,,5)", "R1,0,-2 L1,0,5 L1,0,4 L1,0,10 R1,0,-10")]

    // Nothing below the reference plane is no depth.
    [InlineData("CYCLE83(10,0,2,-10,0,-5,0)", "R1,0,2 L1,0,-5 L1,0,-4 L1,0,-10 R1,0,10")]

    // Not followed: no first depth; one above the reference plane; one that disagrees with the one below it; degression by a factor; a
    // first stroke shorter than the degression; strokes that no rule gives (50 and 40 of 100, then 30 where 10 remain; 50 of 60 with
    // degression 40, then halves of 10); another axis; neither 0 nor 1; later modes; values that only the machine knows.
    [InlineData("CYCLE83(10,0,2,-10)", "C1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,5)", "C1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,-5,4)", "C1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,-5,,-0.8)", "C1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,-2,,3)", "C1,0,10")]
    [InlineData("CYCLE83(10,0,2,-100,,-50,,10)", "C1,0,10")]
    [InlineData("CYCLE83(10,0,2,-60,,-50,,40)", "C1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,-5,,0,0,0,1,1,1)", "C1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,-5,,0,0,0,1,2)", "C1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,-5,,0,0,0,1,1,0,0,1,0,1,10)", "C1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,-5,,0,0,0,1,1,0,0,1,0,1,0,1,1000)", "C1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,$A_INA[1])", "C1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,-5,,$A_INA[1])", "C1,0,10")]
    [InlineData("CYCLE83(10,0,2,-10,,-5,,0,0,0,1,0,0,0,$A_INA[1])", "C1,0,10")]
    [InlineData("CYCLE83($A_INA[1],0,2,-10,,-5)", "C1,0,?")]

    // As many strokes as nobody drills.
    [InlineData("CYCLE83(10,0,2,-10,,-0.00005)\nCYCLE83(10,0,2,-10,,-5)", "C1,0,10 C1,0,10")]
    public void Deep_holes(string call, string moves) =>
        Assert.Equal("R0,0,10 R1,0,10 " + moves, Moves.Of("siemens-840d", "Z10 F100\nX1\n" + call));

    [Fact]
    public void Strokes_deepen_to_the_depth_get_no_longer_and_are_longer_than_half_of_the_degression()
    {
        var followed = 0;
        Check.One(
            Config.QuickThrowOnFailure.WithMaxTest(400),
            Prop.ForAll(Gen.Choose(1, 300).Zip(Gen.Choose(1, 120)).Zip(Gen.Choose(0, 40)).ToArbitrary(), p =>
        {
            var ((total, first), less) = p;
            var path = Bench.Read(
                FormattableString.Invariant($"G90 G17 G71 G94 G0 X0 Y0 Z10 F100\nCYCLE83(10,0,2,{-total},,{-first},,{less})\n"),
                NcDialects.Siemens840D);
            Assert.Equal(10, path.Motions[^1].End.Z);
            if (path.Motions[^1].Kind == MotionKind.Cycle)
            {
                return;
            }

            followed++;
            var depths = path.Motions.Where(m => m.Kind == MotionKind.Line && m.End.Z < m.Start.Z)
                .Select(m => -m.End.Z)
                .Prepend(0)
                .ToArray();
            var strokes = depths.Zip(depths.Skip(1), (a, b) => b - a).ToArray();
            Assert.Equal(total, depths[^1]);
            Assert.Equal(Math.Min(first, total), strokes[0]);
            Assert.All(strokes, s => Assert.True(s > 0 && (strokes.Length == 1 || s > less / 2.0)));
            Assert.All(strokes.Zip(strokes.Skip(1)), s => Assert.True(s.Second <= s.First + 1e-9));
            Assert.True(less == 0 || strokes.Length < 3 || strokes[1] == Math.Max(first - less, less) || strokes[1] < less);
        }));
        Assert.True(followed > 100);
    }

    [Fact]
    public void First_stroke_of_a_deep_hole_has_its_part_of_the_feed()
    {
        var path = Bench.Read("G90 G17 G71 G94 G0 X0 Y0 Z10 F100\nCYCLE83(10,0,2,-10,,-5,,0,0,0,0.5)\nG1 X5\n", NcDialects.Siemens840D);
        Assert.Equal([50.0, 100, 100, 100], Feeds(path));
    }

    [Fact]
    public void Boring_has_its_own_feeds_in_and_out()
    {
        var path = Bench.Read("G90 G17 G71 G94 G0 X0 Y0 Z10 F100\nCYCLE85(10,0,2,-10,,0,80,300)\nG1 X5\n", NcDialects.Siemens840D);
        Assert.Equal([80.0, 300, 100], Feeds(path));
    }

    [Theory]

    // A row at 30 degrees about (10,0), 10 from there to the first hole and 20 from hole to hole: cos 30 = 0.866025, sin 30 = 0.5.
    // It only positions where no cycle is modal.
    [InlineData("HOLES1(10,0,30,10,20,2)", "R18.6603,5,10 R35.9808,15,10")]
    [InlineData("HOLES1(10,5,90,0,20,3)", "R10,5,10 R10,25,10 R10,45,10")]
    [InlineData(
        "MCALL CYCLE81(10,0,2,-5)\nHOLES1(10,0,0,0,10,2)\nMCALL", "R10,0,10 R10,0,2 L10,0,-5 R10,0,10 R20,0,10 R20,0,2 L20,0,-5 R20,0,10")]

    // It begins at the nearer end: from (50,0) with the hole at 30, not 10.
    [InlineData("X50\nHOLES1(10,0,0,0,10,3)", "R50,0,10 R30,0,10 R20,0,10 R10,0,10")]

    // At which end it stops is not relied on; a coordinate that is stated is known.
    [InlineData("HOLES1(10,0,0,0,10,2)\nX5\nY3", "R10,0,10 R20,0,10 R5,?,10 R5,3,10")]
    [InlineData("HOLES1(10,0,0,0,10,1)\nX5", "R10,0,10 R5,0,10")]

    // Neither end is nearer, or nobody knows where the tool is, or later arguments say more.
    [InlineData("X15\nHOLES1(10,0,0,0,10,2)", "R15,0,10 C?,?,?")]
    [InlineData("X=$A_INA[1]\nHOLES1(10,0,0,0,10,2)", "R?,0,10 C?,?,?")]
    [InlineData("HOLES1(10,0,0,0,10,2,1010)", "C?,?,?")]
    [InlineData("HOLES1(10,0,0,0,10,2,0,0,\"2\")", "C?,?,?")]
    [InlineData("HOLES1(10,0,0,0,$A_INA[1],2)", "C?,?,?")]
    [InlineData("HOLES1(10,0,0,0,10,0)", "C?,?,?")]
    [InlineData("HOLES1(10,0,0,0,10,1.5)", "C?,?,?")]
    [InlineData("HOLES1(10,0,0,0,10,1000000000)", "C?,?,?")]

    // A circle about (70,60) of radius 42, first hole at 33 degrees, four all around: cos 33 = 0.838671, sin 33 = 0.544639;
    // the others a quarter turn on.
    [InlineData("HOLES2(70,60,42,33,0,4)", "R105.2242,82.8748,10 R47.1252,95.2242,10 R34.7758,37.1252,10 R92.8748,24.7758,10")]
    [InlineData("HOLES2(0,0,10,0,90,2)", "R10,0,10 R0,10,10")]
    [InlineData("HOLES2(0,0,10,90,-90,2)", "R0,10,10 R10,0,10")]
    [InlineData(
        "MCALL CYCLE83(10,0,2,-10,,-5)\nHOLES2(0,0,10,0,180,2)\nMCALL",
        "R10,0,10 R10,0,2 L10,0,-5 L10,0,-4 L10,0,-10 R10,0,10 R-10,0,10 R-10,0,2 L-10,0,-5 L-10,0,-4 L-10,0,-10 R-10,0,10")]
    [InlineData("HOLES2(0,0,,0,90,2)", "C?,?,?")]

    // A circle goes from hole to hole wherever the tool was.
    [InlineData("X=$A_INA[1]\nHOLES2(0,0,10,0,90,2)", "R?,0,10 R10,0,10 R0,10,10")]

    // A cycle that is not followed ends at its return plane over each place; a pocket ends nobody knows where.
    [InlineData("MCALL CYCLE83(20,0,2,-10)\nHOLES2(0,0,10,0,90,2)\nMCALL", "R10,0,10 C10,0,20 R0,10,20 C0,10,20")]
    [InlineData("MCALL POCKET4(10,0,1,-5,8,0,0,4)\nHOLES2(0,0,10,0,90,2)\nMCALL", "R10,0,10 C?,?,? R0,10,? C?,?,?")]

    // A grid of 3 columns 10 apart and 2 rows 20 apart: the places are known, how it goes from one to the next is not.
    [InlineData("CYCLE801(5,5,0,10,20,3,2)", "C5,5,10 C15,5,10 C25,5,10 C25,25,10 C15,25,10 C5,25,10")]
    [InlineData("CYCLE801(5,5,90,10,20,2,1)", "C5,5,10 C5,15,10")]

    // The border of 3 by 3 leaves out the middle.
    [InlineData("CYCLE801(0,0,0,10,10,3,3,1)", "C0,0,10 C10,0,10 C20,0,10 C20,10,10 C0,10,10 C0,20,10 C10,20,10 C20,20,10")]
    [InlineData(
        "MCALL CYCLE81(10,0,2,-5)\nCYCLE801(0,0,0,10,10,1,2)\nMCALL\nX1",
        "C0,0,10 R0,0,2 L0,0,-5 R0,0,10 C0,10,10 R0,10,2 L0,10,-5 R0,10,10 R1,?,10")]
    [InlineData("CYCLE801(0,0,0,10,10,3,3,2)", "C?,?,?")]
    [InlineData("CYCLE801(0,0,0,10,10,100000,100000)", "C?,?,?")]

    // In G18 the plane's axes are Z and X; in inches all lengths are.
    [InlineData("G18\nHOLES2(0,0,10,0,90,2)", "R0,0,10 R10,0,0")]
    [InlineData("G70\nHOLES2(1,0,1,0,90,2)", "R50.8,0,10 R25.4,25.4,10")]
    public void Patterns(string calls, string moves) => Assert.Equal("R0,0,10 " + moves, Moves.Of("siemens-840d", "Z10 F100\n" + calls));

    [Fact]
    public void Nothing_of_a_pattern_is_changed_and_a_place_that_a_row_starts_from_is_kept()
    {
        var path = Bench.Read("G90 G17 G71 G94 G0 X0 Y0 Z10 F100\nG1 X5\nHOLES1(10,0,0,0,10,2)\n", NcDialects.Siemens840D);
        Assert.All(path.Motions.Skip(2), m => Assert.True(m.Has(MotionFlags.Cycle)));
        Assert.Contains((2, 2), path.PlaceDependents);
    }

    [Fact]
    public void A_grid_is_noted_since_its_order_is_not_known()
    {
        var path = Bench.Read(
            "G90 G17 G71 G94 G0 X0 Y0 Z10 F100\nCYCLE801(0,0,0,10,10,2,2)\nHOLES2(0,0,10,0,90,2)\n", NcDialects.Siemens840D);
        Assert.Equal([("cycle-not-followed", 1)], path.Notes.Select(n => (n.Code, n.Block)));
    }

    private static IEnumerable<double> Feeds(NcPath path) => path.Motions.Where(m => m.Kind == MotionKind.Line).Select(m => m.Feed);
}
