using System.Globalization;
using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// The second judge, tools/judge.py, which shares no code with the product: it accepts what the product proved and rejects every mutant.
/// ERRORMATCH_JUDGE=full runs the figures of docs/prove-a-program.md.
/// </summary>
public sealed class JudgeTests
{
    private static readonly bool IsFull = Environment.GetEnvironmentVariable("ERRORMATCH_JUDGE") == "full";

    [Fact]
    public void Proved_results_are_accepted_and_mutants_rejected()
    {
        Python.IsNeeded();
        using var folder = new TemporaryFolder();
        var (results, mutants) = IsFull ? (1000, 100_000) : (60, 150);
        var refused = TrueResults.Write(folder.Path, results);
        Assert.InRange(refused, 0, results / 8);
        var (_, said) = Python.Run(
            folder.Path,
            "tests/judge/attack.py",
            folder.Path,
            "--mutants",
            mutants.ToString(CultureInfo.InvariantCulture));
        TestContext.Current.TestOutputHelper?.WriteLine(said);
        Assert.StartsWith(
            string.Create(CultureInfo.InvariantCulture, $"true: {results}, accepted {results} "), said, StringComparison.Ordinal);
        Assert.EndsWith("\n0 wrong\n", said, StringComparison.Ordinal);
    }

    // Every spelling of a contour to which upright arcs lead, by a normal and by a vector.
    [Fact]
    public void Upright_arcs_are_judged()
    {
        Python.IsNeeded();
        using var folder = new TemporaryFolder();
        var count = TrueResults.WriteLed(folder.Path, 24);
        var (_, said) = Python.Run(folder.Path, "tests/judge/attack.py", folder.Path, "--mutants", "100");
        TestContext.Current.TestOutputHelper?.WriteLine(said);
        Assert.StartsWith(
            string.Create(CultureInfo.InvariantCulture, $"true: {count}, accepted {count} "), said, StringComparison.Ordinal);
        Assert.EndsWith("\n0 wrong\n", said, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("G41 D1")]
    [InlineData("G68 X0. Y0. R10.")]
    [InlineData("G52 X1. Y1.")]
    [InlineData("#100=5.")]
    [InlineData("/N5 G4 P1.")]
    [InlineData("G81 X1. Y1. Z-5. R2.")]
    [InlineData("G1 A5.")]
    public void Programs_outside_the_plain_subset_are_not_judged(string block)
    {
        Python.IsNeeded();
        using var folder = new TemporaryFolder();
        var text = $"G21 G17 G90\nG0 X0. Y0.\nN1 G1 X10. Y0. F100.\nN2 X10. Y10.\nG40 G0 X50. Y50.\n{block}\nM30\n";
        var path = Bench.Read(text, NcDialects.FanucMill.With(BlockSkip.Off));
        var wish = DisplacementWish.EndsBy(path, Bench.Blocks(path, "N1..N2"), new(0.1, 0.2, 0)).Result!;
        var rewrite = Bench.Usable(Rewriter.Apply(path, wish));
        var proof = Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm);
        Assert.Empty(proof.Failures);
        folder.File("base.nc", text);
        folder.File("result.nc", Bench.Text(rewrite.Program));
        var certificate = Certificate.Of(path, rewrite.Program, wish, rewrite.LeastIncrementMm, proof);
        File.WriteAllBytes(folder["certificate.json"], certificate.ToBytes());
        var (exit, said) = Python.Run(folder.Path, "tools/judge.py", "base.nc", "result.nc", "certificate.json");
        Assert.Equal((2, "cannot judge: line 6"), (exit, said[..Math.Min(said.Length, 20)]));
    }

    [Fact]
    public void Judge_has_at_most_620_lines_and_only_the_standard_library()
    {
        var lines = File.ReadAllLines(Repository.PathTo("tools", "judge.py"));
        Assert.InRange(lines.Length, 100, 620);
        Assert.All(lines, l => Assert.InRange(l.Length, 0, 140));
        Assert.All(
            lines.Where(l => l.StartsWith("import ", StringComparison.Ordinal) || l.StartsWith("from ", StringComparison.Ordinal)),
            l => Assert.Contains(l.Split(' ')[1], (string[])["hashlib", "json", "re", "sys", "collections", "decimal", "itertools"]));
    }
}
