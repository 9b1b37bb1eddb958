using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Limits are an outer loop and holes in it, on a flat surface of 60 x 40 whose parameters are millimeters.</summary>
public sealed class LoopNestingTests
{
    private static readonly SplineSurface Flat = new(
        KnotVector.Clamped(1, [0, 60]), KnotVector.Clamped(1, [0, 40]), [new(0, 0, 0), new(0, 40, 0), new(60, 0, 0), new(60, 40, 0)]);

    [Theory]
    [InlineData("5 5 55 5 55 35 5 35", "20 10 40 10 40 20 20 20")] // a hole
    [InlineData("5 5 55 5 55 35 5 35", "20 20 40 20 40 10 20 10")] // the other way round
    [InlineData("20 10 40 10 40 20 20 20", "5 5 55 5 55 35 5 35")] // the hole first
    [InlineData("5 5 55 5 55 35 5 35", "10 10 20 10 20 20 10 20", "30 10 40 10 40 20 30 20")] // two holes
    [InlineData("5 5 55 5 55 35 5 35", "5 10 20 10 20 20 5 20")] // along the outer limit
    [InlineData("5 5 55 5 55 35 5 35", "4.97 10 20 10 20 20 5.02 20")] // along it, as inexactly as files are
    [InlineData("5 5 55 5 55 35 5 35", "5 20 15 10 25 20 15 30")] // a corner on it
    [InlineData("5 5 55 5 55 35 5 35", "10 10 20 10 20 20 10 20", "20.01 12 30 12 30 18 19.98 18")] // holes side by side
    [InlineData("5 5 55 5 55 35 5 35", "10 10 20 10 20 20 10 20", "20 20 30 20 30 30 20 30")] // holes that share a corner
    [InlineData("5 5 55 5 55 35 5 35 5 20 20 20 20 15 10 15 10 19.99 20 20 5 20.01")] // a hole at the end of a slit
    [InlineData("5 5 30 5 30 20 30 5 55 5 55 35 5 35")] // a line into the piece and back
    [InlineData("5 5 55 5 55.03 5 55 4.98 55 35 5 35")] // ends that do not meet exactly
    [InlineData("0 0 60 0 60 40 0 40", "0 0 20 0 20 20 0 20")] // a corner of the surface cut off by a hole
    public void Loops_that_limit_a_piece_are_taken(params string[] loops) =>
        Assert.Equal(loops.Length, Limits([.. loops.Select(Loop)]).Loops.Count);

    [Theory]
    [InlineData("cross each other", "5 5 35 5 35 35 5 35", "30 10 50 10 50 20 30 20")]
    [InlineData("cross each other", "5 5 35 5 35 35 5 35", "34.8 10 35.2 10 35.2 20 34.8 20")]
    [InlineData("cross each other", "5 15 55 15 55 25 5 25", "25 5 35 5 35 35 25 35")] // no corner inside of the other
    [InlineData("cross each other", "10 20 30 5 50 20 30 35", "10 20 20 10 30 5 55 6")] // through shared corners
    [InlineData("cross each other", "5 5 55 5 55 35 5 35", "10 10 30 10 30 20 10 20", "25 15 45 15 45 30 25 30")] // two holes
    [InlineData("crosses itself", "5 5 55 5 5 35 55 35")] // lobes as large as each other
    [InlineData("crosses itself", "5 5 55 5 55 35 40 35 20 3 20 35 5 35")] // a corner through the other side
    [InlineData("crosses itself", "5 5 55 5 55 35 5 35 6 6 50 8 50 30 6 30")] // twice round
    [InlineData("lies on others all the way", "5 5 55 5 55 35 5 35", "10 10 20 10 20 20 10 20", "10 10 20 10 20 20 10 20")]
    [InlineData("lies outside of the largest one", "5 5 35 5 35 35 5 35", "40 10 50 10 50 20 40 20")]
    [InlineData("lies inside of a hole", "5 5 55 5 55 35 5 35", "10 10 50 10 50 30 10 30", "20 15 30 15 30 20 20 20")]
    public void Loops_that_do_not_are_refused(string why, params string[] loops)
    {
        // In any order, and beginning anywhere.
        for (var first = 0; first < 4; first++)
        {
            var turned = loops.Select(Loop).Select(l => (IReadOnlyList<Point2>)[.. l.Skip(first), .. l.Take(first)]).ToList();
            turned.Reverse();
            var error = Assert.Throws<InputException>(() => Limits(turned));
            Assert.Equal("bad-loop", error.Code);
            Assert.Contains(why, error.Problem, StringComparison.Ordinal);
        }
    }

