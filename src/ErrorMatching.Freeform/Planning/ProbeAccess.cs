using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Checks whether a stylus reaches the points on a three-axis machine. Its ball and shank, a vertical cylinder as thick as the
/// ball, are tested against the whole surface with its stock.</summary>
/// <remarks>The check covers the straight descent from clearance height to the start of the measuring move (swept by the cylinder), and
/// the measuring move in steps. The surface is a cloud of points a quarter of the ball's radius apart. A point closer to the ball's center
/// than its radius by more than a micrometer is a collision.</remarks>
internal sealed class ProbeAccess
{
    private const double ToleranceMm = 0.001;
    private const int Steps = 8;

    private readonly MeasuringPlan _plan;
    private readonly SurfaceCloud _cloud;

    public ProbeAccess(MeasuringPlan plan)
    {
        var (radius, points) = (plan.StylusRadiusMm, plan.Points);
        (_plan, _cloud) = (plan, new(plan.Surface, plan.StockMm, radius / 4, radius));
        if (points.Count == 0)
        {
            return;
        }

        ClearanceZ = Math.Max(_cloud.Top + plan.Measuring.ClearanceMm + radius, points.Max(p => plan.ApproachOf(p).Z));
        for (var k = 0; k < points.Count; k++)
        {
            var upAndDown = ClearanceZ - plan.ApproachOf(points[k]).Z + plan.Measuring.ApproachMm;
            TravelMm += (2 * upAndDown) + (k > 0 ? plan.AboveOf(points[k - 1]).DistanceTo(plan.AboveOf(points[k])) : 0);
        }

        Refusals = [.. points.Select(Refusal).OfType<Refusal>()];
    }

    /// <summary>See <see cref="MeasuringPlan.ClearanceZ"/>.</summary>
    public double ClearanceZ { get; } = double.NaN;

    /// <summary>See <see cref="MeasuringPlan.TravelMm"/>.</summary>
    public double TravelMm { get; }

    /// <summary>Why points cannot be touched.</summary>
    public IReadOnlyList<Refusal> Refusals { get; } = [];

    private Refusal? Refusal(PlanPoint point) => Reason(point) is { } reason
        ? new(
            "untouchable-point",
            string.Create(
                CultureInfo.InvariantCulture,
                $"point {point.Number} (i {point.I}, j {point.J}) at {PlaceText.Words(point.Position)} cannot be touched: {reason}"))
        : null;

    private string? Reason(PlanPoint point)
    {
        if (point.Normal.Z < -ToleranceMm)
        {
            return "its normal points down, where a vertical stylus does not reach. Turn the piece, or leave this part of the surface out.";
        }

        var surface = _plan.Surface.Spline.At(point.U, point.V);
        var (largest, smallest) = surface.PrincipalCurvatures;
        var hollow = Math.Max(largest * _plan.Surface.Outside, smallest * _plan.Surface.Outside);
        var reach = _plan.StylusRadiusMm + _plan.StockMm;
        if (hollow * reach > 1)
        {
            return string.Create(
                CultureInfo.InvariantCulture,
                $"the hollow there has a radius of {1 / hollow:0.###} mm, less than the {reach:0.###} mm of ball and stock. Use a "
                    + $"smaller ball.");
        }

        var (approach, center) = (_plan.ApproachOf(point), _plan.CenterOf(point));
        if (Meets(approach) is { } below)
        {
            return Collision("on the way down from clearance height", below);
        }

        for (var i = 1; i <= Steps; i++)
        {
            if (Meets(approach + ((center - approach) * ((double)i / Steps))) is { } at)
            {
                return Collision(i == Steps ? "at contact" : "on the measuring move", at);
            }
        }

        return null;
    }

    // The deepest surface point inside the ball or the cylinder above it.
    private Point3? Meets(Point3 center)
    {
        var radius = _plan.StylusRadiusMm;
        var (deepest, depth) = ((Point3?)null, ToleranceMm);
        foreach (var point in _cloud.Near(center.X, center.Y))
        {
            var (x, y, z) = (point.X - center.X, point.Y - center.Y, Math.Min(0, point.Z - center.Z));
            var inside = radius - Math.Sqrt((x * x) + (y * y) + (z * z));
            (deepest, depth) = inside > depth ? (point, inside) : (deepest, depth);
        }

        return deepest;
    }

    private static string Collision(string when, Point3 at) =>
        $"{when} the stylus meets the surface at {PlaceText.Words(at)}. Use a thinner stylus, another approachMm, or leave this part of "
            + $"the surface out.";
}
