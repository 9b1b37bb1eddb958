using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>Actual points transformed to the frame of their theoretical ones: the transform and the remaining residual at each point.
/// Immutable.</summary>
/// <remarks>An alignment can hide the error to be matched. <see cref="Transform"/> is the part that it removed, <see cref="Residuals"/>
/// the part that remains.</remarks>
public sealed class Alignment
{
    private Alignment(RigidTransform2 transform, IReadOnlyList<Point2> actual, IReadOnlyList<Point2> theoretical)
    {
        Transform = transform;
        var aligned = new Point2[actual.Count];
        var residuals = new Vector2[actual.Count];
        var sum = 0.0;
        for (var i = 0; i < aligned.Length; i++)
        {
            aligned[i] = transform.Apply(actual[i]);
            residuals[i] = aligned[i] - theoretical[i];
            sum += residuals[i].Dot(residuals[i]);
            Max = Math.Max(Max, residuals[i].Length);
        }

        Aligned = Array.AsReadOnly(aligned);
        Residuals = Array.AsReadOnly(residuals);
        Rms = aligned.Length == 0 ? 0 : Math.Sqrt(sum / aligned.Length);
    }

    /// <summary>The transform of the actual points. It never mirrors.</summary>
    public RigidTransform2 Transform { get; }

    /// <summary>The transformed actual points, in the given order.</summary>
    public IReadOnlyList<Point2> Aligned { get; }

    /// <summary>Aligned minus theoretical point, in the given order, in millimeters.</summary>
    public IReadOnlyList<Vector2> Residuals { get; }

    /// <summary>Root mean square length of the residuals, in millimeters; zero without points.</summary>
    public double Rms { get; }

    /// <summary>Length of the longest residual, in millimeters; zero without points.</summary>
    public double Max { get; }

    /// <summary>No alignment: the actual coordinates are already in the theoretical frame.</summary>
    /// <param name="actual">Measured points.</param>
    /// <param name="theoretical">Their theoretical positions, in the same number and order.</param>
    /// <exception cref="GeometryException">A coordinate is not finite (<see cref="GeometryError.NotFinite"/>).</exception>
    /// <exception cref="ArgumentException">The lists differ in length.</exception>
    public static Alignment None(IReadOnlyList<Point2> actual, IReadOnlyList<Point2> theoretical)
    {
        CheckPairs(actual, theoretical, 0);
        return new(RigidTransform2.Identity, actual, theoretical);
    }

    /// <summary>Alignment by a datum: moves a measured origin to the theoretical one, and turns the direction to a second measured point
    /// into the direction to the second theoretical point.</summary>
    /// <param name="measuredDatum">Measured origin and direction point.</param>
    /// <param name="theoreticalDatum">Theoretical origin and direction point.</param>
    /// <param name="actual">Measured points.</param>
    /// <param name="theoretical">Their theoretical positions, in the same number and order.</param>
    /// <exception cref="GeometryException">Origin and direction point of a datum are within 1e-9 mm
    /// (<see cref="GeometryError.CoincidentPoints"/>), or a coordinate is not finite (<see cref="GeometryError.NotFinite"/>).</exception>
    /// <exception cref="ArgumentException">The lists differ in length.</exception>
    public static Alignment Datum(
        Segment2 measuredDatum, Segment2 theoreticalDatum, IReadOnlyList<Point2> actual, IReadOnlyList<Point2> theoretical)
    {
        CheckPairs(actual, theoretical, 0);
        Samples.Check([measuredDatum.Start, measuredDatum.End, theoreticalDatum.Start, theoreticalDatum.End], 4, "A datum");
        if (Math.Min(measuredDatum.Length, theoreticalDatum.Length) <= Intersect.DefaultTolerance)
        {
            throw new GeometryException(
                GeometryError.CoincidentPoints, "The origin of the datum and the point that gives its direction coincide.");
        }

        var turn = (
            (theoreticalDatum.End - theoreticalDatum.Start).Direction - (measuredDatum.End - measuredDatum.Start).Direction).Normalized;
        return new(Carrying(turn, measuredDatum.Start, theoreticalDatum.Start), actual, theoretical);
    }

    /// <summary>The rotation followed by the translation that moves one point to another.</summary>
    private static RigidTransform2 Carrying(Angle turn, Point2 from, Point2 to)
    {
        var rotation = new RigidTransform2(Mirror.None, turn, Vector2.Zero);
        return rotation with { Translation = to - rotation.Apply(from) };
    }

    private static void CheckPairs(IReadOnlyList<Point2> actual, IReadOnlyList<Point2> theoretical, int least)
    {
        if (actual.Count != theoretical.Count)
        {
            throw new ArgumentException(
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"{actual.Count} actual points cannot be compared with {theoretical.Count} theoretical ones."),
                nameof(theoretical));
        }

