using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests.Alignments;

public class AlignmentTests
{
    private static readonly Point2[] Theoretical = [new(10, 5), new(40, 7), new(38, 30), new(12, 28), new(25, 60)];

    public static TheoryData<AlignmentFreedom> Freedoms =>
        [AlignmentFreedom.None, AlignmentFreedom.X, AlignmentFreedom.Y, AlignmentFreedom.X | AlignmentFreedom.Y, AlignmentFreedom.Rotation,
         AlignmentFreedom.X | AlignmentFreedom.Rotation, AlignmentFreedom.Y | AlignmentFreedom.Rotation, AlignmentFreedom.All];

    [Fact]
    public void No_alignment_leaves_actual_less_theoretical()
    {
        var alignment = Alignment.None([new(1, 2), new(3, 4)], [new(1, 1), new(0, 4)]);
        Assert.Equal(RigidTransform2.Identity, alignment.Transform);
        Assert.Equal([new Vector2(0, 1), new Vector2(3, 0)], alignment.Residuals);
        Assert.Equal(3, alignment.Max);
        Assert.Equal(Math.Sqrt(5), alignment.Rms, 15);
    }

    [Fact]
    public void Datum_carries_origin_onto_origin_and_direction_onto_direction() =>
        Draw.Law(Draw.Segment.Two(), p =>
        {
            var (measured, theoretical) = p;
            if (measured.Length < 1 || theoretical.Length < 1)
            {
                return true;
            }

            var alignment = Alignment.Datum(measured, theoretical, [measured.Start, measured.End], [theoretical.Start, theoretical.End]);
            return alignment.Residuals[0].Length < 1e-10
                && Math.Abs(theoretical.Line.SignedDistance(alignment.Aligned[1])) < 1e-10
                && Math.Abs(theoretical.Line.Along(alignment.Aligned[1]) - measured.Length) < 1e-10;
        });

    [Fact]
    public void Best_fit_undoes_a_rigid_motion() =>
        Draw.Law(Draw.Transform, t =>
        {
            var motion = t with { Mirror = Mirror.None };
            var alignment = Alignment.BestFit([.. Theoretical.Select(motion.Apply)], Theoretical);
            return alignment.Max < 1e-10 && alignment.Rms < 1e-10;
        });

    [Theory]
    [MemberData(nameof(Freedoms))]
    public void Locked_components_stay_zero(AlignmentFreedom freedom)
    {
        var transform = Alignment.BestFit(Disturbed(3, Angle.FromDegrees(4), new(0.3, -0.7), 0.05), Theoretical, freedom).Transform;
        Assert.Equal(freedom.HasFlag(AlignmentFreedom.X), transform.Translation.X != 0);
        Assert.Equal(freedom.HasFlag(AlignmentFreedom.Y), transform.Translation.Y != 0);
        Assert.Equal(freedom.HasFlag(AlignmentFreedom.Rotation), transform.Rotation.Radians != 0);
    }

    [Theory]
    [MemberData(nameof(Freedoms))]
    public void No_free_motion_anywhere_leaves_less(AlignmentFreedom freedom) =>
        Draw.Law(FsCheck.Fluent.Gen.Choose(0, 100_000).Zip(Draw.Angle).Zip(Draw.Point), p =>
        {
            var ((seed, angle), by) = p;
            var actual = Disturbed(seed, angle, by - Point2.Origin, 3);
            var alignment = Alignment.BestFit(actual, Theoretical, freedom);
            var best = alignment.Residuals.Sum(r => r.Dot(r));

            // Every angle of a fine grid (or none), each with the best free translation: the mean of what is left along the free axes.
            var angles = freedom.HasFlag(AlignmentFreedom.Rotation)
                ? Enumerable.Range(0, 720)
                    .Select(i => Angle.FromDegrees(i / 2.0))
                    .Append(alignment.Transform.Rotation + Angle.FromRadians(1e-4))
                    .Append(alignment.Transform.Rotation - Angle.FromRadians(1e-4))
                : [default];
            return angles.All(a =>
            {
                var turned = actual.Select(new RigidTransform2(Mirror.None, a, default).Apply).ToArray();
                var dx = freedom.HasFlag(AlignmentFreedom.X) ? Theoretical.Zip(turned, (t, q) => t.X - q.X).Average() : 0;
                var dy = freedom.HasFlag(AlignmentFreedom.Y) ? Theoretical.Zip(turned, (t, q) => t.Y - q.Y).Average() : 0;
                return turned.Zip(
                    Theoretical, (q, t) => Math.Pow(q.X + dx - t.X, 2) + Math.Pow(q.Y + dy - t.Y, 2)).Sum() >= best - (1e-9 * (1 + best));
            });
        }, 60);

