using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>End points that move each by a vector of its own, as a path over a surface does.</summary>
public sealed class PointByPointTests
{
    private const string Program = """
        N10 G21 G90 G17 G0 X0. Y0. Z10.
        N20 G1 Z1. F300
        N30 X10.
        N40 X20. Z1.5
        N50 G0 Z10.
        N60 X50.
        """;

    private static NcPath Path(string text = Program) => NcInterpreter.Run(NcProgram.FromText(text), NcDialects.FanucMill);

    [Fact]
    public void Each_end_moves_by_its_own_vector_and_no_other_does()
    {
        var path = Path();
        var wish = DisplacementWish.OfPoints([new(2, new(0.001, 0, -0.02)), new(1, new(0, 0.003, 0.01))]);
        var rewrite = Rewriter.Apply(path, wish);

        Assert.True(rewrite.IsUsable, rewrite.Refusal?.Message);
        var after = NcInterpreter.Run(rewrite.Result.Program, NcDialects.FanucMill);
        Assert.Equal(new Point3(0, 0.003, 1.01), after.Motions[1].End);
        Assert.Equal(new Point3(10.001, 0, 0.98), after.Motions[2].End);
        Assert.Equal(path.Motions[3].End, after.Motions[3].End);
        Assert.True(Prover.Check(path, rewrite.Result.Program, wish, rewrite.Result.LeastIncrementMm).Holds);
    }

    [Fact]
    public void A_point_that_was_not_named_and_moved_fails_the_proof()
    {
        var path = Path();
        var wish = DisplacementWish.OfPoints([new(2, new(0, 0, -0.02))]);
        var good = Encoding.UTF8.GetString(Rewriter.Apply(path, wish).Result!.Program.Bytes.Span);

        foreach (var (from, to) in (ReadOnlySpan<(string, string)>)[
            ("N40 X20.", "N40 X20.01"), ("Z10.\nN60", "Z10.01\nN60"), ("X50.", "X50.001"), ("Z0.98", "Z0.979")])
        {
            Assert.Contains(from, good, StringComparison.Ordinal);
            Assert.False(Prover.Check(path, NcProgram.FromText(good.Replace(from, to, StringComparison.Ordinal)), wish, 0.001).Holds);
        }
    }

    [Fact]
    public void An_arc_beside_a_moved_point_is_refused()
    {
        var path = Path("N10 G21 G90 G17 G0 X0. Y0. Z0.\nN20 G1 X10. F300\nN30 G2 X20. I5. J0.\n");

        Assert.Equal(NcRefusalCodes.ArcForm, Rewriter.Apply(path, DisplacementWish.OfPoints([new(1, new(0, 0, 0.01))])).Refusal?.Code);
    }

    [Fact]
    public void Increments_keep_their_sum()
    {
        var path = Path("N10 G21 G90 G17 G0 X0. Y0. Z0.\nN20 G91 G1 X10. F300\nN30 X10.\nN40 X10.\n");
        var wish = DisplacementWish.OfPoints([new(1, new(0.01, 0, 0)), new(2, new(-0.01, 0, 0))]);
        var rewrite = Rewriter.Apply(path, wish).Result!;

        Assert.EndsWith(
            "X10.01 F300\nN30 X9.98\nN40 X10.01\n", Encoding.UTF8.GetString(rewrite.Program.Bytes.Span), StringComparison.Ordinal);
        Assert.True(Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm).Holds);
    }

    [Fact]
    public void A_wish_for_points_comes_back_from_its_file()
    {
        var path = Path();
        var wish = DisplacementWish.OfPoints([new(1, new(0, 0.003, 0.01)), new(2, new(0.001, 0, -0.02))]);
        using var stream = new MemoryStream();
        WishFile.Of(path, wish, 0.001).WriteTo(stream);

        var read = WishFile.Read(stream.ToArray(), "wish.json").Wish;
        Assert.True(read.IsPointByPoint);
        Assert.Equal(wish.EndPoints, read.EndPoints);
        Assert.Equal([wish.ByOf(0), wish.ByOf(1)], [read.ByOf(0), read.ByOf(1)]);
    }

    [Fact]
    public void A_point_has_one_wish() =>
        Assert.Throws<ArgumentException>(() => DisplacementWish.OfPoints([new(1, new(0, 0, 1)), new(1, new(0, 0, 2))]));
}
