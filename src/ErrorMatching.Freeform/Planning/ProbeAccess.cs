using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Checks whether a stylus reaches the points on a three-axis machine. Its ball and shank, a vertical cylinder as thick as the
/// ball, are tested against the whole surface with its stock.</summary>
/// <remarks>The check covers the travel over the highest place, the straight descent from clearance height to the start of the measuring
/// move (swept by the cylinder), and the measuring move. It is based on bounds for the whole surface, not on samples. A place closer to
/// the ball's center than its radius and the stock by more than a micrometer is a collision.</remarks>
internal sealed class ProbeAccess
{
    private const double ToleranceMm = 0.001;

    private readonly MeasuringPlan _plan;
    private readonly PatchTree _tree;

    public ProbeAccess(MeasuringPlan plan)
    {
        var (measuring, radius, points) = (plan.Measuring, plan.StylusRadiusMm, plan.Points);
        (_plan, _tree) = (plan, new(plan.Surface));
        if (points.Count == 0)
        {
            return;
        }

        ClearanceZ = Math.Max(
            _tree.HighestMm + plan.StockMm + measuring.ClearanceMm + radius, points.Max(p => plan.ApproachOf(p).Z));
        for (var k = 0; k < points.Count; k++)
        {
            var upAndDown = ClearanceZ - plan.ApproachOf(points[k]).Z + measuring.ApproachMm;
            TravelMm += (2 * upAndDown) + (k > 0 ? plan.AboveOf(points[k - 1]).DistanceTo(plan.AboveOf(points[k])) : 0);
        }

        Refusals = [.. ((Refusal?[])[Travel(), Approach(), .. points.Select(Refusal)]).OfType<Refusal>()];
    }

    /// <summary>See <see cref="MeasuringPlan.ClearanceZ"/>.</summary>
    public double ClearanceZ { get; } = double.NaN;

    /// <summary>See <see cref="MeasuringPlan.TravelMm"/>.</summary>
    public double TravelMm { get; }

    /// <summary>Why points cannot be touched.</summary>
    public IReadOnlyList<Refusal> Refusals { get; } = [];

    // What may lie over the stock that is expected.
    private double LeastMm => _plan.Material is { } material ? material.Mm - _plan.StockMm : 0;

    private Refusal? Travel() => TooNear(
        "clearance-too-low", "clearanceMm", _plan.Measuring.ClearanceMm, $"Over the highest place, {PlaceText.Words(_tree.HighestPlace)}");

    private Refusal? Approach() => TooNear(
        "approach-too-short",
        "approachMm",
        _plan.Measuring.ApproachMm,
        $"On the fast way down, at point {_plan.Points[0].Number} at {PlaceText.Words(_plan.Points[0].Position)} as at all others");

    private Refusal? TooNear(string code, string key, double mm, string where)
    {
        if (mm >= LeastMm - 1e-9)
        {
            return null;
        }

        var from = _plan.StockMm > 0 ? $" over the {StageMaterial.Text(_plan.StockMm)} mm of stock" : "";
        return new(
            code,
            $"measuring.{key} is {PlaceText.Mm(mm, 4)} mm. Up to {StageMaterial.Text(_plan.Material!.Mm)} mm of material may lie over the "
                + $"surface: {_plan.Material.Words}. {where}, the ball would be {StageMaterial.Text(LeastMm - mm)} mm too low. Write at "
                + $"least {StageMaterial.Text(LeastMm)}{from}.",
            new() { Path = "$.measuring." + key });
    }

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
        if (Meets(approach, approach with { Z = ClearanceZ }, point) is { } below)
        {
            return Collision("on the way down from clearance height", below);
        }

        if (Meets(approach, center, point) is { } at)
        {
            return Collision("on the measuring move", at);
        }

        return null;
    }

    // The place of the surface that is deepest in the ball, or in the cylinder above it if the way leads up.
    private Point3? Meets(Point3 from, Point3 to, PlanPoint point) =>
        _tree.PlaceNearer(from, to, point.Normal, _plan.StylusRadiusMm + _plan.StockMm - ToleranceMm);

    private static string Collision(string when, Point3 at) =>
        $"{when} the stylus meets the surface at {PlaceText.Words(at)}. Use a thinner stylus, another approachMm, or leave this part of "
            + $"the surface out.";
}
