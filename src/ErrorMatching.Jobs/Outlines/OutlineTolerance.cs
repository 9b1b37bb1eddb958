namespace ErrorMatching.Jobs;

/// <summary>A dimension or tolerance of a model, and to what it led in a job.</summary>
/// <param name="Name">Its name; empty if the model has none for it.</param>
/// <param name="Entity">What it is in the file: <c>#26 SURFACE_PROFILE_TOLERANCE</c>.</param>
/// <param name="Line">The line in the file.</param>
/// <param name="Kind">Its kind: <c>surface-profile</c>, <c>position</c>, <c>size</c>, <c>location</c>, <c>flatness</c>.</param>
public sealed record OutlineTolerance(string Name, string Entity, int Line, string Kind)
{
    /// <summary>It states the limits of features as they are in the job.</summary>
    public const string Limits = "limits";

    /// <summary>Features have limits that fulfil it, and more than it demands.</summary>
    public const string StricterLimits = "stricter-limits";

    /// <summary>The job has nothing of it; somebody has to decide.</summary>
    public const string Asked = "asked";

    /// <summary>The nominal value of a dimension, or the width of a tolerance's zone, mm; null for angles, or if not read.</summary>
    public double? ValueMm { get; init; }

    /// <summary>The same of an angle, degrees.</summary>
    public double? ValueDegrees { get; init; }

    /// <summary>The lower limit of a dimension as a deviation from its value, mm or degrees; null if the model states none.</summary>
    public double? Lower { get; init; }

    /// <summary>The upper limit.</summary>
    public double? Upper { get; init; }

    /// <summary>Millimeters in the unit of its lengths in the file; null if it has none.</summary>
    public double? UnitMm { get; init; }

    /// <summary>Its datums in order.</summary>
    public IReadOnlyList<string> Datums { get; init; } = [];

    /// <summary>The faces that it is of: <c>#45</c>.</summary>
    public IReadOnlyList<string> Faces { get; init; } = [];

    /// <summary><see cref="Limits"/>, <see cref="StricterLimits"/> or <see cref="Asked"/>.</summary>
    public required string Became { get; init; }

    /// <summary>The names of the features whose limits it gave.</summary>
    public IReadOnlyList<string> Features { get; init; } = [];

    /// <summary>Why, in one sentence or more.</summary>
    public required string Reason { get; init; }
}
