using ErrorMatching.Refusals;

namespace ErrorMatching.Nc.Tests;

/// <summary>What controls refuse in a block. The answers are those of rs274 (LinuxCNC 2.9) and of grbl 1.1's source; the peer tests
/// compare thousands of random blocks with rs274 itself.</summary>
public sealed class ControlRefusalTests
{
    [Theory]
    [InlineData("G0 X1 I5")]
    [InlineData("G1 X1 F100 J5")]
    [InlineData("G0 G1 X5 F100")]
    [InlineData("G90 G91")]
    [InlineData("G17 G18")]
    [InlineData("M3 M5")]
    [InlineData("G1 X5")]
    [InlineData("G1 X5 F0")]
    [InlineData("F100 G94\nG94\nG1 X5")]
    [InlineData("G0 X5 (a (b) c)")]
    [InlineData("G91 G53 G0 X5")]
    [InlineData("F100\nG53 G2 X5 Y5 I2")]
    [InlineData("G0 X1.5E-3")]
    [InlineData("X5")]
    [InlineData("G80 X5")]
    [InlineData("G0 X5 X6")]
    [InlineData("G0 X5 N10")]
    [InlineData("G4")]
    [InlineData("G92")]
    [InlineData("G28 G0 X5")]
    [InlineData("F100\nG2 X5 Y5 I1 R3")]
    [InlineData("F100\nG2 X5 Y5 K2")]
    [InlineData("F100\nG81 X5 Z-3")]
    [InlineData("F100\nG81 X5 Z8 R5")]
    [InlineData("F100\nG81 X5 Z-3 R5 L0")]
    [InlineData("F100\nG83 X5 Z-3 R5")]
    [InlineData("F100\nG84 X5 Z-3 R5")]
    [InlineData("G93\nG1 X5")]
    [InlineData("G0 F-5")]
    [InlineData("T1.5")]
    [InlineData("M3 M8 M48 M0 M62 P1")]
    [InlineData("M61")]
    [InlineData("M12")]
    [InlineData("G10 L3 P1 X1")]
    [InlineData("G41.1 D1\nG1 X5 F100\nG18")]
    [InlineData("G19\nG41.1 D1")]
    [InlineData("G18\nG0 @5 ^30")]
    [InlineData("G0 Y=5")]
    [InlineData("#5420=1")]
    [InlineData("#1=#99999")]
    public void LinuxCnc_refuses_it(string program) => Assert.True(IsNamed(program, "linuxcnc"));

    [Theory]
    [InlineData("G0 X1 Y2")]
    [InlineData("G1 X1 F100\nG2 X5 Y5 I2 J2")]
    [InlineData("G0 X0 Y0 Z10 F100\nG81 X5 Z-3 R5\nX6\nX7 R6")]
    [InlineData("G80 G0 X5")]
    [InlineData("G0 X5 (a: b) ; c (d (e")]
    [InlineData("G10 L2 P1 X0 Y0\nG92 X0\nG4 P1.5")]
    [InlineData("M3 S500\nM8 M48")]
    [InlineData("G93\nG1 X5 F2")]
    [InlineData("G90 G53 G0 Z0")]
    [InlineData("M100 P1 Q2")]
    [InlineData("o100 sub\nG1 X5 F100\no100 endsub\no101 sub\no101 endsub\no100 call")]
    public void LinuxCnc_accepts_it(string program)
    {
        var path = Run(program, "linuxcnc");

        Assert.Null(path.Refusal);
        Assert.DoesNotContain(path.Problems, p => p.Code == NcRefusalCodes.RefusedByControl);
    }

