using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>A notch or a ridge: two straight flanks fitted to measured points, and their apex, which no probe can reach (the triangle of
/// Wang 2021, figure 4). Immutable.</summary>
public sealed class Wedge
{
    /// <summary>Flanks closer to parallel than this, in degrees, have no usable apex: at half a degree, a micrometer across a flank moves
    /// it by more than 0.1 mm.</summary>
    public const double NearParallelDegrees = 0.5;

    private Wedge(LineFit first, LineFit second, Point2 apex)
    {
        (First, Second, Apex) = (first, second, apex);
        FirstDirection = Outward(first, apex);
        SecondDirection = Outward(second, apex);
        IncludedAngle = Angle.Between(FirstDirection, SecondDirection);
        FirstLength = Reach(first, apex, FirstDirection);
        SecondLength = Reach(second, apex, SecondDirection);
        var (a, b) = (first.AngleStandardError.Radians, second.AngleStandardError.Radians);
        IncludedAngleStandardError = Angle.FromRadians(Math.Sqrt((a * a) + (b * b)));
        ApexStandardError = PropagateToApex(first, second, apex);
    }

    /// <summary>The fit of the first flank.</summary>
    public LineFit First { get; }

    /// <summary>The fit of the second flank.</summary>
    public LineFit Second { get; }

    /// <summary>Where the flanks' lines meet.</summary>
    public Point2 Apex { get; }

    /// <summary>Standard errors of the apex in x and in y, in millimeters, propagated to first order from position and direction of both
    /// lines.</summary>
    public Vector2 ApexStandardError { get; }

    /// <summary>Unit direction from the apex along the first flank, toward its points.</summary>
    public Vector2 FirstDirection { get; }

    /// <summary>Unit direction from the apex along the second flank, toward its points.</summary>
    public Vector2 SecondDirection { get; }

    /// <summary>The angle between the flanks as seen from the apex, 0 to 180 degrees (equation 1 of Wang 2021).</summary>
    public Angle IncludedAngle { get; }

    /// <summary>Standard error of the included angle: root sum of squares of the errors of both directions.</summary>
    public Angle IncludedAngleStandardError { get; }

    /// <summary>Length of the first flank from the apex to its farthest projected point, in millimeters.</summary>
    public double FirstLength { get; }

    /// <summary>Length of the second flank from the apex to its farthest projected point, in millimeters.</summary>
    public double SecondLength { get; }

    /// <summary>Returns the wedge between two fitted flanks.</summary>
    /// <param name="first">The first flank.</param>
    /// <param name="second">The second flank.</param>
    /// <exception cref="GeometryException">The flanks are within <see cref="NearParallelDegrees"/> of parallel
    /// (<see cref="GeometryError.NearParallel"/>).</exception>
    public static Wedge Between(LineFit first, LineFit second)
    {
        var between = Angle.Between(first.Line.Direction, second.Line.Direction).Degrees;
        var fromParallel = Math.Min(between, 180 - between);
        if (fromParallel < NearParallelDegrees)
        {
            throw new GeometryException(
                GeometryError.NearParallel,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"The flanks are {fromParallel:0.####} degrees from parallel; at least {NearParallelDegrees} are needed for an apex."));
        }

        return new(first, second, Intersect.Lines(first.Line, second.Line).First);
    }

    /// <summary>Fits a wedge to the points of two flanks, each by total least squares.</summary>
    /// <param name="first">At least two points of the first flank.</param>
    /// <param name="second">At least two points of the second flank.</param>
    /// <param name="pointUncertaintyMm">The gauge's standard uncertainty of a point, in millimeters.</param>
    /// <exception cref="GeometryException">As for <see cref="LineFit.Total"/> and <see cref="Between"/>.</exception>
    public static Wedge Fit(IReadOnlyList<Point2> first, IReadOnlyList<Point2> second, double pointUncertaintyMm = 0) =>
        Between(LineFit.Total(first, pointUncertaintyMm), LineFit.Total(second, pointUncertaintyMm));

    private static Vector2 Outward(LineFit flank, Point2 apex) =>
        (flank.Centroid - apex).Dot(flank.Line.Direction) >= 0 ? flank.Line.Direction : -flank.Line.Direction;

    private static double Reach(LineFit flank, Point2 apex, Vector2 outward) =>
        Math.Max((flank.Extent.Start - apex).Dot(outward), (flank.Extent.End - apex).Dot(outward));

    private static Vector2 PropagateToApex(LineFit first, LineFit second, Point2 apex)
    {
        // An offset e of one line moves the apex along the other by e divided by the sine of the angle between them.
        var sine = first.Line.Direction.Cross(second.Line.Direction);
        var byFirst = second.Line.Direction * (first.OffsetStandardErrorAt(apex) / sine);
        var bySecond = first.Line.Direction * (second.OffsetStandardErrorAt(apex) / sine);
        return new(new Vector2(byFirst.X, bySecond.X).Length, new Vector2(byFirst.Y, bySecond.Y).Length);
    }
}
