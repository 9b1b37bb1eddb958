using System.Globalization;
using System.Text;
using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

/// <summary>Each dialect's reader, with programs that repeat one thing for ever.</summary>
public class ReadingCostTests
{
    private static readonly string[] Lexemes =
    [
        "-", "+", "--", "1", ".", "(", ")", "[", "]", "[[", "]]", "(()", "#", "##", "#1=", "#1", "#[", "$", "$$", "\"", "'", ";", ":", "/",
        "//", "\\", "%", "=",
        " ", "\t", "\n", "\r", ",", "*", "?", "<", ">", "<a", "{", "}", "|", "^", "@", "X", "X1", "X1 ", "G", "G1", "G1 ", "M98", "M98 P",
        "M98 -",
        "O", "O1", "o<", "o1 sub ", "E", "e1", "R1=", "R1", "IF", "IF ", "IF[", "IF ", "SIN(", "SIN[", "AC(", "IC(", "DEF REAL A§ ",
        "A§=1\n", "#§=1\n", "R§=1\n", "Q§=1\n",
        "#<_v§>=1\n", "N§ X1\n", "N1 X1\n", "O§\n", "O§\nM99\n", ":§\n", "LBL §\n", "L§:\n", "GOTO §\n", "GOTOF L§\n", "M98 P§\n",
        "G65 P1 A1\n", "IF[#1EQ§]GOTO 1\n", "WHILE[#1LT0]DO1\n",
        "WHILE[0]DO1\nEND1\n", "o§ sub\no§ endsub\n", "o§ call\n", "o§ if [0]\n", "o§ while [0]\n", "PROC P§\nRET\n", "IF R1==1\n",
        "FOR R1=1 TO 2\n", "REPEAT\n", "LOOP\n",
        "CYCL DEF 7.0\n", "CC X0 Y0\n", "L X§ Y1\n", "C X1 Y1 DR+\n", "CALL LBL 1\n", "FN 0: Q1 = +1\n", "CALL OA§\n", "VC1=1\n",
        "G54.1 P§\n", "G10 L2 P1 X§\n", "G68 X0 Y0 R1\n",
        "G41 D1\n", "G2 X1 Y1 I1\n", "G2 X1 Y1 R1\n", "G81 R1 Z-1\n", "G1 X§ Y§\n", "(MSG, x)", "(c)\n", "; c\n", "/1 X1\n", "<tag>\n",
        "TRANS X1\n", "ROT RPL=1\n", "CYCLE81(1,1,1)\n", "MCALL CYCLE81(1,1,1)\n", "G33 X1 K1\n", "T1 M6\n", "M97 P§\n", "#3000=1\n",
        "#3006=1(x)\n", "%\n", ";\n%\n", "IF[#0EQ#5061]THEN#3000=1\n", "A=REP(0)\n", "STRING", "G83 Z-9 Q.001 R0\n",
        "é", "\uFEFF", "\0",
    ];

    // One control of each family that spells for itself.
    [Theory]
    [InlineData("fanuc")]
    [InlineData("haas")]
    [InlineData("siemens-840d")]
    [InlineData("linuxcnc")]
    [InlineData("heidenhain-klartext")]
    [InlineData("okuma-osp")]
    [InlineData("grbl")]
    public void Programs(string name)
    {
        var dialect = NcDialects.Named(name);
        ReadingCost.IsLinear(
            1 << 13,
            bytes => Assert.NotNull(NcInterpreter.Run(NcProgram.Read(bytes), dialect).Motions),
            Lexemes.SelectMany(l => new[] { ("", l, ""), ("N10 M98 ", l, " P1\n") }));
    }

    // What took time with the square of the input, or without a limit.
    [Theory]
    [InlineData("fanuc", "N10 M98 ", "-", "\n")]
    [InlineData("fanuc", "", "#3000=1\n", "")]
    [InlineData("fanuc", "", "%\n", "")]
    [InlineData("fanuc", "", "IF[#5061EQ0]THEN#3000=1\n", "")]
    [InlineData("linuxcnc", "", "#<v§>=1\nG92 X0\n", "")]
    [InlineData("okuma-osp", "", "%\n", "")]
    [InlineData("okuma-osp", "", "(()", "")]
    [InlineData("okuma-osp", "N10 M98 ", "O1", "\n")]
    public void What_was_slow(string name, string head, string fragment, string tail)
    {
        var dialect = NcDialects.Named(name);
        ReadingCost.IsLinear(
            1 << 17, bytes => Assert.NotNull(NcInterpreter.Run(NcProgram.Read(bytes), dialect).Motions), (head, fragment, tail));
    }

    [Theory]
    [InlineData("fanuc", "#1=0\nWHILE[#1LT400000]DO1\n#1=#1+1\n({0})\nEND1\nM30\n")]
    [InlineData("fanuc", "#1=0\nN1#1=#1+1\nIF[#1LT400000]GOTO[#1-#1+1]\n({0})\nG0X0\nM30\n")]
    [InlineData("siemens-840d", "R1=0\nWHILE R1<400000\nR1=R1+1\nMSG(\"{0}\")\nENDWHILE\nM30\n")]
    [InlineData("siemens-840d", "DEF REAL A[100000]\nR1=0\nWHILE R1<400000\nR1=R1+1\nA[0]=REP(R1)\nENDWHILE\nM30\n")]
    public void A_small_program_is_executed_or_refused_in_a_second(string name, string text)
    {
        var program = NcProgram.Read(Encoding.ASCII.GetBytes(string.Format(CultureInfo.InvariantCulture, text, new string('x', 27_000))));
        NcPath? path = null;
        var seconds = ReadingCost.Seconds(() => path = NcInterpreter.Run(program, NcDialects.Named(name)));
        Assert.True(path!.Refusal is null or { Code: NcRefusalCodes.EndlessLoop }, path.Refusal?.Message);
#if DEBUG
        Assert.InRange(seconds, 0, 10);
#else
        Assert.InRange(seconds, 0, 2);
#endif
    }

    [Fact]
    public void A_text_does_not_grow_for_ever()
    {
        var text = "DEF STRING[200] S=\"abcdefgh\"\n" + string.Concat(Enumerable.Repeat("S=S<<S\n", 60)) + "M30\n";
        var path = NcInterpreter.Run(NcProgram.Read(Encoding.ASCII.GetBytes(text)), NcDialects.Siemens840D);
        Assert.Equal(NcRefusalCodes.BadExpression, path.Refusal?.Code);
        Assert.Contains("400 characters", path.Refusal!.Message, StringComparison.Ordinal);
    }
}
