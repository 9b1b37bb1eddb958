using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>The largest circle inside measured points, or the smallest around them. Immutable.</summary>
/// <remarks>
/// Both touch two or three of the points (<see cref="Contacts"/>) and are as uncertain as these: standard errors are those of the circle
/// through the contacts, to first order.
/// </remarks>
public sealed class ExtremeCircle
{
    private const int MostSteps = 100;

    private ExtremeCircle(Circle2 circle, int[] contacts, IReadOnlyList<Point2> points, double pointUncertaintyMm)
    {
        Circle = circle;
        Contacts = Array.AsReadOnly(contacts);
        Residuals = Array.AsReadOnly([.. points.Select(circle.SignedDistance)]);
        (CenterStandardError, RadiusStandardError) = Errors(
            [.. contacts.Select(i => (points[i] - circle.Center) / circle.Radius)], pointUncertaintyMm);
    }

    /// <summary>The circle.</summary>
    public Circle2 Circle { get; }

    /// <summary>Which of the points it touches: three, or the two ends of a diameter.</summary>
    public IReadOnlyList<int> Contacts { get; }

    /// <summary>Signed distance of each point from the circle, positive outside, in the order given, in millimetres.</summary>
    public IReadOnlyList<double> Residuals { get; }

    /// <summary>
    /// Standard errors of the center in x and in y, in millimetres, to first order; of a diameter's middle in either direction.
    /// </summary>
    public Vector2 CenterStandardError { get; }

    /// <summary>Standard error of the radius, in millimetres, to first order.</summary>
    public double RadiusStandardError { get; }

    /// <summary>The largest circle that none of the points lies inside of, with its center among them.</summary>
    /// <remarks>
    /// With <c>u</c> the unit vectors and <c>d</c> the distances from a center to the points, a step <c>s</c> of it changes the distances
    /// by <c>-u.s</c>. The largest <c>r</c> with
    /// <c>r + u.s &lt;= d</c> for all points is a linear program in three unknowns, solved by exchanging one of three points that
    /// surround the center for the point that is violated
    /// most (dual simplex), from the center of <see cref="CircleFit"/> on, until the center rests.
    /// </remarks>
    /// <param name="points">At least three points around a center.</param>
    /// <param name="pointUncertaintyMm">Standard uncertainty of a point across the circle that the gauge states, in millimetres; zero if
    /// unknown.</param>
    /// <exception cref="GeometryException">
    /// Those of <see cref="CircleFit.Fit"/>; <see cref="GeometryError.NotAround"/> if the points leave half a turn or more open, so that
    /// no circle inside them is the largest.
    /// </exception>
    /// <exception cref="ArgumentOutOfRangeException">The uncertainty is negative or not finite.</exception>
    public static ExtremeCircle Inscribed(IReadOnlyList<Point2> points, double pointUncertaintyMm = 0)
    {
        var start = CircleFit.Fit(points, pointUncertaintyMm).Circle;
        var (center, reach) = (start.Center, start.Radius);
        for (var step = 0; step < MostSteps; step++)
        {
            var contacts = Largest(
                [.. points.Select(p => (p - center).Normalize())], [.. points.Select(p => p.DistanceTo(center))], out var move);
            center += move;
            if (move.Length <= 1e-13 * (reach + (center - Point2.Origin).Length))
            {
                return new(new(center, contacts.Average(i => points[i].DistanceTo(center))), contacts, points, pointUncertaintyMm);
            }
        }

        throw Unsettled(points.Count);
    }

    /// <summary>The smallest circle that none of the points lies outside of.</summary>
    /// <remarks>Point after point: one outside of the circle so far lies on the next one (Welzl 1991, without the shuffle, so that the
    /// order of steps is the points').</remarks>
    /// <param name="points">At least three points.</param>
    /// <param name="pointUncertaintyMm">Standard uncertainty of a point across the circle that the gauge states, in millimetres; zero if
    /// unknown.</param>
    /// <exception cref="GeometryException"><see cref="GeometryError.TooFewPoints"/>; <see cref="GeometryError.NotFinite"/>; <see
    /// cref="GeometryError.CoincidentPoints"/> if all are one place.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The uncertainty is negative or not finite.</exception>
    public static ExtremeCircle Circumscribed(IReadOnlyList<Point2> points, double pointUncertaintyMm = 0)
    {
        Samples.Check(points, 3, "A circle");
        Samples.CheckUncertainty(pointUncertaintyMm);
        var (circle, contacts) = (new Circle2(points[0], 0), new[] { 0 });
        for (var i = 1; i < points.Count; i++)
        {
            if (!IsOutside(circle, points[i]))
            {
                continue;
            }

            (circle, contacts) = (new(points[i], 0), [i]);
            for (var j = 0; j < i; j++)
            {
                if (!IsOutside(circle, points[j]))
                {
                    continue;
                }

                var diameter = new Segment2(points[i], points[j]);
                (circle, contacts) = (new(diameter.Middle, diameter.Length / 2), [i, j]);
                for (var k = 0; k < j; k++)
                {
                    if (IsOutside(circle, points[k]))
                    {
                        (circle, contacts) = (Circle2.Through(points[i], points[j], points[k]), [i, j, k]);
                    }
                }
            }
        }

        return circle.Radius > Intersect.DefaultTolerance
            ? new(circle, [.. contacts.Order()], points, pointUncertaintyMm)
            : throw new GeometryException(
                GeometryError.CoincidentPoints, $"A circle needs three different points; the {points.Count} given lie on one place.");
    }