    [Theory]
    [InlineData("G0 X5 I3", "error 36")]
    [InlineData("G0 X5 P3", "error 36")]
    [InlineData("G0 G1 X5 F10", "error 21")]
    [InlineData("G1 X5", "error 22")]
    [InlineData("G0 X5 X6", "error 25")]
    [InlineData("G0 A5", "error 20")]
    [InlineData("G92 G0 X1", "error 24")]
    [InlineData("G80\nX5", "error 31")]
    [InlineData("G4", "error 28")]
    [InlineData("F10\nG2 I5", "error 26")]
    [InlineData("F10\nG2 Z5 I5", "error 32")]
    [InlineData("F10\nG2 X5 Y5", "error 35")]
    [InlineData("G10 L1 P1 X0", "error 20")]
    [InlineData("G10 L2 P7 X0", "error 29")]
    [InlineData("G43.1 X5", "error 37")]
    [InlineData("G1 X5 F10\nG2 X6 Y6 I1 J0\nG53 X7 Y7 I1", "error 30")]
    [InlineData("G0 F-5", "error 4")]
    [InlineData("T300", "error 38")]
    [InlineData("G0 X5 (a (b) c)", "parenthesis")]
    public void Grbl_refuses_it(string program, string reason)
    {
        var path = Run(program, "grbl");

        Assert.Contains(path.Problems, p => p.Code == NcRefusalCodes.RefusedByControl);
        var texts = path.Problems.Select(p => p.Message).Concat(path.Dialect.Facts.Where(f => f.Topic == DialectTopic.Refusal
            && path.Problems.Any(p => p.Message.EndsWith(f.Statement, StringComparison.Ordinal))).Select(f => f.Source));
        Assert.Contains(texts, t => t.Contains(reason, StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("G21 G90 G17 G94 G54\nG0 X0 Y0\nG1 X5 F100\nG2 X6 Y6 I1 J0\nX7 Y7 I1 J0\nG1 X8\nM3 S100\nG4 P1\nM5\nM30")]
    [InlineData("G10 L20 P1 X0 Y0\nG92 X0\nG92.1\nG28 Z0\nG53 G0 X0\nG43.1 Z1\nG49\nG38.2 Z-5 F10\nG80\nG0 X1 (a (b)\nN5 X2")]
    public void Grbl_accepts_it(string program) =>
        Assert.DoesNotContain(Run(program, "grbl").Problems, p => p.Code == NcRefusalCodes.RefusedByControl);

    [Fact]
    public void The_block_and_the_reason_are_named()
    {
        var path = Run("N1 G0 X1\nN2 G0 X2 I5\nN3 G0 X3", "linuxcnc");

        var problem = Assert.Single(path.Problems);
        Assert.Equal((NcRefusalCodes.RefusedByControl, 1), (problem.Code, problem.Block));
        Assert.Equal("The control refuses this block (I): I belongs to an arc, a spline, G10, G33.1, G71, G72, G76 or G87.",
            problem.Message);
    }

    [Fact]
    public void A_subroutine_inside_another_is_refused()
    {
        var path = Run("o100 sub\no101 sub\no101 endsub\no100 endsub\no100 call", "linuxcnc");

        Assert.Equal((NcRefusalCodes.RefusedByControl, 1), (path.Refusal!.Code, path.Refusal.Place.Line));
    }

    [Theory]
    [InlineData("N1 G0 X0 Y0\nN2 G1 X10 F100\nN3 Y10 I5\nN4 X0\nN5 Y0", "N3")]
    [InlineData("N1 G0 X0 Y0\nN2 G1 X1.5E-3 F100\nN3 Y10\nN4 X0", "N2")]
    public void A_block_that_the_control_refuses_is_not_changed(string program, string block)
    {
        var path = Run("G21 G17 G90 G40\n" + program, "linuxcnc");

        var outcome = Displace(path, block);

        Assert.Equal(NcRefusalCodes.RefusedByControl, outcome.Refusal?.Code);
    }

    [Fact]
    public void What_is_before_a_refused_block_can_be_changed()
    {
        var path = Run("G21 G17 G90 G40\nN1 G0 X0 Y0\nN2 G1 X10 F100\nN3 Y10\nN4 G0 Z5\nN5 G0 G1 X5", "linuxcnc");

        Assert.Null(Displace(path, "N2").Refusal);
    }

    [Fact]
    public void Behind_a_refused_block_nothing_is_known()
    {
        var path = Run("G21 G17 G90 G40\nN1 G0 X0 Y0\nN2 G0 G1 X5\nN3 G1 X10 F100\nN4 Y10", "linuxcnc");

        Assert.NotNull(Displace(path, "N4").Refusal);
    }

    [Fact]
    public void A_missing_feed_changes_no_place()
    {
        var path = Run("G21 G17 G90 G40\nN1 G0 X0 Y0\nN2 G1 X10\nN3 Y10\nN4 X0", "linuxcnc");

        Assert.Contains(path.Problems, p => p.Code == NcRefusalCodes.RefusedByControl);
        Assert.Null(Displace(path, "N3").Refusal);
    }

    [Fact]
    public void An_assumed_refusal_is_a_note()
    {
        var path = Run("G0 X0 Y0\nG1 X5 F-5", "fanuc");

        Assert.Empty(path.Problems);
        Assert.Contains(path.Notes, n => n.Code == "may-be-refused");
    }

    [Fact]
    public void A_shop_states_what_its_control_accepts_and_refuses()
    {
        var dialect = OwnDialect.Parse("""
            { "name": "ours", "like": "linuxcnc", "description": "Ours.",
              "refusals": [
                { "name": "I", "accepted": true, "statement": "Passed over.", "source": "tried" },
                { "name": "our own", "codes": "G1", "letters": "J", "values": { "least": 3 }, "statement": "J is 3 or more.", "source": "tried" } ] }
            """);

        Assert.Empty(NcInterpreter.Run(NcProgram.FromText("G0 X1 I5", dialect.Syntax), dialect).Problems);
        Assert.Contains(
            NcInterpreter.Run(NcProgram.FromText("G1 X1 F100 J2", dialect.Syntax), dialect).Problems,
            p => p.Message.EndsWith("J is 3 or more.", StringComparison.Ordinal));
    }

    private static bool IsNamed(string program, string dialect)
    {
        var path = Run(program, dialect);
        var last = program.Split('\n').Length - 1;
        return path.Refusal is { } refusal ? refusal.Place.Line == last + 1
            : path.Problems.Count > 0 && path.Problems.All(p => p.Block == last);
    }

    private static NcPath Run(string program, string dialect)
    {
        var control = NcDialects.Named(dialect);
        return NcInterpreter.Run(NcProgram.FromText(program, control.Syntax), control);
    }

    private static Outcome<Rewrite> Displace(NcPath path, string block)
    {
        var wish = DisplacementWish.EndsBy(path, Bench.Blocks(path, block), new(0.1, 0.1, 0));
        return wish.IsUsable ? Rewriter.Apply(path, wish.Result) : wish.Refusal;
    }
}
