using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A key point in the report of a match. Points in the part's frame unless it says otherwise.</summary>
public sealed record ReportKeyPoint
{
    /// <summary>Its label.</summary>
    public required string Point { get; init; }

    /// <summary>Name of its feature.</summary>
    public required string Feature { get; init; }

    /// <summary>Where it is designed.</summary>
    public required Point2 Theoretical { get; init; }

    /// <summary>Where it was measured on the part: the contact point, aligned.</summary>
    public required Point2 Actual { get; init; }

    /// <summary>Where it was measured on the counterpart, for compensation from the counterpart; null otherwise.</summary>
    public Point2? Counterpart { get; init; }

    /// <summary>Unit normal of the boundary, from the counterpart's material to its tool.</summary>
    public required Vector2 Normal { get; init; }

    /// <summary>What is added to the program there, in the program's frame; zero where nothing is compensated.</summary>
    public required Vector2 Correction { get; init; }

    /// <summary>The deviation that was decided about, along the normal:
    /// of the part from the theoretical point, or of the part from the counterpart.</summary>
    public required double DecidedMm { get; init; }

    /// <summary>What of it lies beyond the limit.</summary>
    public required double ExcessMm { get; init; }

    /// <summary>What of it the corrected counterpart will leave, by the program as it was written.</summary>
    public required double PredictedMm { get; init; }

    /// <summary>Blocks of the original program that cut the point, by number.</summary>
    public IReadOnlyList<string> Blocks { get; init; } = [];

    /// <summary>Theoretical - actual, as the paper prints it.</summary>
    public Vector2 Deviation => Theoretical - Actual;

    /// <summary>Actual - theoretical along the normal.</summary>
    public double NormalMm => -Deviation.Dot(Normal);
}