    /// <summary>The largest angle seen from a center between neighboring points: what of a turn they leave open.</summary>
    public static Angle LargestGap(Point2 center, IReadOnlyList<Point2> points)
    {
        ArgumentNullException.ThrowIfNull(points);
        double[] angles = [.. points.Select(p => Elementary.Atan2(p.Y - center.Y, p.X - center.X)).Order()];
        return Angle.FromRadians(angles.Select((a, i) => i + 1 < angles.Length ? angles[i + 1] - a : angles[0] + (2 * Math.PI) - a).Max());
    }

    private static bool IsOutside(Circle2 circle, Point2 point) => circle.Center.DistanceTo(point) > circle.Radius * (1 + 1e-14);

    // The linear program: which three constraints hold it, and the step.
    private static int[] Largest(Vector2[] u, double[] d, out Vector2 move)
    {
        var basis = Surrounding(u);
        for (var exchange = 0; exchange < MostSteps * u.Length; exchange++)
        {
            // r + u.s = d at three points.
            var (a, b, c) = (u[basis[0]], u[basis[1]], u[basis[2]]);
            var determinant = (b - a).Cross(c - a);
            var (db, dc) = (d[basis[1]] - d[basis[0]], d[basis[2]] - d[basis[0]]);
            move = new Vector2((db * (c - a).Y) - (dc * (b - a).Y), ((b - a).X * dc) - ((c - a).X * db)) / determinant;
            var (step, r) = (move, d[basis[0]] - a.Dot(move));
            var worst = Enumerable.Range(0, u.Length).MinBy(i => d[i] - u[i].Dot(step) - r);
            if (d[worst] - u[worst].Dot(step) - r >= -1e-14 * r)
            {
                return basis;
            }

            // Shares of the center (0) and of the new point in the triangle of the three; which corner leaves first when the new point
            // comes in.
            double[] center = Shares(a, b, c, determinant, Vector2.Zero), point = Shares(a, b, c, determinant, u[worst]);
            var leaves = Enumerable.Range(0, 3).Where(k => point[k] > 1e-12).MinBy(k => center[k] / point[k]);
            basis[leaves] = worst;
        }

        throw Unsettled(u.Length);
    }

    private static GeometryException Unsettled(int points) =>
        new(GeometryError.NotConverged, string.Create(CultureInfo.InvariantCulture, $"The circle inside {points} points did not settle."));

    private static double[] Shares(Vector2 a, Vector2 b, Vector2 c, double determinant, Vector2 p) =>
        [(b - p).Cross(c - p) / determinant, (c - p).Cross(a - p) / determinant, (a - p).Cross(b - p) / determinant];

    // Three directions around the center: the first, and the two between which its opposite lies.
    private static int[] Surrounding(Vector2[] u)
    {
        int[] order = [
            .. Enumerable.Range(0, u.Length).OrderBy(
                i => Elementary.Atan2(u[0].Cross(u[i]), u[0].Dot(u[i])) is var angle && angle < 0 ? angle + (2 * Math.PI) : angle)];
        var behind = Array.FindIndex(order, i => u[0].Cross(u[i]) < 0);
        if (behind > 1 && u[order[behind - 1]].Cross(u[order[behind]]) > 0)
        {
            return [0, order[behind - 1], order[behind]];
        }

        var gap = LargestGap(Point2.Origin, [.. u.Select(v => Point2.Origin + v)]).Degrees;
        throw new GeometryException(GeometryError.NotAround, string.Create(
            CultureInfo.InvariantCulture,
            $"The points leave {gap:0.#} degrees of the circle open; inside of points that leave half a turn open no circle is the "
                + $"largest."));
    }

    // Of three contacts r and s in r + u.s = d; of a diameter the radius and the middle.
    private static (Vector2 Center, double Radius) Errors(Vector2[] u, double sigma)
    {
        if (u.Length < 3)
        {
            return (new(sigma / Math.Sqrt(2), sigma / Math.Sqrt(2)), sigma / Math.Sqrt(2));
        }

        var determinant = (u[1] - u[0]).Cross(u[2] - u[0]);
        var shares = Shares(u[0], u[1], u[2], determinant, Vector2.Zero);
        var sides = new[] { u[2] - u[1], u[0] - u[2], u[1] - u[0] };
        return (
            new Vector2(Math.Sqrt(sides.Sum(s => s.Y * s.Y)), Math.Sqrt(sides.Sum(s => s.X * s.X))) * (sigma / Math.Abs(determinant)),
            sigma * Math.Sqrt(shares.Sum(s => s * s)));
    }
}
