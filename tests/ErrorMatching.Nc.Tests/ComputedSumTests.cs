using System.Text;

namespace ErrorMatching.Nc.Tests;

/// <summary>Computed coordinates that are displaced: a constant is added, and nothing else of the expression changes.</summary>
public sealed class ComputedSumTests
{
    [Theory]
    [InlineData("linuxcnc", "X[#1+5.]", "X[#1+5.+0.1]")]
    [InlineData("linuxcnc", "X[5+#1]", "X[5+#1+0.1]")]
    [InlineData("linuxcnc", "X#1", "X[#1+0.1]")]
    [InlineData("linuxcnc", "X-#1", "X[-#1+0.1]")]
    [InlineData("linuxcnc", "X#<w>", "X[#<w>+0.1]")]
    [InlineData("linuxcnc", "X[#1]", "X[#1+0.1]")]
    [InlineData("linuxcnc", "X[[#1+2]*[3]]", "X[[#1+2]*[3]+0.1]")]
    [InlineData("linuxcnc", "X[#1 GT 2]", "X[[#1 GT 2]+0.1]")]
    [InlineData("linuxcnc", "X[ABS[#1]]", "X[[ABS[#1]]+0.1]")]
    [InlineData("linuxcnc", "X abs[#1]", "X [abs[#1]+0.1]")]
    [InlineData("fanuc", "X[#1+5.]", "X[#1+5.+0.1]")]
    [InlineData("siemens-840d", "X=R1+5", "X=R1+5+0.1")]
    [InlineData("siemens-840d", "X=AC(R1)", "X=AC(R1+0.1)")]
    [InlineData("siemens-840d", "X=ABS(R1)", "X=(ABS(R1))+0.1")]
    [InlineData("siemens-840d", "X=(R1+2)*3", "X=(R1+2)*3+0.1")]
    public void A_constant_is_added(string dialect, string word, string changed)
    {
        var path = Read(dialect, word);
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N4"), new(0.1, 0, 0)));
        var rewrite = Bench.Usable(Rewriter.Apply(path, wish));
        Assert.Empty(Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm).Failures);
        Assert.Equal($"N4 G1 {changed} Y3 F100", Line(rewrite.Program, 4));
    }

    [Theory]
    [InlineData("linuxcnc", "X[#1+5.]", "X[#1+5.+0.1]", true)]
    [InlineData("linuxcnc", "X[#1+5.]", "X[#1+5.1]", false)]
    [InlineData("linuxcnc", "X[#1+5.]", "X[5.+#1+0.1]", false)]
    [InlineData("linuxcnc", "X[#1+5.]", "X10.1", false)]
    [InlineData("linuxcnc", "X[#1+5.]", "X[#1+5.+0.1+0]", false)]
    [InlineData("linuxcnc", "X[#1+5.]", "X[#1+5.+[0.1]]", false)]
    [InlineData("linuxcnc", "X[#1+5.]", "X[#1+5.+#2]", false)]
    [InlineData("siemens-840d", "X=R1+5", "X=R1+5+0.1", true)]
    [InlineData("siemens-840d", "X=R1+5", "X=(R1+5)+0.1", true)]
    [InlineData("siemens-840d", "X=R1+5", "X=R1+5.1", false)]
    [InlineData("siemens-840d", "X=R1+5", "X=5+R1+0.1", false)]
    public void The_proof_accepts_nothing_else(string dialect, string word, string changed, bool holds)
    {
        var path = Read(dialect, word);
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N4"), new(0.1, 0, 0)));
        var result = Bench.Text(path.Program).Replace(word + " Y3", changed + " Y3", StringComparison.Ordinal);
        var proof = Prover.Check(path, NcProgram.Read(Encoding.Latin1.GetBytes(result), path.Dialect.Syntax), wish, 1e-3);
        Assert.Equal(holds, proof.Holds);
    }

    // A sum binds less strongly than what is multiplied, and more strongly than what is compared.
    [Theory]
    [InlineData("X[#1*2]", 10.1)]
    [InlineData("X[#1 LT 9]", 1.1)]
    [InlineData("X[2 OR 0]", 1.1)]
    [InlineData("X[#1 MOD 3]", 2.1)]
    public void The_value_changes_by_the_constant(string word, double value)
    {
        var path = Read("linuxcnc", word);
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N4"), new(0.1, 0, 0)));
        var after = NcInterpreter.Run(Bench.Usable(Rewriter.Apply(path, wish)).Program, path.Dialect);
        Assert.Equal(value, Bench.MotionOf(after, "N4").End.X, 9);
    }

    [Fact]
    public void A_value_that_only_the_machine_knows_is_refused()
    {
        var path = Bench.Read("G21 G90 G17\nN2 G0 X0 Y0\nN3 G1 X5 F100\nN4 X#500 Y3\nN5 Y9\n", NcDialects.Named("fanuc"));
        var refusal = Bench.Refused(DisplacementWish.Normal(path, Bench.Blocks(path, "N4"), 0.1));
        Assert.Equal((NcRefusalCodes.Expression, "N4"), (refusal.Code, refusal.Place.Block));
    }

    [Fact]
    public void A_block_that_runs_several_times_gets_one_sum()
    {
        const string Program = "#1=0\no100 repeat [3]\n#1=[#1+10]\nN4 G1 X[#1] Y3 F100\no100 endrepeat\nM2\n";
        var path = Bench.Read("G21 G90 G17\nG0 X0 Y0\n" + Program, NcDialects.LinuxCnc);
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N4"), new(0.1, 0, 0)));
        var rewrite = Bench.Usable(Rewriter.Apply(path, wish));
        Assert.Empty(Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm).Failures);
        Assert.Contains("N4 G1 X[#1+0.1] Y3 F100", Bench.Text(rewrite.Program), StringComparison.Ordinal);
    }

    private static NcPath Read(string dialect, string word)
    {
        var assign = dialect switch { "siemens-840d" => "R1=5", "linuxcnc" => "#1=5 #<w>=5", _ => "#1=5" };
        return Bench.Read($"G90 G17\n{assign}\nN3 G1 X1 Y1 F100\nN4 G1 {word} Y3 F100\nN5 X20\n", NcDialects.Named(dialect));
    }

    private static string Line(NcProgram program, int line) => Bench.Text(program).Split('\n')[line - 1];
}
