using ErrorMatching.Measurement;

namespace ErrorMatching.Freeform;

/// <summary>How a surface is probed on the machine, and the content of the measured files.</summary>
public sealed record JobMeasuring
{
    /// <summary>Number of probed curves along u; null if <see cref="ReconstructionErrorMm"/> determines it.</summary>
    public int? Curves { get; init; }

    /// <summary>Points on each curve; null if <see cref="Points"/> or <see cref="ReconstructionErrorMm"/> determines it.</summary>
    public int? PointsPerCurve { get; init; }

    /// <summary>Points on all curves together, distributed by slope, so that curves may have different numbers; null if
    /// <see cref="PointsPerCurve"/> is given.</summary>
    public int? Points { get; init; }

    /// <summary>Largest error of the nominal surface reconstructed from the points alone, which determines their number; null if the
    /// counts are given.</summary>
    public double? ReconstructionErrorMm { get; init; }

    /// <summary>Diameter of the stylus ball.</summary>
    public required double StylusDiameterMm { get; init; }

    /// <summary>Distance from the surface along the normal at which the measuring move starts.</summary>
    public required double ApproachMm { get; init; }

    /// <summary>How far the measuring move continues beyond the expected surface before it counts as a miss.</summary>
    public required double OvertravelMm { get; init; }

    /// <summary>Travel height of the probe above the highest point of the surface.</summary>
    public required double ClearanceMm { get; init; }

    /// <summary>Feed of the measuring move.</summary>
    public required double FeedMmPerMin { get; init; }

    /// <summary>Dialect of the probing program.</summary>
    public required string Dialect { get; init; }

    /// <summary>The shop's own template of the probing program, relative to the job; null for the dialect's.</summary>
    public string? Template { get; init; }

    /// <summary>How the control calls the probe; null if the template loads it into the spindle.</summary>
    public ToolCall? Tool { get; init; }

    /// <summary>The program that cut the measured piece, relative to the job; null if not given.</summary>
    public string? CutBy { get; init; }

    /// <summary>True if files contain centers of the stylus ball, false if they contain points of contact.</summary>
    public required bool ReportsStylusCenter { get; init; }

    /// <summary>The format of files with measured points.</summary>
    public MeasurementFormat Format { get; init; } = MeasurementFormat.Recognized;

    /// <summary>The stage after which the surface is measured. Its stock is on the surface.</summary>
    public required CuttingStage After { get; init; }

    /// <summary>Standard uncertainty of one measured point along the normal.</summary>
    public required double UncertaintyMm { get; init; }

    /// <summary>Numbers of points that somebody took out, because their reading is wrong: a compensation does not count them.</summary>
    public IReadOnlyList<int> Without { get; init; } = [];

    /// <summary>True if measured points are aligned to the surface by a rigid best fit before the comparison.</summary>
    public required bool BestFit { get; init; }
}
