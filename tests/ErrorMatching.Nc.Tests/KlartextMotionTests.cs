using ErrorMatching.Geometry;
using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>Where the path functions of Klartext lead; the expected places are worked out by hand.</summary>
public sealed class KlartextMotionTests
{
    private const string Origin = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+0 Y+0 Z+0 R0 FMAX\n";

    [Theory]
    [InlineData("L X+10 Y-5 F100", "L10,-5,0")]
    [InlineData("L IX+10 FMAX\nL X-1 IX+2", "R10,0,0 L?,0,0")]
    [InlineData("L X+10 FMAX\nL Y+5", "R10,0,0 L10,5,0")]
    [InlineData("CC X+5 Y+0\nC X+10 Y+0 DR+", "CCW10,0,0@5,0")]
    [InlineData("CC X+5 Y+0\nC X+10 Y+0 DR-", "CW10,0,0@5,0")]
    [InlineData("CC IX+0 IY+5\nC X+0 Y+0 DR-", "CW0,0,0@0,5")]
    [InlineData("L X+3 Y+4 FMAX\nCC\nL X+8\nC X+3 Y+9 DR+", "R3,4,0 L8,4,0 CCW3,9,0@3,4")]
    [InlineData("CR X+10 Y+0 R+5 DR+", "CCW10,0,0@5,0")]
    [InlineData("CR X+6 Y+6 R+6 DR-", "CW6,6,0@6,0")]
    [InlineData("CR X+6 Y+6 R-6 DR-", "CW6,6,0@0,6")]
    [InlineData("L X+10 F100\nCT X+15 Y+5", "L10,0,0 CCW15,5,0@10,5")]
    [InlineData("CC X+10 Y+0\nCP IPA+90 DR+", "CCW10,-10,0@10,0")]
    [InlineData("CC X+10 Y+0\nCP PA+0 DR- IZ-3", "CW20,0,-3@10,0")]
    [InlineData("CC X+10 Y+0\nCP IPA-1170 IZ-3 DR-", "CW10,10,-3@10,0+3")]
    [InlineData("CC X+10 Y+0\nLP PR+5 PA+90\nLP IPR+5 IPA+90", "L10,5,0 L0,0,0")]
    [InlineData("CC X+10 Y+0\nLP PR+5 PA+0 Z-2", "L15,0,-2")]
    [InlineData("L X+10 F100\nRND R2\nL Y+10", "L8,0,0 CCW10,2,0@8,2 L10,10,0")]
    [InlineData("L X+10 F100\nCHF 3\nL Y+10", "L7,0,0 L10,3,0 L10,10,0")]
    [InlineData("APPR LT X+10 Y+5 LEN5 RL F100\nL X+20", "S10,5,0 L20,5,0")]
    [InlineData("L X+10 RL F100\nDEP LT LEN5\nL Z+5 FMAX", "L10,0,0 S?,?,0 R?,?,5")]
    [InlineData("L X+10 RL F100\nDEP LCT X+20 Y+9 R3\nL Z+5 FMAX", "L10,0,0 S20,9,0 R20,9,5")]
    [InlineData("L Z-1 R0 FMAX M91\nL X+1", "M0,0,? L1,0,?")]
    [InlineData("L M140 MB MAX\nL X+1", "M0,0,? L1,0,?")]
    [InlineData("L X+5 FMAX M99\nL Y+1", "R5,0,0 C?,?,? L?,1,?")]
    [InlineData("CYCL CALL\nL X+1 Y+2 Z+3", "C?,?,? L1,2,3")]
    [InlineData("TOOL CALL 2 Z\nL X+1 Y+2", "L1,2,?")]
    [InlineData("TOOL CALL S500\nL X+1 Y+2", "L1,2,0")]
    [InlineData("CYCL DEF 7.0 DATUM\nCYCL DEF 7.1 X+10\nCYCL DEF 7.2 Y+5\nL X+1 Y+1 Z+1\nCYCL DEF 7.1 IX+1\nL X+1", "L11,6,1 L12,6,1")]
    [InlineData("CYCL DEF 7.0 DATUM\nCYCL DEF 7.1 #5\nL X+1", "L1,?,?")]
    [InlineData("CYCL DEF 247 DATUM SETTING ~\n  Q339=+1 ;PRESET\nL X+1", "L1,?,?")]
    [InlineData("PLANE RESET TURN\nL X+1", "L1,?,?")]
    [InlineData("X+10", "")]
    [InlineData("L X+10 B+5", "L10,0,0")]
    [InlineData("M188\nL X+1 Y+1 Z+1", "L1,1,1")]
    [InlineData("M55\nL IX+1", "L1,0,0")]
    [InlineData("M188\nL IX+1", "L?,?,?")]
    [InlineData("CC X+5\nC X+10 DR+", "CCW10,0,0@5,0")]
    public void Motions_are_these(string blocks, string motions)
    {
        var path = Read(Origin + blocks + "\n");
        Assert.Equal(motions, Moves.Of(path, 1));
        Assert.Null(path.Refusal);
    }

