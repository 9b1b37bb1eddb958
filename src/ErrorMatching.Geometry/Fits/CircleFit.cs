using System.Globalization;
using MathNet.Numerics.LinearAlgebra;

namespace ErrorMatching.Geometry;

/// <summary>A circle fitted to measured points by least squares of the radial distances. Immutable.</summary>
/// <remarks>Starts with the algebraic fit of Kasa about the centroid, then applies Levenberg-Marquardt to center and radius until the step
/// is below 1e-13 of the circle's size. The standard errors are based on the standard deviation of a point: that of the residuals (<c>n -
/// 3</c> degrees of freedom) or the caller's uncertainty, whichever is larger. Three points have no residuals, so only the stated
/// uncertainty counts.</remarks>
public sealed class CircleFit
{
    /// <summary>Points whose fitted radius exceeds their extent by this factor are collinear: the arc bulges by less than an
    /// eight-millionth of its chord.</summary>
    public const double LargestRadiusPerExtent = 1e6;

    private const int MostSteps = 200;

    private CircleFit(Circle2 circle, IReadOnlyList<Point2> points, Point2 origin, double pointUncertaintyMm)
    {
        Circle = new(origin + (circle.Center - Point2.Origin), circle.Radius);
        var residuals = new double[points.Count];
        for (var i = 0; i < residuals.Length; i++)
        {
            residuals[i] = circle.SignedDistance(points[i]);
        }

        Residuals = Array.AsReadOnly(residuals);
        ResidualStandardDeviation = Samples.StandardDeviation(residuals, 3);
        var sigma = Math.Max(ResidualStandardDeviation, pointUncertaintyMm);
        var svd = Matrix<double>.Build.Dense(points.Count, 3, (i, j) => Slope(circle, points[i], j)).Svd();
        Condition = svd.ConditionNumber;
        CenterStandardError = new(Error(0), Error(1));
        RadiusStandardError = Error(2);

        double Error(int unknown)
        {
            var sum = 0.0;
            for (var k = 0; k < 3; k++)
            {
                var part = svd.VT[k, unknown] / svd.S[k];
                sum += part * part;
            }

            return sigma * Math.Sqrt(sum);
        }
    }

    /// <summary>The fitted circle.</summary>
    public Circle2 Circle { get; }

    /// <summary>Signed radial distance of each point, positive outside, in the given order, in millimeters.</summary>
    public IReadOnlyList<double> Residuals { get; }

    /// <summary>Root of the sum of squared residuals divided by <c>n - 3</c>, in millimeters; zero for three points.</summary>
    public double ResidualStandardDeviation { get; }

    /// <summary>Standard errors of the center in x and in y, in millimeters, to first order.</summary>
    public Vector2 CenterStandardError { get; }

    /// <summary>Standard error of the radius, in millimeters, to first order.</summary>
    public double RadiusStandardError { get; }

    /// <summary>Condition number of the linearized fit: about 1 for points all around, growing with 1 / (arc angle)^2.</summary>
    public double Condition { get; }

    /// <summary>The circle with the least sum of squared distances from the points.</summary>
    /// <param name="points">At least three noncollinear points.</param>
    /// <param name="pointUncertaintyMm">The gauge's standard uncertainty of a point across the circle in millimeters; 0 if unknown.</param>
    /// <exception cref="GeometryException"><see cref="GeometryError.TooFewPoints"/>; <see cref="GeometryError.NotFinite"/>;
    /// <see cref="GeometryError.CoincidentPoints"/> if fewer than three places differ by more than 1e-9 mm;
    /// <see cref="GeometryError.CollinearPoints"/> if the points are collinear or the radius would exceed
    /// <see cref="LargestRadiusPerExtent"/>; <see cref="GeometryError.NotConverged"/> after 200 steps.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The uncertainty is negative or not finite.</exception>
    public static CircleFit Fit(IReadOnlyList<Point2> points, double pointUncertaintyMm = 0)
    {
        Samples.Check(points, 3, "A circle");
        Samples.CheckUncertainty(pointUncertaintyMm);
        RefuseCoincident(points);
        var centroid = Samples.Centroid(points);
        var extent = 2 * points.Max(p => p.DistanceTo(centroid));

        // About the centroid, so that coordinates far from their origin do not use up the digits that the radius needs.
        var local = points.Select(p => Point2.Origin + (p - centroid)).ToArray();
        return new(Refine(Start(local, extent), local, extent), local, centroid, pointUncertaintyMm);
    }

