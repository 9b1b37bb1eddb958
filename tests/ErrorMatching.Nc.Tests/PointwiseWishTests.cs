using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc.Tests;

public class PointwiseWishTests
{
    private const string Square = "G90 G17 G21\nG0 X0 Y0\nN10 G1 X10 F100\nN20 X20\nN30 Y10\nN40 G0 Z5\n";

    [Fact]
    public void Between_two_points_the_displacement_is_linear_over_the_length_and_beyond_them_it_stays()
    {
        // Points 5 and 25 mm along a path of 30 mm: at 0 and 5 mm 0.1, at 10 mm a quarter of the way, at 20 mm three quarters,
        // at 30 mm 0.5.
        var wish = Usable(Square, ["N10..N30"], new DisplacedPoint(new(5, 0), new(0.1, 0)), new DisplacedPoint(new(20, 5), new(0.5, 0)));
        Assert.Equal([0.1, 0.1, 0.2], Xs(wish.Wish.Elements[0]), Within);
        Assert.Equal([0.2, 0.3, 0.4], Xs(wish.Wish.Elements[1]), Within);
        Assert.Equal([0.4, 0.5, 0.5], Xs(wish.Wish.Elements[2]), Within);
    }

    [Fact]
    public void The_order_of_the_points_does_not_matter()
    {
        DisplacedPoint a = new(new(5, 0.2), new(0.1, -0.1)), b = new(new(20, 5), new(0.5, 0.2)), c = new(new(12, -0.3), new(0, 0.3));
        var blocks = new[] { "N10..N30" };
        Assert.Equal(Usable(Square, blocks, a, b, c).Wish.Elements, Usable(Square, blocks, c, a, b).Wish.Elements);
    }

    [Fact]
    public void One_point_displaces_the_whole_run_alike()
    {
        var wish = Usable(Square, ["N10..N30"], new DisplacedPoint(new(20, 5), new(0.03, -0.04)));
        Assert.All(wish.Wish.Elements, e => Assert.Equal((new Vector2(0.03, -0.04), e.Start, e.Start), (e.Start, e.Middle, e.End)));
        Assert.Equal(0, wish.LargestMisfitMm);
    }

    [Fact]
    public void On_an_arc_the_length_is_the_arc_s()
    {
        // A quarter of radius 10 about the origin from 0 to 90 degrees:
        // 30 degrees is a third of the length, so its middle has half of what 0 to 90 adds.
        var at30 = new Point2(10 * Math.Cos(Math.PI / 6), 5);
        var wish = Usable(
            "G90 G17 G21\nG0 X10 Y0\nN10 G3 X0 Y10 I-10 J0 F100\n",
            ["N10"],
            new DisplacedPoint(new(10, 0), default),
            new(at30, new(0.1, 0)),
            new DisplacedPoint(new(0, 10), new(0.3, 0)));
        Assert.Equal([0, 0.15, 0.3], Xs(wish.Wish.Elements[0]), Within);
        Assert.Equal(0, wish.LargestMisfitMm, 1e-12);
    }

    [Fact]
    public void What_a_straight_line_cannot_follow_is_told()
    {
        var bent = new DisplacedPoint(new(5, 0), new(0, 0.1));
        var wish = Usable(Square, ["N10"], new DisplacedPoint(new(0, 0), default), bent, new DisplacedPoint(new(10, 0), default));
        Assert.Equal((0.1, bent), (wish.LargestMisfitMm, wish.Worst));
    }

    [Fact]
    public void Runs_with_a_gap_between_them_know_nothing_of_each_other()
    {
        var wish = Usable(Square, ["N10", "N30"], new DisplacedPoint(new(5, 0), new(0.1, 0)), new DisplacedPoint(new(20, 5), new(0.5, 0)));
        Assert.Equal([0.1, 0.1, 0.1], Xs(wish.Wish.Elements[0]), Within);
        Assert.Equal([0.5, 0.5, 0.5], Xs(wish.Wish.Elements[1]), Within);
    }

    [Theory]
    [InlineData("N10", 5, 0.501, NcRefusalCodes.PointOffPath, "N10")]
    [InlineData("N10..N20", 18, -3, NcRefusalCodes.PointOffPath, "N20")]
    [InlineData("N40", 5, 0, NcRefusalCodes.NoMotion, "N40")]
    public void What_cannot_be_meant_is_refused(string blocks, double x, double y, string code, string block)
    {
        var refusal = Of(Square, [blocks], new DisplacedPoint(new(x, y), new(0.1, 0))).Refusal;
        Assert.Equal((code, block), (refusal?.Code, refusal?.Place.Block));
    }

    [Fact]
    public void A_run_without_a_point_is_refused()
    {
        var refusal = Of(Square, ["N10", "N30"], new DisplacedPoint(new(5, 0), new(0.1, 0))).Refusal;
        Assert.Equal((NcRefusalCodes.RunWithoutPoint, "N30"), (refusal?.Code, refusal?.Place.Block));
    }

    [Fact]
    public void Two_wishes_at_one_place_are_refused()
    {
        var refusal = Of(
            Square, ["N10"], new DisplacedPoint(new(5, 0.1), new(0.1, 0)), new DisplacedPoint(new(5, -0.1), new(0.2, 0))).Refusal;
        Assert.Equal(NcRefusalCodes.PointsCoincide, refusal?.Code);
    }

    [Fact]
    public void Another_plane_is_refused()
    {
        var refusal = Of("G90 G18 G21\nG0 X0 Y0 Z0\nN10 G1 X10 F100\n", ["N10"], new DisplacedPoint(new(5, 0), new(0.1, 0))).Refusal;
        Assert.Equal(NcRefusalCodes.PlaneChange, refusal?.Code);
    }

    [Fact]
    public void The_displaced_program_goes_where_the_points_say_and_the_proof_holds()
    {
        var path = Interpret(Square);
        var wish = Usable(Square, ["N10..N30"], new DisplacedPoint(new(0, 0), new(0, 0.1)), new DisplacedPoint(new(20, 10), new(0.1, 0.1)));
        var rewrite = Rewriter.Apply(path, wish.Wish).Result!;
        Assert.True(Prover.Check(path, rewrite.Program, wish.Wish, rewrite.LeastIncrementMm).Holds);

        // The flank at X20 goes by 2/3 to 3/3 of 0.1 in X over its length; the lines along X go up by 0.1 and meet it at Y0.1.
        var end = NcInterpreter.Run(rewrite.Program, path.Dialect).Motions[2].End;
        Assert.Equal((20.067, 0.1), (end.X, end.Y));
    }

    private static bool Within(double a, double b) => Math.Abs(a - b) < 1e-12;

    private static double[] Xs(ElementWish wish) => [wish.Start.X, wish.Middle.X, wish.End.X];

    private static PointwiseWish Usable(string program, string[] blocks, params DisplacedPoint[] points) =>
        Of(program, blocks, points) is { IsUsable: true } wish ? wish.Result : throw new InvalidOperationException("refused");

    private static Outcome<PointwiseWish> Of(string program, string[] blocks, params DisplacedPoint[] points)
    {
        var path = Interpret(program);
        return PointwiseWish.Of(path, BlockSelector.Select(path.Program, [.. blocks.Select(BlockSelector.Parse)]).Result!, points);
    }

    private static NcPath Interpret(string program) => NcInterpreter.Run(NcProgram.FromText(program), NcDialects.Generic);
}