    [Fact]
    public void A_limit_that_leaves_the_outer_one_is_told_by_places_on_either_side_of_it()
    {
        var error = Assert.Throws<InputException>(() => Limits([Circle(30, 20, 10, 400), Circle(38, 20, 6, 400)]));
        Assert.Equal((true, true), (Far("through (", " inside"), !Far("and through (", " outside")));

        // The place that is said to be inside of the one is outside of the other.
        bool Far(string before, string behind)
        {
            var text = error.Problem[(error.Problem.IndexOf(before, StringComparison.Ordinal) + before.Length)..];
            var at = text[..text.IndexOf(')', StringComparison.Ordinal)].Split(", ")
                .Select(n => double.Parse(n, CultureInfo.InvariantCulture))
                .ToArray();
            Assert.StartsWith(behind, text[(text.IndexOf(')', StringComparison.Ordinal) + 1)..], StringComparison.Ordinal);
            return (new Point2(at[0], at[1]) - new Point2(30, 20)).Length < 10.001 == (new Point2(at[0], at[1]) - new Point2(38, 20)).Length
                < 6.001;
        }
    }

    [Theory]
    [InlineData(13.96, true)]
    [InlineData(14.04, true)]
    [InlineData(14.2, false)]
    public void Circles_may_touch_as_exactly_as_they_are_written(double distance, bool taken)
    {
        IReadOnlyList<Point2>[] loops = [Circle(30, 20, 18, 3000), Circle(30 + distance, 20, 4, 1000)];
        Assert.Equal(taken, Record.Exception(() => Limits(loops)) is null);
    }

    // On half a cylinder of radius 20 a straight side of the parameters is far from its chord.
    [Theory]
    [InlineData(0.4, true)]
    [InlineData(0.6, false)]
    public void Sides_that_are_long_on_a_bent_surface_are_followed(double to, bool taken)
    {
        var arc = SplineArc.Of(default, new(20, 0, 0), new(0, 0, 20), 0, Math.PI);
        var surface = new SplineSurface(
            arc.Knots,
            KnotVector.Clamped(1, [0, 40]),
            [.. arc.Poles.ToArray().SelectMany(p => new[] { p, p + new Vector3(0, 40, 0) })],
            [.. arc.Weights.ToArray().SelectMany(w => new[] { w, w })]);
        IReadOnlyList<Point2> outer = [new(0.1, 2), new(3, 2), new(3, 20), new(0.1, 20)];
        IReadOnlyList<Point2> hole = [new(0.5, 5), new(2.5, 5), new(2.5, 40 * to), new(0.5, 40 * to)];
        Assert.Equal(taken, Record.Exception(() => RegionLimits.Of(surface, [outer, hole], Fail)) is null);
    }

    // Of the billion pairs of sides only those that are near each other may be looked at.
    [Fact]
    public void Loops_of_very_many_sides_are_taken_or_refused()
    {
        var outer = Wave(19.9, 30_000);
        Assert.Equal(2, Limits([outer, Wave(19, 29_000)]).Loops.Count);
        Assert.Equal("bad-loop", Assert.Throws<InputException>(() => Limits([outer, Circle(49, 20, 3, 27_000)])).Code);
        Assert.Equal(
            2501,
            Limits(
                [
                    Loop("0 0 60 0 60 40 0 40"),
                    .. Enumerable.Range(0, 2500).Select(k => Circle(0.6 + (1.1 * (k % 50)), 0.4 + (0.78 * (k / 50)), 0.3, 40))])
                .Loops.Count);
    }

