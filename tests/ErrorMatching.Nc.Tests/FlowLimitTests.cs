using System.Diagnostics;
using System.Text;
using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>Every program comes to an end: by itself, by a limit, or by a refusal; whatever bytes it has.</summary>
public sealed class FlowLimitTests
{
    private static readonly string[] Iso = [
        "#1=#1+1", "#2=#1*2 ", "IF[#1LT5]GOTO1", "IF[#1EQ3]THEN #2=1", "GOTO2", "GOTO#1", "WHILE[#1LT4]DO1", "END1", "DO2", "END2",
        "N1 X#1", "N2 X1", "M98P2L2", "M98P20002", "M99", "M99P1", "G65P2A1B#1", "G66P2", "G67", "O2", "O1", "%", "M30", "[", "#", "IF[",
        "#1=0"];

    private static readonly string[] OWords = [
        "#1=[#1+1]", "o1 if [#1 lt 3]", "o1 else", "o1 elseif [1]", "o1 endif", "o2 while [#1 lt 4]", "o2 endwhile", "o3 do",
        "o3 while [#1 lt 2]", "o4 repeat [2]", "o4 endrepeat", "o2 break", "o2 continue", "o5 sub", "o5 endsub [1]", "o5 call [#1]",
        "o5 return [2]", "o[#1] call", "x#1", "m98 p6", "o6", "m99", "m2", "o", "o<a", "#<a>=1"];

    private static readonly string[] Siemens = [
        "R1=R1+1", "R1=0", "DEF INT I", "IF R1<3", "ELSE", "ENDIF", "IF R1<3 GOTOB A1", "A1: X=R1", "A2:", "GOTOF A2", "GOTOB A1",
        "FOR I=1 TO 3", "ENDFOR", "WHILE R1<4", "ENDWHILE", "LOOP", "ENDLOOP", "REPEAT", "UNTIL R1>2", "REPEAT A1 P=2", "REPEATB A1",
        "REPEAT A1 A2", "CASE (R1) OF 1 GOTOF A2 DEFAULT GOTOB A1", "UP(R1) P2", "%_N_UP_SPF", "PROC UP(INT A)", "M17", "RET", "M30",
        "CALL \"UP\"", "DEF REAL F[3]=SET(1,2,3)", "F[1]=REP(2)", "ENDLABEL:", "GOTOC", "DEF", "\""];

    [Theory]
    [InlineData(NcSyntax.Iso, "N10 G1 X5. Y-3 F100 M3 (IF #1)", false)]
    [InlineData(NcSyntax.Iso, "G2X1Y1I5.J0", false)]
    [InlineData(NcSyntax.Iso, "X1 ; GOTO", false)]
    [InlineData(NcSyntax.Iso, "G1 X#1", true)]
    [InlineData(NcSyntax.Iso, "N5 m99", true)]
    [InlineData(NcSyntax.Iso, "G65P1", true)]
    [InlineData(NcSyntax.LinuxCnc, "G1 X5 (o1 call)", false)]
    [InlineData(NcSyntax.LinuxCnc, "o1 call", true)]
    [InlineData(NcSyntax.Siemens, "N10 G1 X5 Y-3 F100 ;R1=5", false)]
    [InlineData(NcSyntax.Siemens, "R1=5", true)]
    [InlineData(NcSyntax.Siemens, "A1:", true)]
    [InlineData(NcSyntax.Siemens, "L10", true)]
    [InlineData(NcSyntax.Siemens, "N5 M17", true)]
    public void Straight_blocks_need_not_be_given_to_the_machine(NcSyntax syntax, string text, bool concerns) =>
        Assert.Equal(concerns, FlowTrigger.Concerns(Encoding.UTF8.GetBytes(text), FlowRun.DialectOf(syntax)));

