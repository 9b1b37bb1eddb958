using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>Actual points transformed to the frame of their theoretical ones: the transform and the remaining residual at each point.
/// Immutable.</summary>
/// <remarks>An alignment can hide the error to be matched. <see cref="Transform"/> is the part that it removed, <see cref="Residuals"/>
/// the part that remains.</remarks>
public sealed partial class Alignment
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
}