    /// <summary>Kasa's fit: linear least squares of <c>x^2 + y^2 = 2 a x + 2 b y + c</c>, of points about
    /// their centroid.</summary>
    private static Circle2 Start(Point2[] points, double extent)
    {
        var (sxx, sxy, syy, sxz, syz) = (0.0, 0.0, 0.0, 0.0, 0.0);
        foreach (var point in points)
        {
            var d = point - Point2.Origin;
            var z = d.Dot(d);
            (sxx, sxy, syy) = (sxx + (d.X * d.X), sxy + (d.X * d.Y), syy + (d.Y * d.Y));
            (sxz, syz) = (sxz + (d.X * z), syz + (d.Y * z));
        }

        var determinant = (sxx * syy) - (sxy * sxy);
        var spread = sxx + syy;
        if (!(determinant > 1e-20 * spread * spread))
        {
            throw Straight(extent);
        }

        var toCenter = new Vector2((syy * sxz) - (sxy * syz), (sxx * syz) - (sxy * sxz)) / (2 * determinant);
        return new(Point2.Origin + toCenter, Math.Sqrt(toCenter.Dot(toCenter) + (spread / points.Length)));
    }

    private static Circle2 Refine(Circle2 circle, Point2[] points, double extent)
    {
        var damping = 1e-4;
        var cost = Cost(circle, points);
        for (var i = 0; i < MostSteps; i++)
        {
            if (circle.Radius > LargestRadiusPerExtent * extent)
            {
                throw Straight(extent);
            }

            var step = Step(circle, points, damping);
            var radius = circle.Radius + step[2];
            var next = radius >= 0 ? new Circle2(circle.Center + new Vector2(step[0], step[1]), radius) : circle;
            var nextCost = radius >= 0 ? Cost(next, points) : double.PositiveInfinity;
            // Near the end, the sum of squares is flat to rounding while the step still gains digits. Ignore rises due to rounding.
            if (nextCost <= cost * (1 + 1e-12))
            {
                (circle, cost, damping) = (next, nextCost, damping / 10);
            }
            else
            {
                damping *= 10;
            }

            if (step.L2Norm() <= 1e-13 * (circle.Radius + extent))
            {
                return circle;
            }
        }

        throw new GeometryException(
            GeometryError.NotConverged,
            string.Create(CultureInfo.InvariantCulture, $"The circle through {points.Length} points did not settle in {MostSteps} steps."));
    }

    private static Vector<double> Step(Circle2 circle, Point2[] points, double damping)
    {
        var normal = Matrix<double>.Build.Dense(3, 3);
        var right = Vector<double>.Build.Dense(3);
        Span<double> slopes = stackalloc double[3];
        foreach (var point in points)
        {
            var residual = circle.SignedDistance(point);
            for (var j = 0; j < 3; j++)
            {
                slopes[j] = Slope(circle, point, j);
            }

            for (var j = 0; j < 3; j++)
            {
                right[j] -= slopes[j] * residual;
                for (var k = 0; k < 3; k++)
                {
                    normal[j, k] += slopes[j] * slopes[k];
                }
            }
        }

        for (var j = 0; j < 3; j++)
        {
            normal[j, j] += damping * normal[j, j];
        }

        return normal.LU().Solve(right);
    }

    /// <summary>Derivative of a point's radial distance with respect to the center's x, its y, or the radius.</summary>
    private static double Slope(Circle2 circle, Point2 point, int unknown)
    {
        var d = point - circle.Center;
        var length = Math.Max(d.Length, double.Epsilon);
        return unknown switch { 0 => -d.X / length, 1 => -d.Y / length, _ => -1 };
    }

    private static double Cost(Circle2 circle, Point2[] points)
    {
        var sum = 0.0;
        foreach (var point in points)
        {
            var residual = circle.SignedDistance(point);
            sum += residual * residual;
        }

        return sum;
    }

    private static void RefuseCoincident(IReadOnlyList<Point2> points)
    {
        Point2? second = null;
        foreach (var point in points)
        {
            if (point.DistanceTo(points[0]) <= Intersect.DefaultTolerance)
            {
                continue;
            }

            if (second is { } other && point.DistanceTo(other) > Intersect.DefaultTolerance)
            {
                return;
            }

            second ??= point;
        }

        throw new GeometryException(
            GeometryError.CoincidentPoints,
            $"A circle needs three different points; the {points.Count} given lie on {(second is null ? "one place" : "two places")}.");
    }

    private static GeometryException Straight(double extent) => new(
        GeometryError.CollinearPoints,
        string.Create(
            CultureInfo.InvariantCulture,
            $"The points lie on a straight line over their extent of {extent:0.###} mm: no circle is determined."));
}
