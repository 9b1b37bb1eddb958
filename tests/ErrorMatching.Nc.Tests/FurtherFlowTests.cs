namespace ErrorMatching.Nc.Tests;

/// <summary>Less common spellings of branches, calls and variables. Those of LinuxCNC agree with what rs274 of LinuxCNC 2.9 does.</summary>
public sealed class FurtherFlowTests
{
    [Theory]
    [InlineData("#1=2\nIF [#1 EQ 2] G1 X5. F100\nIF [#1 EQ 3] X6.\nX7.", "L5,0,0 L7,0,0")]
    [InlineData("#1=2\nIF [#1 EQ 2] THEN X5.\nX7.", "R5,0,0 R7,0,0")]
    [InlineData("#1=2\nN5 IF [#1 EQ 2] M98 P10\nX7.\nM30\nO10\nX1.\nM99", "R1,0,0 R7,0,0")]
    [InlineData("M98 P10\nX7.\nM30\nO10\nX1.\nIF [1 EQ 1] M99\nX2.\nM99", "R1,0,0 R7,0,0")]
    public void Words_behind_a_condition_run_where_it_holds(string program, string moves) =>
        Assert.Equal(moves, Moves.Of("fanuc", program));

    [Theory]
    [InlineData("#2=3 X5.")]
    [InlineData("N5 #2=3 #3=4 X5.")]
    [InlineData("IF [1 EQ 1] THEN #2=3 X5.")]
    public void Words_behind_an_assignment_are_not_lost(string block)
    {
        var refusal = Bench.Read("G0 X1.\n" + block + "\n", NcDialects.FanucMill).Refusal;
        Assert.Equal(NcRefusalCodes.BadExpression, refusal?.Code);
        Assert.Contains("line 2", Bench.Read("G0 X1.\n#1=0 X5.\n", NcDialects.FanucMill).Refusal!.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_block_under_a_condition_is_not_changed()
    {
        const string program = "G90 G17 G40 G0 X0. Y0. Z0.\n#1=2\nN1 IF [#1 EQ 2] G1 X5. F100.\nN2 X5. Y5.\n";
        Assert.Equal(NcRefusalCodes.Expression, Bench.RefusedNormal(program, 0.1, "N1", NcDialects.FanucMill).Code);
    }

    [Theory]
    [InlineData("M98 <BORE>\nX7.\nM30\n<BORE>\nX1.\nM99", "R1,0,0 R7,0,0")]
    [InlineData("M98 <Bore-2> L2\nX7.\nM30\nO<BORE-2>\nG91 X1.\nG90 M99", "R1,0,0 R2,0,0 R7,0,0")]
    [InlineData("G65 <BORE> X3.\nX7.\nM30\n<BORE>\nX#24\nM99", "R3,0,0 R7,0,0")]
    public void A_program_is_called_by_its_name(string program, string moves) => Assert.Equal(moves, Moves.Of("fanuc", program));

    [Fact]
    public void A_named_program_that_is_not_there_is_missing()
    {
        var refusal = Bench.Read("G0 X1.\nM98 <BORE>\n", NcDialects.FanucMill).Refusal;
        Assert.Equal(NcRefusalCodes.MissingProgram, refusal?.Code);
        Assert.Contains("BORE", refusal!.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_named_program_of_the_library_is_followed()
    {
        var program = NcProgram.FromText("G90 G17 G40 G0 X0. Y0. Z0.\nM98 <BORE>\nX9.\n");
        var path = NcInterpreter.Run(
            program, NcDialects.FanucMill, n => n == "BORE" ? NcProgram.FromText("<BORE>\nX1.\nM99\n") : null, CancellationToken.None);
        Assert.Equal("R1,0,0 R9,0,0", Moves.Of(path, 1));
    }

    [Theory]
    [InlineData("G0 X1.\n<?xml version=1?>\nX2.")]
    [InlineData("G0 X1. <BORE>\nX2.")]
    public void A_name_that_nothing_calls_is_not_understood(string program) =>
        Assert.Equal("unknown-word", Bench.Read(program, NcDialects.FanucMill).Problems[0].Code);

    [Theory]
    [InlineData("o100 sub\nx#1\no100 end sub\no100 call [5]", "R5,0,0")]
    [InlineData("o<a b> s ub\nx#1\no<ab> endsub\no<ab> call [5]", "R5,0,0")]
    [InlineData("o100 if [0]\nx1\no100 else if [1]\nx2\no100 end if", "R2,0,0")]
    [InlineData("#<n>=100\no100 sub\nx#1\no100 endsub\no#<n> call [5]\no[#<n>+0] call [6]", "R5,0,0 R6,0,0")]
    [InlineData("#1=100\no100 sub\nx#1\no100 endsub\no#1 call [6]", "R6,0,0")]
    [InlineData("#atan[1]/[1]=5 x3\nx#45", "R3,0,0 R5,0,0")]
    [InlineData("#sqrt[16]=7\nx#4 y#atan[1]/[1]", "R7,0,0")]
    [InlineData("#<a>=1\nx[exists[#<a>]] y[exists[#<b>]] z[exists[#<_x>]]", "R1,0,1")]
    [InlineData("#1=3\nx[exists[#1]] y[exists[#0]] z[exists[#5601]]\nx[exists[#5602]]", "R1,0,1 R0,0,1")]
    [InlineData("#<_g>=1\no1 sub\nx[exists[#<_g>]] y[exists[#<l>]]\no1 endsub\n#<l>=1\no1 call", "R1,0,0")]
    public void LinuxCnc_spellings_are_followed(string program, string moves) =>
        Assert.Equal(moves, Moves.Of("linuxcnc", program + "\nm2"));

    [Theory]
    [InlineData("m3 $0 s100")]
    [InlineData("#1=1 m3 $-1 s100")]
    [InlineData("$[#1] m5")]
    [InlineData("m67 e0 q1")]
    public void Spindles_and_outputs_of_LinuxCnc_are_understood(string block)
    {
        var path = Bench.Read("g90 g17 g40 g0 x0 y0 z0\n" + block + "\nx1\n", NcDialects.LinuxCnc);
        Assert.Equal(("R0,0,0 R1,0,0", 0, null), (Moves.Of(path), path.Problems.Count, path.Refusal));
    }

    [Fact]
    public void Whether_the_configuration_has_a_value_only_the_machine_knows() =>
        Assert.Equal("R?,0,0", Moves.Of("linuxcnc", "x[exists[#<_ini[a]b>]]\nm2"));
}
