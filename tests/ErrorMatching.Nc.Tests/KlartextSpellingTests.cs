using System.Text;
using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>Klartext spelling: what each stretch of a block is, read off by hand.</summary>
public sealed class KlartextSpellingTests
{
    private static readonly Config Tries = Config.QuickThrowOnFailure.WithMaxTest(Depth.Of(1000, 5000));
    private static readonly string[] Pieces =
    [
        "12 ", "0  ", "N5 ", "L ", "C ", "CC ", "CR ", "CT ", "CP ", "LP ", "RND R2", "CHF 1.5", "APPR LCT ", "DEP LT ", "X+10 ",
        "IY-2.5 ", "Z+Q5 ", "R0 ", "RL ", "R+5 ", "FMAX ", "F MAX", "F200 ", "M3 ", "M91", "M118 Z1", "DR+ ", "DR-", "PR+5 ", "IPA-90 ",
        "LEN15 ", "; c", "* - s", "~", "\"A B\"", "Q1 = Q2 + 3", "FN 9: IF +Q1 EQU +Q3 GOTO LBL 5", "CALL LBL 5 REP 2", "LBL \"A\"",
        "TOOL CALL 5 Z S10 DL+0.1", "CYCL DEF 7.1 X+5", "CYCL DEF 200 DRILLING ~", "BEGIN PGM A MM", "END PGM A INCH",
        "BLK FORM 0.1 Z X-5", "PLANE RESET STAY", "FL X+1", "?", ",", ".", "+", "-", "/", "\t", "é", "\0", "=", "(",
    ];

    [Theory]
    [InlineData("12 L X+10 IY-5.5 R0 FMAX M3", "N=12 | # L | X=10 | Y=i-5.5 | # R0 | # FMAX | M=3")]
    [InlineData("12  L  X+10  Y-5 RL F200", "N=12 | # L | X=10 | Y=-5 | # RL | F=200")]
    [InlineData("L X10 Z0 F MAX M13", "# L | X=10 | Z=0 | # F MAX | M=13")]
    [InlineData("N6 APPR LCT X45 Y0 R20 RL F220", "N=6 | # APPR LCT | X=45 | Y=0 | R=20 | # RL | F=220")]
    [InlineData("7 DEP LT LEN+12.5 F100", "N=7 | # DEP LT | L=12.5 | F=100")]
    [InlineData("8 DEP CT CCA180 R+30", "N=8 | # DEP CT | AR=180 | R=30")]
    [InlineData("9 CC X+50 IY+0", "N=9 | # CC | X=50 | Y=i0")]
    [InlineData("10 C X+50 Y+30 DR-", "N=10 | # C | X=50 | Y=30 | # DR-")]
    [InlineData("11 L A+10 C-Q5 B+0", "N=11 | # L | A=10 | C?-Q5 | B=0")]
    [InlineData("12 CR X+1 R-20.5 DR+ R0", "N=12 | # CR | X=1 | R=-20.5 | # DR+ | # R0")]
    [InlineData("13 RND R0.5 F50", "N=13 | # RND | R=0.5 | F=50")]
    [InlineData("14 CHF 12", "N=14 | # CHF | ,C=12")]
    [InlineData("14 CHF Q3", "N=14 | # CHF | ,C?Q3")]
    [InlineData("15 LP PR+10 IPA-30 IZ+2", "N=15 | # LP | ! PR+10 | ! IPA-30 | Z=i2")]
    [InlineData("16 L X+Q12 Y-QL3 FQ11", "N=16 | # L | X?+Q12 | Y?-QL3 | F?Q11")]
    [InlineData("17 Q5 = ( Q1 - 4 ) / 2 ; half", "N=17 | := Q5 = ( Q1 - 4 ) / 2 | c ; half")]
    [InlineData("18 FN 0: Q5 = +60", "N=18 | # FN 0: Q5 = +60")]
    [InlineData("19 CALL LBL \"A;B\" REP 2 ; twice", "N=19 | # CALL LBL \"A;B\" REP 2 | c ; twice")]
    [InlineData("20 TOOL CALL 5 Z S3000 F200 DL+0.1 DR-0.05", "N=20 | # TOOL CALL | T=5 | # Z | S=3000 | F=200 | # DL+0.1 | # DR-0.05")]
    [InlineData("20 TOOL CALL \"D 10\" Z S5000", "N=20 | # TOOL CALL | T?\"D 10\" | # Z | S=5000")]
    [InlineData("20 TOOL CALL S5000", "N=20 | # TOOL CALL | S=5000")]
    [InlineData("21 CYCL DEF 7.1 X+60 IY-5", "N=21 | # CYCL DEF 7.1 | X=60 | Y=i-5")]
    [InlineData("21 CYCL DEF 19.1 A+45 B+0", "N=21 | # CYCL DEF 19.1 A+45 B+0")]
    [InlineData("21 CYCL DEF 26.1 X1.4 Y0.6", "N=21 | # CYCL DEF 26.1 X1.4 Y0.6")]
    [InlineData("21 CYCL DEF 7.1 #5", "N=21 | # CYCL DEF 7.1 #5")]
    [InlineData("22 CYCL DEF 200 DRILLING ~", "N=22 | # CYCL DEF 200 DRILLING")]
    [InlineData("   Q200=+2 ;SET-UP CLEARANCE ~", ":= Q200=+2 | c ;SET-UP CLEARANCE ~")]
    [InlineData("0 BEGIN PGM A-1 MM ", "N=0 | # BEGIN PGM A-1 | # MM")]
    [InlineData("99 END PGM A-1 MM", "N=99 | # END PGM A-1 MM")]
    [InlineData("23 * - Contour L X+5", "N=23 | c * - Contour L X+5")]
    [InlineData("24 L X+0 M118 Z1 W5 M3", "N=24 | # L | X=0 | # M118 Z1 W5 | M=3")]
    [InlineData("25 L Z-1 R0 FMAX M91", "N=25 | # L | Z=-1 | # R0 | # FMAX | # M91")]
    [InlineData("26 L M140 MB MAX F100", "N=26 | # L | # M140 MB MAX F100")]
    [InlineData("27 /L X+1", "N=27 | / / | # L | X=1")]
    [InlineData("/27 L X+1", "/ / | N=27 | # L | X=1")]
    [InlineData("28 L X+10,5", "N=28 | # L | X=10 | ! , | ! 5")]
    [InlineData("29 L X Y+5", "N=29 | # L | ! X | Y=5")]
    [InlineData("30 STOP M8", "N=30 | # STOP | M=8")]
    [InlineData("31 PLANE SPATIAL SPA+0 X5", "N=31 | # PLANE SPATIAL SPA+0 X5")]
    [InlineData("32 FZ0.1 FU0.2 FAUTO", "N=32 | # FZ0.1 FU0.2 FAUTO")]
    [InlineData("32 L FZ0.1 FU0.2 FAUTO", "N=32 | # L | # FZ0.1 | # FU0.2 | # FAUTO")]
    public void Tokens_are_these(string line, string tokens) => Assert.Equal(tokens, Spelled.Tokens(line, NcSyntax.Klartext));

