namespace ErrorMatching.Freeform;

/// <summary>How a surface is probed on the machine, and what its files hold.</summary>
public sealed record JobMeasuring
{
    /// <summary>Number of curves along u that are probed; null if <see cref="ReconstructionErrorMm"/> decides.</summary>
    public int? Curves { get; init; }

    /// <summary>Points on each curve; null if <see cref="Points"/> or <see cref="ReconstructionErrorMm"/> decides.</summary>
    public int? PointsPerCurve { get; init; }

    /// <summary>Points on all curves together, spread by slope, so that curves may have different numbers; null if <see cref="PointsPerCurve"/> says it.</summary>
    public int? Points { get; init; }

    /// <summary>As many points as it takes to know the nominal surface to this distance from the points alone; null if the counts are given.</summary>
    public double? ReconstructionErrorMm { get; init; }

    /// <summary>Diameter of the stylus ball.</summary>
    public required double StylusDiameterMm { get; init; }

    /// <summary>Distance from the surface along the normal at which the measuring move begins.</summary>
    public required double ApproachMm { get; init; }

    /// <summary>How far past the expected surface the measuring move may go before it is a miss.</summary>
    public required double OvertravelMm { get; init; }

    /// <summary>Height over the highest point of the surface at which the probe travels.</summary>
    public required double ClearanceMm { get; init; }

    /// <summary>Feed of the measuring move.</summary>
    public required double FeedMmPerMin { get; init; }

    /// <summary>Dialect of the probing program.</summary>
    public required string Dialect { get; init; }

    /// <summary>The shop's own template of the probing program, relative to the job; null for the dialect's.</summary>
    public string? Template { get; init; }

    /// <summary>The probe as the control calls it; null if the template says how it comes into the spindle.</summary>
    public ToolCall? Tool { get; init; }

    /// <summary>The program that cut the measured piece, relative to the job; null if the job does not say.</summary>
    public string? CutBy { get; init; }

    /// <summary>True if files hold centers of the stylus ball, false if they hold points of contact.</summary>
    public required bool ReportsStylusCenter { get; init; }

    /// <summary>After which stage the surface is measured: its stock lies on the surface.</summary>
    public required CuttingStage After { get; init; }

    /// <summary>Standard uncertainty of one measured point along the normal.</summary>
    public required double UncertaintyMm { get; init; }

    /// <summary>True if measured points are laid onto the surface by a rigid best fit before they are compared; false if they stay where they were measured.</summary>
    public required bool BestFit { get; init; }
}