    [Fact]
    public void The_axes_of_the_center_name_the_plane_of_the_arc()
    {
        // A quarter of a circle of 1.4 down from Z-9.6 to Z-11, as a post processor writes it.
        var path = Read(Origin + "L Y-131.2 Z-9.6 FMAX\nCC Y-129.8 Z-9.6\nCP IPA+90 DR+\nL Y-128.4 Z-11\n");
        var arc = path.Motions[2];
        Assert.Equal((CoordinatePlane.YZ, -129.8, -11.0), (arc.Plane, Math.Round(arc.End.Y, 9), Math.Round(arc.End.Z, 9)));
        Assert.Equal(CoordinatePlane.XY, path.Motions[3].Plane);
    }

    [Theory]
    [InlineData("C X+10 Y+0 DR+", "bad-arc")]
    [InlineData("CC X+5 Y+0\nC X+10 Y+0", "bad-arc")]
    [InlineData("CC X+5 Y+0\nC DR+", "bad-arc")]
    [InlineData("CC X+5 Y+0\nC X+10.1 Y+0 DR+", "bad-arc")]
    [InlineData("CR X+10 Y+0 R+4 DR+", "bad-arc")]
    [InlineData("CC X+5 Y+0 Z+0", "unknown-pole")]
    [InlineData("X+10", "unknown-word")]
    [InlineData("L X+10,5", "unknown-word")]
    [InlineData("L X+1 ZZ+3", "unknown-word")]
    [InlineData("LN X+1 Y+1 NX+0", "unknown-word")]
    [InlineData("TCH PROBE 0.0 REF", "unknown-word")]
    [InlineData("CYCL DEF 220 POLAR PATTERN", "unknown-word")]
    [InlineData("M188", "unknown-word")]
    [InlineData("L X+1 ~", "unknown-word")]
    [InlineData("CC X+5 Y+0\nC X+10 Y+0 Z+1 DR+", "bad-arc")]
    [InlineData("RND R2", "corner-word")]
    public void What_is_not_understood_is_named(string blocks, string code)
    {
        var problem = Read(Origin + "5 L X+0 FMAX\n" + blocks + "\n").Problems[0];
        Assert.Equal(code, problem.Code);
        Assert.Equal(4 + blocks.Count(c => c == '\n'), problem.Block);
    }

    // Where it touched, and how far it went back, only the machine knows.
    [Fact]
    public void Behind_a_touch_the_place_is_unknown_until_it_is_stated()
    {
        const string Touch = "TCH PROBE 3.0 MEASURING\nTCH PROBE 3.1 Q1\nTCH PROBE 3.2 X ANGLE: -30\n"
            + "TCH PROBE 3.3 DIST +4 F100 MB2 REFERENCE SYSTEM: 0\nTCH PROBE 3.4 ERRORMODE0\n";
        var path = Read(Origin + Touch + "L Z+50 FMAX\nL X+9 Y+8 Z+50 F500\n");
        Assert.Empty(path.Problems);
        Assert.DoesNotContain(path.Notes, n => n.Code == "cycle-not-followed");
        var motions = path.Motions.ToArray()[^3..];
        Assert.Equal((MotionKind.Probe, AxisSet.All), (motions[0].Kind, motions[0].UnknownEnd));
        Assert.Equal((AxisSet.X | AxisSet.Y, AxisSet.None), (motions[1].UnknownEnd, motions[2].UnknownEnd));
        Assert.Equal("unknown-word", Read(Origin + Touch.Replace("3.", "1.", StringComparison.Ordinal)).Problems[0].Code);
    }