    [Theory]
    [InlineData(NcSyntax.Iso, "#1=0\nN1 #1=#1+1\nIF[#1GT0]GOTO1")]
    [InlineData(NcSyntax.LinuxCnc, "o1 while [1]\n#1=[#1+1]\no1 endwhile")]
    [InlineData(NcSyntax.Siemens, "R1=0\nLOOP\nR1=R1+1\nENDLOOP")]
    public void A_loop_that_always_changes_something_ends_at_the_limit(NcSyntax syntax, string text)
    {
        var run = FlowRun.Of(syntax, text, new() { Steps = 10_000 });
        Assert.Equal(NcRefusalCodes.EndlessLoop, run.Refusal?.Code);
        Assert.Contains("10000 blocks", run.Refusal!.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_loop_can_be_stopped_from_outside()
    {
        using var source = new CancellationTokenSource();
        source.Cancel();
        Assert.Equal(
            NcRefusalCodes.EndlessLoop,
            FlowRun.Of(NcSyntax.Iso, "#1=0\nN1 #1=#1+1\nGOTO1", new() { Cancellation = source.Token }).Refusal?.Code);
    }

    [Fact]
    public void Calls_have_the_depth_that_is_set()
    {
        const string Text = "#1=0\nM98P2\nM30\nO2\n#1=#1+1\nIF[#1EQ5]GOTO9\nM98P2\nN9 M99";
        Assert.Null(FlowRun.Of(NcSyntax.Iso, Text, new() { Depth = 5 }).Refusal);
        Assert.Equal(NcRefusalCodes.CallTooDeep, FlowRun.Of(NcSyntax.Iso, Text, new() { Depth = 4 }).Refusal?.Code);
    }

    [Fact]
    public void A_million_blocks_of_a_loop_are_executed_in_seconds()
    {
        var watch = Stopwatch.StartNew();
        var run = new NcFlow(NcProgram.FromText("#1=0\nWHILE[#1LT330000]DO1\n#1=#1+1\nEND1\nM30"), NcDialects.FanucMill);
        for (var i = 0; run.ExecuteStatements(i) == FlowAction.Continue; i = run.Next)
        {
        }

        Assert.Null(run.Refusal);
        Assert.Equal(330_000, run.Variables.Read(VariablePlace.Numbered(1), out _).Number);
        Assert.True(watch.Elapsed < TimeSpan.FromMinutes(2), $"{watch.Elapsed}");
    }

    [Theory]
    [InlineData(NcSyntax.Iso, "DO1\n")]
    [InlineData(NcSyntax.LinuxCnc, "o1 if [1]\n")]
    [InlineData(NcSyntax.LinuxCnc, "o1 endif\n")]
    [InlineData(NcSyntax.Siemens, "LOOP\n")]
    [InlineData(NcSyntax.Siemens, "((((((((((\n")]
    [InlineData(NcSyntax.Siemens, "A[A[A[A[A[A[\n")]
    public void A_large_file_of_one_statement_is_no_burden(NcSyntax syntax, string line)
    {
        var watch = Stopwatch.StartNew();
        FlowRun.Of(syntax, string.Concat(Enumerable.Repeat(line, 1_000_000 / line.Length)));
        Assert.True(watch.Elapsed < TimeSpan.FromMinutes(2), $"{watch.Elapsed}");
    }

    [Fact]
    public void Any_program_ends_and_none_throws()
    {
        string[][] families = [Iso, OWords, Siemens];
        var statements = Gen.Choose(0, 2).SelectMany(
            f => Gen.Frequency(
                (8, Gen.Elements(families[f])),
                (1, Gen.Choose(0, 255).Select(n => (byte)n).ArrayOf().Select(Encoding.Latin1.GetString))).ArrayOf()
            .Select(lines => (Syntax: (NcSyntax)f, Text: string.Join('\n', lines))));
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(Depth.Of(4000, 20_000)).WithEndSize(30), Prop.ForAll(statements.ToArbitrary(), p =>
        {
            FlowRun.Of(
                p.Syntax,
                (p.Syntax == NcSyntax.Siemens ? "R1=0\n" : p.Syntax == NcSyntax.Iso ? "#1=0\n" : "") + p.Text,
                new() { Steps = 2_000, Depth = 10 });
            return true;
        }));
    }
}
