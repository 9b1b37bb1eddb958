using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>One motion of the whole piece that explains its errors.</summary>
public sealed class SurfaceMotionTests
{
    // The errors that a small motion makes are n . (t + w x p), by hand.
    [Fact]
    public void A_shift_and_a_turn_are_found_and_asked_about()
    {
        var piece = new MeasuredDesign(PaperDesign.Three);
        var (center, turn) = (Center(piece), new Vector3(0.0008, -0.0006, 0.0005));
        var shift = new Vector3(0.02, -0.03, 0.11);
        var result = piece.Compensate(Moved(piece, p => shift + turn.Cross(p - center))).Result!;

        var motion = result.Motion!;
        Assert.InRange((motion.ShiftMm - shift).Length, 0, 0.002);
        Assert.InRange((motion.TurnDegrees - (turn * (180 / Math.PI))).Length, 0, 0.003);
        Assert.InRange(motion.Explains, 0.999, 1);
        Assert.True(motion is { IsSignificant: true, AsksForOrigin: true, MostMm: 0.1 });
        var warning = Assert.Single(result.Warnings, w => w.Code == "check-origin");
        Assert.Equal("0.1", warning.Values[8]);
    }

    // Design one is straight along v: nothing resists a shift along Y, so none is told.
    [Fact]
    public void What_no_normal_determines_stays_zero()
    {
        var piece = new MeasuredDesign(PaperDesign.One);
        var motion = piece.Compensate(Moved(piece, _ => new(0, 0.05, 0.03))).Result!.Motion!;
        Assert.Equal(0, motion.ShiftMm.Y, 1e-9);
        Assert.InRange(motion.Explains, 0.999, 1);
        Assert.True(motion is { IsSignificant: true, AsksForOrigin: false });
    }

    [Theory]
    [InlineData(0.0999, false)]
    [InlineData(0.1001, true)]
    public void The_origin_is_asked_about_beyond_half_of_what_may_be_compensated(double shift, bool isAsked)
    {
        var piece = new MeasuredDesign(PaperDesign.Three);
        var result = piece.Compensate(Moved(piece, _ => new(0, 0, shift))).Result!;
        Assert.Equal(isAsked, result.Warnings.Any(w => w.Code == "check-origin"));
    }

    [Fact]
    public void The_job_may_state_the_distance()
    {
        var piece = new MeasuredDesign(PaperDesign.Three, "\"kind\": \"freeform\",", "\"kind\": \"freeform\", \"commonMotionMm\": 0.02,");
        Assert.Contains(piece.Compensate(Moved(piece, _ => new(0, 0, 0.03))).Result!.Warnings, w => w.Code == "check-origin");
        Assert.DoesNotContain(piece.Compensate(Moved(piece, _ => new(0, 0, 0.01))).Result!.Warnings, w => w.Code == "check-origin");
    }

    // 89 and 91 % of the sum of squares are a shift's, the rest alternates.
    [Theory]
    [InlineData(0.89, false)]
    [InlineData(0.91, true)]
    public void A_motion_that_leaves_more_than_a_tenth_is_not_the_only_cause(double share, bool isAsked)
    {
        var samples = Enumerable.Range(0, 100).Select(k =>
        {
            var (i, j) = (k % 10, k / 10);
            var error = 0.15 * (Math.Sqrt(share) + (Math.Sqrt(1 - share) * (((i + j) % 2 * 2) - 1)));
            return new ErrorSample(k + 1, i, j, i / 9.0, j / 9.0, new(10 * i, 10 * j, 0), new(0, 0, 1), error);
        }).ToArray();
        var motion = SurfaceMotion.Find(samples, 0.0001, 0.05)!;
        Assert.Equal(share, motion.Explains, 0.001);
        Assert.Equal(isAsked, motion.AsksForOrigin);
        // The mean of 100 errors.
        Assert.Equal(0.15 * Math.Sqrt((1 - share) * 100 / 97) / 10, motion.ShiftUncertaintyMm.Z, 1e-5);
    }

    [Fact]
    public void Noise_is_no_motion()
    {
        var piece = new MeasuredDesign(PaperDesign.Three);
        var found = Enumerable.Range(1, 60).Count(seed =>
        {
            var random = new Noise(seed);
            return piece.Compensate(piece.With((_, _) => 0.003 * random.Next())).Result!.Motion!.IsSignificant;
        });
        Assert.InRange(found, 0, 1);
    }

    private static Point3 Center(MeasuredDesign piece) => default(Point3)
        + (piece.Plan.Points.Aggregate(default(Vector3), (sum, p) => sum + (p.Position - default(Point3)))
            * (1.0 / piece.Plan.Points.Count));

    private static MeasuredPoints Moved(MeasuredDesign piece, Func<Point3, Vector3> by)
    {
        var errors = piece.Plan.Points.ToDictionary(p => (p.U, p.V), p => p.Normal.Dot(by(p.Position)));
        return piece.With((u, v) => errors[(u, v)]);
    }
}
