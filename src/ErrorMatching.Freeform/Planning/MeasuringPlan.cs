namespace ErrorMatching.Freeform;

/// <summary>Where a surface is touched, in which order, and what stands in the way.</summary>
/// <remarks>Lengths in millimetres, in the work offset of the surface.</remarks>
public sealed record MeasuringPlan
{
    // Found once they are asked for: who only compares measured points with their plan does not wait for them.
    private double? _reconstructionErrorMm;
    private ProbeAccess? _access;

    internal MeasuringPlan()
    {
    }

    /// <summary>The nominal finished surface.</summary>
    public required PartSurface Surface { get; init; }

    /// <summary>How it is measured.</summary>
    public required JobMeasuring Measuring { get; init; }

    /// <summary>What lies on the nominal surface along its normal when it is measured.</summary>
    public required double StockMm { get; init; }

    /// <summary>The points by rising number: the order of measuring.</summary>
    public required IReadOnlyList<PlanPoint> Points { get; init; }

    /// <summary>Number of curves along u that the points lie on.</summary>
    public required int Curves { get; init; }

    /// <summary>Parameters u at which the curvature of the surface breaks on most of its curves along u.</summary>
    public required IReadOnlyList<double> BreaksU { get; init; }

    /// <summary>Parameters v at which the curvature of the surface breaks on most of its curves along v.</summary>
    public required IReadOnlyList<double> BreaksV { get; init; }

    /// <summary>How far points stay from the ends of the surface.</summary>
    public required double RimSetInMm { get; init; }

    /// <summary>How far points stay from trimmed edges; 0 where nothing is trimmed.</summary>
    public required double TrimSetInMm { get; init; }

    /// <summary>Largest distance of the nominal surface from a piecewise cubic surface through the plan's points alone, along the normal: what the plan can miss of a shape like the nominal one.</summary>
    public double ReconstructionErrorMm => _reconstructionErrorMm ??= Points.Count == 0 ? double.NaN : new PlanReconstruction(Surface, Lines).ErrorMm().EverywhereMm;

    /// <summary>Height of the stylus ball's center in travel between points.</summary>
    public double ClearanceZ => Access.ClearanceZ;

    /// <summary>Length of the way of the ball's center from over the first point to over the last: across at clearance height, down, to the surface, back and up.</summary>
    public double TravelMm => Access.TravelMm;

    /// <summary>What keeps the plan from being used; empty where every point can be touched.</summary>
    public IReadOnlyList<FreeformRefusal> Refusals => Refusal is { } refusal ? [refusal] : Access.Refusals;

    /// <summary>True if every point faces down, as those of a job with "outside": "-z" do: no vertical stylus touches them, but the plan says where a machine measures that reaches them from below.</summary>
    public bool FacesDown => Points.Count > 0 && Points.All(p => p.Normal.Z < 0);

    /// <summary>Radius of the stylus ball.</summary>
    public double StylusRadiusMm => Measuring.StylusDiameterMm / 2;

    /// <summary>Where the ball's center is when it touches the surface that is expected: the nominal one with its stock.</summary>
    public Geometry.Point3 CenterOf(PlanPoint point) => Along(point, StockMm + StylusRadiusMm);

    /// <summary>Where the ball's center is when the measuring move begins.</summary>
    public Geometry.Point3 ApproachOf(PlanPoint point) => Along(point, StockMm + StylusRadiusMm + Measuring.ApproachMm);

    /// <summary>Where the ball's center is when the measuring move has found nothing.</summary>
    public Geometry.Point3 OvertravelOf(PlanPoint point) => Along(point, StockMm + StylusRadiusMm - Measuring.OvertravelMm);

    /// <summary>The point of the surface that is expected: the nominal one with its stock.</summary>
    public Geometry.Point3 ContactOf(PlanPoint point) => Along(point, StockMm);

    /// <summary>Why there are no points; null if there are.</summary>
    internal FreeformRefusal? Refusal { get; init; }

    /// <summary>The curves with their points, before they were put in order.</summary>
    internal IReadOnlyList<PlanCurve> Lines { get; init; } = [];

    private ProbeAccess Access => _access ??= new(this);

    /// <summary>Where the measuring move of a point begins, seen from above.</summary>
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
