namespace ErrorMatching.Measurement;

/// <summary>What a file of any format says.</summary>
/// <param name="Unit">The unit in the file.</param>
/// <param name="Points">The measured points, in millimeters.</param>
/// <param name="Nominals">The nominal points in the same order; empty if the file has none.</param>
/// <param name="Labels">The location of the labels, for messages about points that are not there.</param>
internal sealed record MeasuredContent(
    LengthUnit Unit, IReadOnlyList<LabelledPoint> Points, IReadOnlyList<LabelledPoint> Nominals, Place Labels)
{
    /// <summary>What the file says about itself, by name.</summary>
    public IReadOnlyList<HeaderField> Fields { get; init; } = [];

    /// <summary>The texts of a column by its name; null if there is no such column.</summary>
    public Func<string, IReadOnlyList<string>?> Texts { get; init; } = _ => null;

    /// <summary>True if the file names no points: they are called 1, 2, 3 in the order of the file.</summary>
    public bool IsByOrder { get; init; }

    /// <summary>True if the number at the end of a label names its point, too: P1 is also called 1.</summary>
    public bool HasNumbers { get; init; }

    /// <summary>True if the points are contacts whatever the job says of its gauge, because the file has the radius of the ball.</summary>
    public bool IsContact { get; init; }

    /// <summary>The number of the plan that the points were touched by; null if the file names none.</summary>
    public string? Plan { get; init; }

    /// <summary>Lines of the points that are centers of the ball, in a file that says of each whether it is one; otherwise
    /// null.</summary>
    public IReadOnlySet<int>? Centers { get; init; }

    /// <summary>Points that lack a coordinate: the first one they lack, and where they are.</summary>
    public IReadOnlyList<(string Label, char Axis, Place Place)> Incomplete { get; init; } = [];
}