    // Teeth of a comb that leans: the boxes around them all overlap.
    [Fact]
    public void Limits_that_are_too_many_to_be_told_apart_are_refused()
    {
        const int teeth = 20_000;
        var comb = new List<Point2> { new(1, 1) };
        for (var i = 0; i < teeth; i++)
        {
            var x = 1 + (28.0 * i / teeth);
            comb.AddRange([new(x, 2), new(x + 28, 39), new(x + 28 + (14.0 / teeth), 39), new(x + (14.0 / teeth), 2)]);
        }

        comb.Add(new(30, 1));
        Assert.Equal("too-large", Assert.Throws<InputException>(() => Limits([comb])).Code);
    }

    [Fact]
    public void The_entity_and_its_line_are_named()
    {
        var file = new IgesText();
        var surface = file.Add(128, IgesText.Flat(60, 40), dependent: true);
        var outer = file.Add(
            142, $"142,0,{surface},0,{file.Add(100, "100,0.,30.,20.,40.,20.,40.,20.", dependent: true)},2", dependent: true);
        var hole = file.Add(
            142, $"142,0,{surface},0,{file.Add(100, "100,0.,38.,20.,44.,20.,44.,20.", dependent: true)},2", dependent: true);
        var trimmed = file.Add(144, $"144,{surface},1,1,{outer},{hole}");
        var error = Assert.Throws<InputException>(() => file.Read());
        Assert.Equal(("bad-loop", trimmed + 3), (error.Code, error.Place.Line));
        Assert.StartsWith($"entity 144 at D{trimmed}: ", error.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void The_face_and_its_line_are_named()
    {
        var file = StepByHand.File("#100", $"""
            #100=ADVANCED_FACE('',(#110,#120),#130,.T.);
            #110=FACE_OUTER_BOUND('',#111,.T.);
            #111=POLY_LOOP('',(#201,#202,#203,#204));
            #120=FACE_BOUND('',#121,.T.);
            #121=POLY_LOOP('',(#205,#206,#207,#208));
            #130=PLANE('',#131);
            #131=AXIS2_PLACEMENT_3D('',#201,$,$);
            {StepByHand.Points(201, "0.,0.,0.", "60.,0.,0.", "60.,40.,0.", "0.,40.,0.", "50.,10.,0.", "70.,10.,0.", "70.,20.,0.", "50.,20.,0.")}
            """);
        var error = Assert.Throws<InputException>(() => StepByHand.Read(file));
        Assert.Equal(("bad-loop", 11), (error.Code, error.Place.Line));
        Assert.Contains("#100 ADVANCED_FACE: ", error.Problem, StringComparison.Ordinal);
    }

    private static SurfaceRegion Limits(IReadOnlyList<IReadOnlyList<Point2>> loops) => RegionLimits.Of(Flat, loops, Fail);

    private static InputException Fail(string code, string problem) => InputException.At(code, "a.igs", problem);

    private static IReadOnlyList<Point2> Loop(string text) =>
        [.. text.Split(' ').Select(n => double.Parse(n, CultureInfo.InvariantCulture)).Chunk(2).Select(p => new Point2(p[0], p[1]))];

    private static IReadOnlyList<Point2> Circle(double x, double y, double radius, int count) =>
        [
            .. Enumerable.Range(0, count).Select(i => new Point2(
                x + (radius * Math.Cos(Math.Tau * i / count)), y + (radius * Math.Sin(Math.Tau * i / count))))];

    private static IReadOnlyList<Point2> Wave(double radius, int count) =>
        [
            .. Enumerable.Range(0, count)
                .Select(i => (Angle: Math.Tau * i / count, R: radius - 0.3 + (0.3 * Math.Cos(Math.Tau * 500 * i / count))))
                .Select(a => new Point2(30 + (a.R * Math.Cos(a.Angle)), 20 + (a.R * Math.Sin(a.Angle))))];
}
