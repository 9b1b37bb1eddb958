using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A feature in the report of a match.</summary>
public sealed record ReportFeature
{
    /// <summary>Its name.</summary>
    public required string Name { get; init; }

    /// <summary>Its kind.</summary>
    public required FeatureKind Kind { get; init; }

    /// <summary>The limits of its normal deviation, and their source.</summary>
    public required JobTolerance Tolerance { get; init; }

    /// <summary>Its lengths and angles.</summary>
    public required IReadOnlyList<ReportQuantity> Quantities { get; init; }

    /// <summary>The decision on it.</summary>
    public required Decision Decision { get; init; }

    /// <summary>The signed normal deviation with the largest magnitude among its points.</summary>
    public required double LargestMm { get; init; }

    /// <summary>Combined standard uncertainty of a normal deviation.</summary>
    public required double UncertaintyMm { get; init; }

    /// <summary>Residuals of the fit to the measured points, in the order of the points.</summary>
    public IReadOnlyList<double> ResidualsMm { get; init; } = [];

    /// <summary>The fit of a curve; null for straight features and curves without a fit.</summary>
    public ReportCurve? Curve { get; init; }

    /// <summary>The boundary that the new program cuts as a polyline in the part's frame, for drawing.</summary>
    public IReadOnlyList<Point2> CorrectedOutline { get; init; } = [];

    /// <summary>The boundary that the original program cuts as a polyline in the part's frame, for drawing.</summary>
    public IReadOnlyList<Point2> TheoreticalOutline { get; init; } = [];

    /// <summary>The measured boundary as a polyline in the part's frame, for drawing.</summary>
    public IReadOnlyList<Point2> ActualOutline { get; init; } = [];

    /// <summary>Largest distance of its measured points from its plane, without sign; null if the files have no third
    /// coordinate.</summary>
    public double? StandsOutMm { get; init; }
}