    [Theory]
    [InlineData(AlignmentFreedom.Rotation | AlignmentFreedom.X)]
    [InlineData(AlignmentFreedom.Rotation | AlignmentFreedom.Y)]
    [InlineData(AlignmentFreedom.Rotation)]
    public void Motion_within_the_free_components_is_undone_exactly(AlignmentFreedom freedom) =>
        Draw.Law(Draw.Angle.Zip(Draw.Coordinate), p =>
        {
            var (angle, by) = p;
            var undo = new RigidTransform2(
                Mirror.None,
                angle,
                freedom.HasFlag(AlignmentFreedom.X) ? new(by, 0) : freedom.HasFlag(AlignmentFreedom.Y) ? new(0, by) : default);
            var alignment = Alignment.BestFit([.. Theoretical.Select(undo.Inverse().Apply)], Theoretical, freedom);
            return alignment.Max < 1e-9 && Math.Abs((alignment.Transform.Rotation - angle).Normalized.Degrees) < 1e-9;
        }, 300);

    [Fact]
    public void Residuals_of_the_full_best_fit_balance()
    {
        // At the optimum neither a force nor a torque is left.
        var alignment = Alignment.BestFit(Disturbed(8, Angle.FromDegrees(12), new(5, 6), 0.5), Theoretical);
        Assert.Equal(0, alignment.Residuals.Sum(r => r.X), 10);
        Assert.Equal(0, alignment.Residuals.Sum(r => r.Y), 10);
        Assert.Equal(0, alignment.Residuals.Zip(alignment.Aligned, (r, q) => (q - Point2.Origin).Cross(r)).Sum(), 9);
    }

    [Fact]
    public void What_cannot_be_aligned_is_refused_by_name()
    {
        Refused.With(GeometryError.TooFewPoints, () => Alignment.BestFit([new(1, 1)], [new(1, 1)]));
        Refused.With(GeometryError.TooFewPoints, () => Alignment.BestFit([], [], AlignmentFreedom.X));
        Refused.With(GeometryError.CoincidentPoints, () => Alignment.BestFit([new(1, 1), new(1, 1)], [new(1, 1), new(2, 2)]));
        Refused.With(GeometryError.CoincidentPoints, () => Alignment.BestFit([new(1, 1), new(2, 2)], [new(1, 1), new(1, 1)]));
        Refused.With(
            GeometryError.RankDeficient,
            () => Alignment.BestFit([new(1, 0), new(0, 1), new(-1, 0), new(0, -1)], [new(1, 0), new(-1, 0), new(1, 0), new(-1, 0)]));
        Refused.With(GeometryError.NotFinite, () => Alignment.None([new(double.NaN, 1)], [new(1, 1)]));
        Refused.With(GeometryError.NotFinite, () => Alignment.None([new(1, 1)], [new(1, double.NegativeInfinity)]));
        Refused.With(GeometryError.CoincidentPoints, () => Alignment.Datum(new(new(1, 1), new(1, 1)), new(new(0, 0), new(1, 0)), [], []));
        Refused.With(GeometryError.NotFinite, () => Alignment.Datum(new(new(1, 1), new(double.NaN, 1)), new(new(0, 0), new(1, 0)), [], []));
        Assert.Throws<ArgumentException>(() => Alignment.None([new(1, 1)], []));
    }

    private static Point2[] Disturbed(int seed, Angle turn, Vector2 by, double noise)
    {
        var motion = new RigidTransform2(Mirror.None, turn, by);
        var errors = Draw.Noise(seed, 2 * Theoretical.Length);
        return [.. Theoretical.Select((p, i) => motion.Apply(p) + (new Vector2(errors[2 * i], errors[(2 * i) + 1]) * noise))];
    }
}
