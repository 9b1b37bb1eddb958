namespace ErrorMatching.Jobs;

/// <summary>What the gauge writes and how well it measures, as it is being typed. What is empty is the job's default.</summary>
public sealed record GaugeDraft
{
    /// <summary>Name of the format of its files; empty where <see cref="FormatJson"/> describes one.</summary>
    public string Format { get; init; } = "points";

    /// <summary>The description of a format as the job has it; empty where <see cref="Format"/> names one.</summary>
    public string FormatJson { get; init; } = "";

    /// <summary>Standard uncertainty of a coordinate, mm, where <see cref="Contributions"/> are none.</summary>
    public string Uncertainty { get; init; } = "";

    /// <summary>The contributions to the uncertainty, which are combined by root sum of squares.</summary>
    public IReadOnlyList<ContributionDraft> Contributions { get; init; } = [];

    /// <summary><c>contact</c> or <c>stylus-center</c>.</summary>
    public string Reports { get; init; } = "contact";

    /// <summary>Diameter of the stylus ball, mm.</summary>
    public string StylusDiameter { get; init; } = "";

    /// <summary>Speed of probing, mm/s, by which the report states the time of measuring.</summary>
    public string ProbingSpeed { get; init; } = "";

    /// <summary>Way of probing at a point, mm.</summary>
    public string ProbingDistance { get; init; } = "";

    /// <summary>Time of calculating, s.</summary>
    public string Calculating { get; init; } = "";

    /// <summary>How many points the gauge touches, where that is not the number of key points.</summary>
    public string Touches { get; init; } = "";
}
