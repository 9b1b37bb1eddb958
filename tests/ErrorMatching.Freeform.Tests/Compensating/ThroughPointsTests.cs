using ErrorMatching.Geometry;
using ErrorMatching.Testing;
using static ErrorMatching.Freeform.Tests.MeasuredDesign;

namespace ErrorMatching.Freeform.Tests;

/// <summary>A surface through the compensation points is expected to leave what it leaves, at the points and between them.</summary>
public sealed class ThroughPointsTests
{
    private const string Fit = "\"method\": \"best\", \"of\": \"error\"";

    // z = 30 - 0.004 x^2 bends otherwise from 32.25 mm on; the error is smooth.
    [Theory]
    [InlineData("tensor")]
    [InlineData("fit-surface")]
    public void What_the_fit_misses_of_the_nominal_surface_is_expected_and_warned_of(string method)
    {
        var piece = new MeasuredDesign(Broken, Fit, $"\"method\": \"{method}\", \"of\": \"points\"");
        var result = piece.Compensate(piece.With(Tilted)).Result!;
        var left = Left(piece, result, Tilted);

        // On the surface that is cut, by lines along the normals of the nominal one:
        // several micrometers, where at the points there is next to nothing.
        Assert.InRange(left.StandardDeviationMm, 0.001, 0.05);
        Assert.Equal(left.StandardDeviationMm, result.Mirror.Statistics.StandardDeviationMm, 0.05 * left.StandardDeviationMm);
        Assert.InRange(result.Mirror.Statistics.ProfileIsoMm, 0.9 * left.ProfileIsoMm, 1.2 * left.ProfileIsoMm);
        Assert.Same(result.Mirror, result.Predicted);
        if (method == "tensor")
        {
            Assert.All(result.Mirror.Errors, e => Assert.Equal(0, e, 5e-5));
            Assert.Equal("worse-between-points", Assert.Single(result.Warnings).Code);
        }

        var ofError = new MeasuredDesign(Broken);
        var exact = ofError.Compensate(ofError.With(Tilted)).Result!;
        Assert.Empty(exact.Warnings);
        Assert.InRange(exact.Mirror.Statistics.StandardDeviationMm, 0, 1e-4);
    }

    [Fact]
    public void The_map_shows_what_the_fit_leaves()
    {
        var piece = new MeasuredDesign(Broken, Fit, "\"method\": \"tensor\", \"of\": \"points\"");
        var result = piece.Compensate(piece.With(Tilted)).Result!;
        var map = ErrorMap.Of(result);
        foreach (var (p, left) in SurfaceNet.Parameters(piece.Surface).Zip(map.MirrorMm))
        {
            var at = piece.Surface.Spline.PointAt(p.U, p.V);
            if (Out(piece, result, p.U, p.V) is { } moved)
            {
                Assert.Equal(Tilted(p.U, p.V) + moved, left, 1e-4);
            }
        }

        Assert.InRange(map.MirrorMm.Max(Math.Abs), 0.002, 0.1);
    }

    // Simple shapes are within the reach of every fit: then nothing is warned of, and what is expected is what was said of the error.
    [Theory]
    [InlineData("best")]
    [InlineData("tensor")]
    [InlineData("through-curve-mesh")]
    public void A_fit_that_knows_the_surface_is_not_warned_of(string method)
    {
        var piece = new MeasuredDesign(PaperDesign.Three, Fit, $"\"method\": \"{method}\", \"of\": \"points\"");
        var result = piece.Compensate(piece.With(Tilted)).Result!;
        Assert.Empty(result.Warnings);
        Assert.InRange(result.Mirror.Statistics.StandardDeviationMm, 0, 2e-4);
    }

    // A surface through every point cuts their noise into the piece, and measuring it again adds its own: the root of two of it.
    [Theory]
    [InlineData("tensor")]
    [InlineData("best")]
    [InlineData("fit-surface")]
    public void Expected_spread_is_what_comes_over_many_machines(string method)
    {
        var (came, expected) = (0.0, 0.0);
        for (var seed = 1; seed <= Depth.Of(8, 20); seed++)
        {
            var noise = new Noise(seed);
            var shape = RandomShape.MachineError(seed);
            double Error(double u, double v) => shape.Height(TrueShape.LengthX * u, TrueShape.LengthY * v);
            var piece = new MeasuredDesign(PaperDesign.One, Fit, $"\"method\": \"{method}\", \"of\": \"points\"");
            var result = piece.Compensate(piece.With((u, v) => Error(u, v) + (0.001 * noise.Next()))).Result!;
            var after = DeviationStatistics.Of(
                [.. result.Samples.Select(s => Error(s.U, s.V) + result.MoveAt(s).Dot(s.Normal) + (0.001 * noise.Next()))]);
            came += after.StandardDeviationMm * after.StandardDeviationMm;
            expected += result.Mirror.Statistics.StandardDeviationMm * result.Mirror.Statistics.StandardDeviationMm;
        }

        Assert.InRange(Math.Sqrt(came / expected), 0.9, 1.1);
    }

    private static PartSurface Broken { get; } = new("BROKEN", BrokenSpline(), SurfaceRegion.Whole, 1);

    // A quadratic B-spline in u with a single knot at 0.43: its second derivative jumps there. Straight along v.
    private static SplineSurface BrokenSpline()
    {
        KnotVector u = new(2, [0, 0, 0, 0.43, 1, 1, 1]), v = KnotVector.Clamped(1, [0, 1]);
        double[] xs = [0, 75 * 0.43 / 2, 75 * 1.43 / 2, 75], zs = [30, 30, 24, 19];
        return new(u, v, [.. xs.Zip(zs).SelectMany(p => new[] { new Point3(p.First, 0, p.Second), new Point3(p.First, 63, p.Second) })]);
    }

    private static DeviationStatistics Left(MeasuredDesign piece, CompensationResult result, Func<double, double, double> error)
    {
        var left = new List<double>();
        for (var i = 0; i <= 50; i++)
        {
            for (var j = 0; j <= 50; j++)
            {
                if (Out(piece, result, i / 50.0, j / 50.0) is { } moved)
                {
                    left.Add(error(i / 50.0, j / 50.0) + moved);
                }
            }
        }

        Assert.True(left.Count > 2000);
        return DeviationStatistics.Of(left);
    }

    // Where a line along the normal of the nominal surface meets the one that is cut; beyond its edge it does not.
    private static double? Out(MeasuredDesign piece, CompensationResult result, double u, double v)
    {
        var hits = result.Surface.Spline.Hits(piece.Surface.Spline.PointAt(u, v), piece.Surface.NormalAt(u, v));
        return hits.Count == 0 ? null : hits.MinBy(h => Math.Abs(h.Along)).Along;
    }
}
