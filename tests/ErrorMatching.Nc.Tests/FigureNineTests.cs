using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// The one program whose modification the paper prints: figure 9 of Wang 2021, with block N8970, which the screenshot hides,
/// as the straight move that the center of N8980 implies.
/// </summary>
public sealed class FigureNineTests
{
    private const double Printed = 0.001;

    [Fact]
    public void Offset_by_two_hundredths_to_the_left_reproduces_the_printed_path_from_N9010_to_N9080()
    {
        var result = Displaced();

        // The paper inserted one point at the corner (its N9010), so our block is its next one.
        (string Ours, double X, double Y)[] printed =
        [
            ("N9000", -34.897, 36.376), ("N9010", -34.902, 36.186), ("N9020", -34.91, 36.004), ("N9030", -34.922, 35.82),
            ("N9040", -34.936, 35.632), ("N9050", -34.954, 35.44), ("N9060", -34.976, 35.245), ("N9070", -35.001, 35.046),
        ];
        foreach (var (block, x, y) in printed)
        {
            var end = MotionOf(result, block).End;
            Assert.InRange(end.X, x - Printed - 1e-9, x + Printed + 1e-9);
            Assert.InRange(end.Y, y - Printed - 1e-9, y + Printed + 1e-9);
        }
    }

    [Fact]
    public void Both_tip_arcs_keep_their_center_and_shrink_from_6_to_5_98()
    {
        var result = Displaced();
        foreach (var block in new[] { "N8980", "N8990" })
        {
            var arc = MotionOf(result, block).Arc;
            Assert.InRange(arc.Center.X, -42.334 - 0.0011, -42.334 + 0.0011);
            Assert.InRange(arc.Center.Y, 48.745 - 0.0011, 48.745 + 0.0011);
            Assert.InRange(arc.Radius, 5.98 - 0.001, 5.98 + 0.001);
        }

        var text = System.Text.Encoding.ASCII.GetString(result.Program.Bytes.Span);
        Assert.Contains("N8990 X-45.722 Y43.817 I5.98 J0.\n", text, StringComparison.Ordinal);
    }

    [Fact]
    public void The_proof_holds_and_finds_nothing_but_rounding()
    {
        var path = Original();
        var wish = Wish(path);
        var rewrite = Rewriter.Apply(path, wish).Result!;
        var proof = Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm);
        Assert.Empty(proof.Failures);
        Assert.True(proof.Holds);
        Assert.True(proof.UntouchedBytesIdentical);
        Assert.InRange(proof.MaxDeviationFromWantedMm, 1e-6, 0.0016);
        var neighbor = Assert.Single(proof.Neighbors);
        Assert.Equal("N8960", neighbor.Block);
    }

    private static NcPath Original() =>
        NcInterpreter.Run(
            NcProgram.Read(File.ReadAllBytes(Repository.PathTo("samples", "figure-nine", "original.nc"))), NcDialects.DeltaNc300);

    private static DisplacementWish Wish(NcPath path)
    {
        var blocks = BlockSelector.Select(path.Program, [BlockSelector.Parse("N8970..N9080")]);
        return DisplacementWish.Normal(path, blocks.Result!, 0.02).Result!;
    }

    private static NcPath Displaced()
    {
        var path = Original();
        return NcInterpreter.Run(Rewriter.Apply(path, Wish(path)).Result!.Program, NcDialects.DeltaNc300);
    }

    private static NcMotion MotionOf(NcPath path, string block)
    {
        var blocks = BlockSelector.Select(path.Program, [BlockSelector.Parse(block)]);
        return path.Motions[path.MotionOf(blocks.Result![0])];
    }
}