    [Theory]
    [InlineData("L", "L")]
    [InlineData("F max", "Fmax")]
    [InlineData("R0", "R0")]
    [InlineData("BEGIN PGM A", "BEGINPGM")]
    [InlineData("CYCL DEF 200 DRILLING", "CYCLDEF200")]
    [InlineData("CYCL DEF 7.0 DATUM", "CYCLDEF7")]
    [InlineData("CYCL DEF 7.1", "CYCLDEF7SUB")]
    [InlineData("CYCL DEF 10.1 ROT+0", "CYCLDEF10RESET")]
    [InlineData("CYCL DEF 10.1 ROT+35", "CYCLDEF10SUB")]
    [InlineData("CYCL DEF 11.1 SCL 1", "CYCLDEF11RESET")]
    [InlineData("CYCL DEF 8.1", "CYCLDEF8RESET")]
    [InlineData("CYCL DEF 8.1 X", "CYCLDEF8SUB")]
    [InlineData("CYCL DEF 19.1", "CYCLDEF19RESET")]
    [InlineData("CYCL DEF 19.1 A+45 B+0", "CYCLDEF19SUB")]
    [InlineData("PLANE RESET STAY", "PLANERESET")]
    [InlineData("PLANE SPATIAL SPA0 SPB+0.000 SPC0 STAY SEQ+ TABLE ROT", "PLANERESET")]
    [InlineData("PLANE SPATIAL SPA0 SPB+0.001 SPC0 STAY", "PLANESPATIAL")]
    [InlineData("PLANE SPATIAL SPA+Q0 SPB0 SPC0 STAY", "PLANESPATIAL")]
    [InlineData("DEP LCT", "DEPLCT")]
    [InlineData("DR-0.1", "DR")]
    [InlineData("M140 MB MAX", "M140")]
    [InlineData("FN 09: IF", "FN9")]
    public void A_keyword_has_a_name(string keyword, string name) => Assert.Equal(
        name, Encoding.ASCII.GetString(LanguageSpelling.Of(NcSyntax.Klartext)!.NameOf(Encoding.ASCII.GetBytes(keyword))));

    [Fact]
    public void Tokens_follow_one_another_without_gaps() =>
        Check.One(Tries, Prop.ForAll(Gen.Elements(Pieces).ArrayOf().ToArbitrary(), pieces =>
        {
            var program = NcProgram.FromText(string.Concat(pieces).Replace('\n', ' '), NcSyntax.Klartext);
            var at = 0;
            for (var block = 0; block < program.BlockCount; block++)
            {
                foreach (var token in program.Tokens(program[block]))
                {
                    Assert.Equal(at, token.Start);
                    Assert.True(token.Length > 0 && token.ValueStart >= token.Start && token.ValueStart + token.ValueLength <= token.End);
                    at = token.End;
                }
            }

            return at == program.Bytes.Length;
        }));

    [Fact]
    public void The_marker_is_a_comment_behind_the_heading()
    {
        var marker = new Marker(new string('a', 64), new string('b', 64));
        var program = NcProgram.FromText("; a note\r\n0 BEGIN PGM A MM\r\n1 L X+1 R0 FMAX\r\n2 END PGM A MM\r\n", NcSyntax.Klartext);
        var marked = NcProgram.Read(marker.InsertInto(program), NcSyntax.Klartext);
        Assert.Equal($"; ERRORMATCH MEASUREMENT={new string('A', 64)} BASE={new string('B', 64)}", marked.TextOf(marked[2]));
        Assert.Equal((5, "1 L X+1 R0 FMAX"), (marked.BlockCount, marked.TextOf(marked[3])));
        Assert.Equal((2, marker), Assert.Single(Marker.Find(marked)));
    }
}