        Samples.Check(actual, least, "An alignment");
        Samples.Check(theoretical, least, "An alignment");
    }

    // Rigid least squares with locked degrees of freedom.

    /// <summary>Alignment with the least sum of squared residuals among the free motions: a rotation about the origin of the frame, then a
    /// translation whose locked components are zero.</summary>
    /// <remarks>For any rotation, the free components of the best translation equal the difference of the means. So coordinates along a
    /// free axis are relative to their mean, and along a locked axis to the origin of the frame. This leaves a function of the rotation
    /// alone, <c>const + p cos 2a + q sin 2a - 2 (d cos a + f sin a)</c>. If both axes are free or both locked, p and q vanish and <c>a =
    /// atan2(f, d)</c> (the planar case of Horn 1987). If one is locked, it has at most two minima. Both are found to rounding, and the
    /// lower one is used.</remarks>
    /// <param name="actual">Measured points: at least two if the rotation is free, otherwise one.</param>
    /// <param name="theoretical">Their theoretical positions, in the same number and order.</param>
    /// <param name="freedom">The free motions.</param>
    /// <exception cref="GeometryException"><see cref="GeometryError.TooFewPoints"/>; <see cref="GeometryError.NotFinite"/>;
    /// <see cref="GeometryError.CoincidentPoints"/> if the rotation is free and all actual or all theoretical points are within 1e-9 mm;
    /// <see cref="GeometryError.RankDeficient"/> if every rotation fits equally.</exception>
    /// <exception cref="ArgumentException">The lists differ in length.</exception>
    public static Alignment BestFit(
        IReadOnlyList<Point2> actual, IReadOnlyList<Point2> theoretical, AlignmentFreedom freedom = AlignmentFreedom.All)
    {
        var turns = freedom.HasFlag(AlignmentFreedom.Rotation);
        CheckPairs(actual, theoretical, turns ? 2 : 1);
        var turn = turns ? BestTurn(actual, theoretical, freedom) : default;
        var move = Carrying(turn, Samples.Centroid(actual), Samples.Centroid(theoretical)).Translation;
        var free = new Vector2(freedom.HasFlag(AlignmentFreedom.X) ? move.X : 0, freedom.HasFlag(AlignmentFreedom.Y) ? move.Y : 0);
        return new(new(Mirror.None, turn, free), actual, theoretical);
    }

    private static Angle BestTurn(IReadOnlyList<Point2> actual, IReadOnlyList<Point2> theoretical, AlignmentFreedom freedom)
    {
        RefuseOnePlace(actual);
        RefuseOnePlace(theoretical);
        var (meanOfActual, meanOfTheoretical) = (Samples.Centroid(actual), Samples.Centroid(theoretical));
        var (p, q, d, f, scale) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for (var i = 0; i < actual.Count; i++)
        {
            Row(freedom.HasFlag(AlignmentFreedom.X), i, out var a, out var b);
            Add(a.X, -a.Y, b.X);
            Row(freedom.HasFlag(AlignmentFreedom.Y), i, out a, out b);
            Add(a.Y, a.X, b.Y);
        }

        // One coordinate of one point: (u cos + v sin - w)^2.
        void Add(double u, double v, double w)
        {
            p += ((u * u) - (v * v)) / 2;
            q += u * v;
            d += u * w;
            f += v * w;
            scale += (u * u) + (v * v) + (w * w);
        }

        void Row(bool centered, int i, out Vector2 a, out Vector2 b)
        {
            a = actual[i] - (centered ? meanOfActual : Point2.Origin);
            b = theoretical[i] - (centered ? meanOfTheoretical : Point2.Origin);
        }

        const double rounding = 1e-14;
        var oneLocked = freedom.HasFlag(AlignmentFreedom.X) != freedom.HasFlag(AlignmentFreedom.Y);
        if (!oneLocked)
        {
            // The sums of p and q cancel exactly in theory. This removes their rounding error.
            (p, q) = (0, 0);
        }

        if (Math.Max(Math.Max(Math.Abs(p), Math.Abs(q)), Math.Max(Math.Abs(d), Math.Abs(f))) <= rounding * scale)
        {
            throw new GeometryException(
                GeometryError.RankDeficient, "Every rotation fits the points alike: they do not tell the rotation.");
        }

        return Angle.FromRadians(oneLocked ? LowestMinimum(p, q, d, f) : Elementary.Atan2(f, d));
    }

    /// <summary>The angle in (-pi, pi] at which <c>p cos 2a + q sin 2a - 2 (d cos a + f sin a)</c> is smallest.</summary>
    private static double LowestMinimum(double p, double q, double d, double f)
    {
        double Value(double a)
        {
            var ((sin, cos), (sinTwice, cosTwice)) = (Elementary.SinCos(a), Elementary.SinCos(2 * a));
            return (p * cosTwice) + (q * sinTwice) - (2 * ((d * cos) + (f * sin)));
        }

        double Slope(double a)
        {
            var ((sin, cos), (sinTwice, cosTwice)) = (Elementary.SinCos(a), Elementary.SinCos(2 * a));
            return (2 * ((q * cosTwice) - (p * sinTwice))) + (2 * ((d * sin) - (f * cos)));
        }

        // The slope has at most four zeros per turn. This grid separates them unless two meet, which is a flat point, not another minimum.
        const int steps = 360;
        const double width = 2 * Math.PI / steps;
        var best = (At: 0.0, Value: double.PositiveInfinity);
        for (var i = 0; i < steps; i++)
        {
            var (from, to) = (-Math.PI + (i * width), -Math.PI + ((i + 1) * width));
            if (Slope(from) <= 0 && Slope(to) >= 0)
            {
                var at = Zero(Slope, from, to);
                best = Value(at) < best.Value ? (at, Value(at)) : best;
            }
        }

        return best.At;
    }

    /// <summary>The zero of a function that rises from at most zero to at least zero, by bisection to the spacing of doubles.</summary>
    private static double Zero(Func<double, double> function, double from, double to)
    {
        while (true)
        {
            var middle = (from + to) / 2;
            if (middle <= from || middle >= to)
            {
                return middle;
            }

            (from, to) = function(middle) <= 0 ? (middle, to) : (from, middle);
        }
    }

    private static void RefuseOnePlace(IReadOnlyList<Point2> points)
    {
        foreach (var point in points)
        {
            if (point.DistanceTo(points[0]) > Intersect.DefaultTolerance)
            {
                return;
            }
        }

        throw new GeometryException(
            GeometryError.CoincidentPoints, "All points of the alignment lie on one another: they do not tell the rotation.");
    }
}