    // A probing program has such a branch at every point.
    [Theory]
    [InlineData("STOP\nM30\n", null)]
    [InlineData("; not touched\nSTOP ; look\nM2\n", null)]
    [InlineData("L Z+9 FMAX\nM30\n", "unknown-condition")]
    [InlineData("STOP\n", "unknown-condition")]
    public void A_branch_that_only_stops_is_passed_where_only_the_machine_knows(string stopped, string? refusal)
    {
        var points = string.Concat(Enumerable.Range(1, 9).Select(i =>
            $"FN 18: SYSREAD Q4 = ID990 NR1\nFN 9: IF +Q4 EQU -1 GOTO LBL \"MISSED\"\nL X+{i} Y+0 Z+1 F500\n"));
        var path = Read(Origin + points + $"M30\nLBL \"MISSED\"\n{stopped}");
        Assert.Equal(refusal, path.Refusal?.Code);
        Assert.Equal(refusal is null, path.Notes.Any(n => n.Code == "conditional-stop"));
    }

    [Fact]
    public void Free_contours_are_refused_with_their_place()
    {
        var refusal = Read(Origin + "5 FPOL X+0 Y+0\n6 FL X+5\n").Refusal!;
        Assert.Equal(("not-a-simple-move", 4), (refusal.Code, refusal.Place.Line));
    }

    [Fact]
    public void A_program_in_inches_is_read_in_millimeters() =>
        Assert.Equal(
            "R25.4,0,-2.54 L48.26,0,-2.54 CCW50.8,2.54,-2.54@48.26,2.54 L50.8,25.4,-2.54",
            Moves.Of(Read("0 BEGIN PGM A INCH\n1 L X+1 Y+0 Z-0.1 R0 FMAX\n2 L X+2 F5\n3 RND R0.1\n4 L Y+1\n99 END PGM A INCH\n")));

    [Fact]
    public void Compensation_is_a_mode_and_a_departure_ends_it()
    {
        var path = Read(Origin + "L X+5 RL F100\nL X+9\nDEP LN LEN5\nL Y+50 FMAX\n");
        Assert.Equal(
            [false, true, true, false, false], path.Motions.Select(m => m.Has(MotionFlags.CompensationLeft)));
        Assert.Equal([false, true, false, true, false], path.Motions.Select(m => m.Has(MotionFlags.CompensationSwitches)));
    }

    [Fact]
    public void Any_words_are_interpreted()
    {
        string[] words =
        [
            "1 L X+1 Y+2 Z+3 R0 FMAX", "L", "C", "CC", "CR", "CT", "CP", "LP", "CTP", "RND", "CHF", "APPR LT", "DEP LCT", "X+1", "IY-2",
            "Z+Q1", "IX+Q2", "R0", "RL", "RR", "R+5", "R-Q3", "FMAX", "F100", "FQ1", "M3", "M91", "M99", "M89", "M30", "M140 MB5", "DR+",
            "DR-", "PR+3", "PA+Q1", "IPA-30", "IPR+1", "LEN5", "CCA90", "A+5", "\nQ1 = Q2 + 1\n", "\nQ2 = SQRT Q1\n",
            "\nFN 0: Q1 = +3\n", "\nFN 4: Q2 = +8 DIV +Q1\n", "\nFN 9: IF +Q1 EQU +3 GOTO LBL 1\n", "\nLBL 1\n", "\nLBL 0\n",
            "\nCALL LBL 1\n", "\nCALL LBL 1 REP 2\n", "\nCALL PGM A\n", "\nTOOL CALL 3 Z S100\n", "\nCYCL DEF 7.1 X+5\n",
            "\nCYCL DEF 10.1 ROT+5\n", "\nPLANE RESET STAY\n", "\nCYCL CALL\n", "\n", "\n", "\n", "/", "~", ";", "\"", "?", ",", "\0",
        ];
        var programs = Gen.Elements(words).ArrayOf().ToArbitrary();
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(Depth.Of(1000, 5000)).WithEndSize(40), Prop.ForAll(programs, p =>
        {
            var path = Read(string.Join(' ', p));
            Assert.All(path.Motions, m => Assert.True(double.IsFinite(m.End.X + m.End.Y + m.End.Z + m.Center.X + m.Center.Y)));
            return path.Refusal is null || path.Refusal.Place.Line > 0;
        }));
    }

    private static NcPath Read(string text) => Bench.Read(text, NcDialects.HeidenhainKlartext);
}
