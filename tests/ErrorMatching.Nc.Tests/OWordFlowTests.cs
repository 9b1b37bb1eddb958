namespace ErrorMatching.Nc.Tests;

/// <summary>O words of LinuxCNC. The expected values agree with what rs274 of LinuxCNC 2.9 prints for the same programs.</summary>
public sealed class OWordFlowTests
{
    [Fact]
    public void Assignments_take_effect_behind_the_block() =>
        Runs("x#31 #31=1 #31=2\nx#31\n#1=2\nx##1\nm2", "1=0 2=2 3 4=0 5");

    [Fact]
    public void A_call_has_its_own_first_thirty_parameters_and_gives_a_value_back() =>
        Runs(
            "o100 sub\nx[#1+#30]\n#1=77\n#31=[#31+1]\no100 endsub [5]\n#1=3 #30=9\no100 call [1] "
                + "[2]\nx#1\nx#<_value>\nx#<_value_returned>\nx#31\nm2",
            "6 2=1 3 4 8=3 9=5 10=1 11=1 12");

    [Fact]
    public void A_call_without_a_value_gives_zero_back() =>
        Runs("o1 sub\no1 endsub [7]\no2 sub\no2 endsub\no1 call\no2 call\nx#<_value>\nx#<_value_returned>\nm2", "7=0 8=0 9");

    [Fact]
    public void A_subroutine_may_stand_behind_its_call_and_return_early() =>
        Runs(
            "o<bore> call [4]\nx#<_value>\nm2\no<Bore> sub\no1 if [#1 gt 3]\no<bore> return [#1*2]\no1 endif\nx1\no<bore> endsub", "2=8 3");

    [Fact]
    public void A_computed_label_calls() =>
        Runs("o101 sub\nx5\no101 endsub\n#1=100\no[#1+1] call\nm2", "4 2 6");

    [Theory]
    [InlineData(1, "1 3=10 9")]
    [InlineData(2, "1 5=20 9")]
    [InlineData(3, "1 7=30 9")]
    public void One_branch_runs(int choice, string trace) =>
        Runs(
            FormattableString.Invariant($"#1={choice}\no1 if [#1 eq 1]\nx[10]\no1 elseif [#1 eq 2]\nx[20]\no1 else\nx[30]\no1 endif\nm2"),
            trace);

    [Fact]
    public void While_and_repeat_count() =>
        Runs(
            "o1 while [#1 lt 2]\nx#1\n#1=[#1+1]\no1 endwhile\no2 repeat [2.6]\nx[#5]\n#5=[#5+1]\no2 endrepeat\no3 repeat [0]\nx9\no3 "
                + "endrepeat\nm2",
            "2=0 3 2=1 3 6=0 7 6=1 7 6=2 7 12");

    [Fact]
    public void Continue_goes_to_the_condition_of_do() =>
        Runs(
            "#<x>=3\no3 do\n#<x>=[#<x>-1]\no4 if [#<x> eq 1]\no3 continue\no4 endif\nx#<x>\no3 while [#<x> gt 0]\nm2", "1 3 7=2 3 3 7=0 9");

    [Fact]
    public void Break_leaves_the_loop() =>
        Runs("o1 while [1]\n#1=[#1+1]\no2 if [#1 ge 2]\no1 break\no2 endif\nx#1\no1 endwhile\nx9\nm2", "2 6=1 2 8 9");

    [Fact]
    public void M98_shares_parameters_and_repeats() =>
        Runs("#2=10\nm98 p1 l2\nx[#2*10]\nm2\no1\n#2=[#2+1]\nx#2\nm99", "1 2 5 6 7=11 8 5 6 7=12 8 3=120 4");

    [Theory]
    [InlineData("m98 p1 l0\nx1\nm2\no1\nx5\nm99", "1 2 3")]
    [InlineData("x1\no1\nx2\nm2", "1 2 3 4")]
    [InlineData("%\nx1\n%\nx2", "2")]
    [InlineData("#1=5\no1 sub\nm98 p7\no1 endsub\no1 call [9]\nm2\no7\nx#1\nm99", "1 3 7 8=9 9 6")]
    public void Numbered_subprograms_run_as_rs274_runs_them(string text, string trace) => Runs(text, trace);

    [Fact]
    public void A_subroutine_may_stand_in_a_file_of_its_name() =>
        Runs("o<face> call [2]\nm2", "3=2 2", FlowRun.Library(("face", "(own file)\no<face> sub\nx#1\no<face> endsub\nm2")));

    [Fact]
    public void Names_are_local_unless_they_begin_with_an_underscore()
    {
        Runs("#<a>=1\n#<_big>=2\no1 call\nx#<a>\nx#<_big>\nm2\no1 sub\n#<a>=5\n#<_big>=6\no1 endsub", "1 2 8 9 4=1 5=6 6");
        Assert.Equal("bad-expression", FlowRun.Of(NcSyntax.LinuxCnc, "#<a>=1\no1 call\nm2\no1 sub\nx#<a>\no1 endsub").Refusal?.Code);
    }

    [Theory]
    [InlineData("N5 #<_x>=1", "bad-expression", "N5")]
    [InlineData("N5 o1 call", "missing-program", "N5")]
    [InlineData("o1 call\no1 sub\nx1", "missing-label", "line 1")]
    [InlineData("N5 o1 if [#5220 eq 1]\no1 endif", "unknown-condition", "N5")]
    [InlineData("N5 o1 while [1]\nN6 o1 endwhile", "endless-loop", "N6")]
    [InlineData("N5 o1 repeat [#<_x>]\no1 endrepeat", "unknown-condition", "N5")]
    [InlineData("o1 sub\nN5 o1 call\no1 endsub\no1 call", "call-too-deep", "N5")]
    [InlineData("N5 o1 endwhile", "missing-label", "N5")]
    [InlineData("N5 o1 if [1/0]\no1 endif", "bad-expression", "N5")]
    public void What_cannot_go_on_is_refused_with_its_block(string text, string code, string block)
    {
        var refusal = FlowRun.Of(NcSyntax.LinuxCnc, text).Refusal;
        Assert.Equal((code, block), (refusal?.Code, refusal?.Place.Block));
    }

    private static void Runs(string text, string trace, FlowSettings? settings = null)
    {
        var run = FlowRun.Of(NcSyntax.LinuxCnc, text, settings);
        Assert.Null(run.Refusal);
        Assert.Equal(trace, run.Trace);
    }
}
