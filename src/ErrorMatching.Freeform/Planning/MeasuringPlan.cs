using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Where and in which order a surface is probed, and what prevents it.</summary>
/// <remarks>Lengths in millimeters, in the work offset of the surface.</remarks>
public sealed record MeasuringPlan
{
    // Calculated on demand: comparing measured points with their plan does not need them.
    private double? _reconstructionErrorMm;
    private ProbeAccess? _access;

    internal MeasuringPlan()
    {
    }

    /// <summary>The nominal finished surface.</summary>
    public required PartSurface Surface { get; init; }

    /// <summary>How the surface is measured.</summary>
    public required JobMeasuring Measuring { get; init; }

    /// <summary>Stock on the nominal surface along its normal during measurement.</summary>
    public required double StockMm { get; init; }

    /// <summary>The points by ascending number: the order of measuring.</summary>
    public required IReadOnlyList<PlanPoint> Points { get; init; }

    /// <summary>Number of curves along u with points.</summary>
    public required int Curves { get; init; }

    /// <summary>Parameters u at which the curvature breaks on most curves along u.</summary>
    public required IReadOnlyList<double> BreaksU { get; init; }

    /// <summary>Parameters v at which the curvature breaks on most curves along v.</summary>
    public required IReadOnlyList<double> BreaksV { get; init; }

    /// <summary>Distance of points from the ends of the surface.</summary>
    public required double RimSetInMm { get; init; }

    /// <summary>Distance of points from trimmed edges; 0 if nothing is trimmed.</summary>
    public required double TrimSetInMm { get; init; }

    /// <summary>Largest distance, along the normal, between the nominal surface and a piecewise cubic surface through the plan's points
    /// alone: what the plan can miss of such a shape.</summary>
    public double ReconstructionErrorMm =>
        _reconstructionErrorMm ??= Points.Count == 0 ? double.NaN : new PlanReconstruction(Surface, Lines).ErrorMm().EverywhereMm;

    /// <summary>Height of the stylus ball's center during travel between points.</summary>
    public double ClearanceZ => Access.ClearanceZ;

    /// <summary>Path length of the ball's center from above the first point to above the last: across at clearance height, down, to the
    /// surface, back and up.</summary>
    public double TravelMm => Access.TravelMm;

    /// <summary>Why the plan cannot be used; empty if every point can be touched.</summary>
    public IReadOnlyList<Refusal> Refusals => Refusal is { } refusal ? [refusal] : Access.Refusals;

    /// <summary>True if every point faces down, as in a job with "outside": "-z". No vertical stylus reaches them, but the plan shows a
    /// machine that measures from below where to measure.</summary>
    public bool FacesDown => Points.Count > 0 && Points.All(p => p.Normal.Z < 0);

    /// <summary>Radius of the stylus ball.</summary>
    public double StylusRadiusMm => Measuring.StylusDiameterMm / 2;

    /// <summary>The ball's center when it touches the expected surface: the nominal one plus stock.</summary>
    public Geometry.Point3 CenterOf(PlanPoint point) => Along(point, StockMm + StylusRadiusMm);

    /// <summary>The ball's center at the start of the measuring move.</summary>
    public Geometry.Point3 ApproachOf(PlanPoint point) => Along(point, StockMm + StylusRadiusMm + Measuring.ApproachMm);

    /// <summary>The ball's center when the measuring move has missed.</summary>
    public Geometry.Point3 OvertravelOf(PlanPoint point) => Along(point, StockMm + StylusRadiusMm - Measuring.OvertravelMm);

    /// <summary>The point on the expected surface: the nominal one plus stock.</summary>
    public Geometry.Point3 ContactOf(PlanPoint point) => Along(point, StockMm);

    /// <summary>What may lie over the nominal surface during measurement; null if only the stock does.</summary>
    internal StageMaterial? Material { get; init; }

    /// <summary>Why there are no points; null if there are points.</summary>
    internal Refusal? Refusal { get; init; }

    /// <summary>The curves with their points, before ordering.</summary>
    internal IReadOnlyList<PlanCurve> Lines { get; init; } = [];

    private ProbeAccess Access => _access ??= new(this);

    /// <summary>Where the measuring move of a point starts, seen from above.</summary>
    internal Geometry.Point2 AboveOf(PlanPoint point)
    {
        var approach = ApproachOf(point);
        return new(approach.X, approach.Y);
    }

    private static Geometry.Point3 Along(PlanPoint point, double distance)
    {
        ArgumentNullException.ThrowIfNull(point);
        return point.Position + (point.Normal * distance);
    }
}

/// <summary>A measured curve along u with its points.</summary>
/// <param name="V">The fixed parameter.</param>
/// <param name="Reason">The reason for the curve.</param>
/// <param name="Nodes">Its points by ascending u.</param>
internal sealed record PlanCurve(double V, PlanReason Reason, IReadOnlyList<(double U, PlanReason Reason)> Nodes);

/// <summary>A planned measuring point on the nominal surface.</summary>
/// <param name="Number">Number of the point, from 1, in the order of measuring.</param>
/// <param name="I">Index of the point along its curve (along u), from 0.</param>
/// <param name="J">Index of its curve (along v), from 0.</param>
/// <param name="U">First parameter.</param>
/// <param name="V">Second parameter.</param>
/// <param name="Position">The point on the nominal finished surface, in millimeters.</param>
/// <param name="Normal">Unit normal out of the material.</param>
/// <param name="Reason">The reason for the point.</param>
public sealed record PlanPoint(int Number, int I, int J, double U, double V, Point3 Position, Vector3 Normal, PlanReason Reason);

/// <summary>The reason for a point of a measuring plan.</summary>
public enum PlanReason
{
    /// <summary>An end of the curve: always measured.</summary>
    End,

    /// <summary>The slope has changed by its share since the previous point.</summary>
    Slope,

    /// <summary>The curvature breaks here.</summary>
    Break,
}
