namespace ErrorMatching.Jobs;

/// <summary>The gauge's file format and accuracy, as typed. An empty field means the job's default.</summary>
public sealed record GaugeDraft
{
    /// <summary>Name of its file format; empty if <see cref="FormatJson"/> describes one.</summary>
    public string Format { get; init; } = "points";

    /// <summary>Description of a format, as in the job; empty if <see cref="Format"/> names one.</summary>
    public string FormatJson { get; init; } = "";

    /// <summary>The rule or the order of its labels, as JSON in the job; empty if its files have the labels of the job.</summary>
    public string LabelsJson { get; init; } = "";

    /// <summary>Standard uncertainty of a coordinate, mm, if there are no <see cref="Contributions"/>.</summary>
    public string Uncertainty { get; init; } = "";

    /// <summary>The contributions to the uncertainty, combined by root sum of squares.</summary>
    public IReadOnlyList<ContributionDraft> Contributions { get; init; } = [];

    /// <summary>True if the gauge is accepted although its expanded uncertainty exceeds a tolerance.</summary>
    public bool AcceptsCoarse { get; init; }

    /// <summary><c>contact</c> or <c>stylus-center</c>.</summary>
    public string Reports { get; init; } = "contact";

    /// <summary>Diameter of the stylus ball, mm.</summary>
    public string StylusDiameter { get; init; } = "";

    /// <summary>Probing speed, mm/s, for the measuring time in the report.</summary>
    public string ProbingSpeed { get; init; } = "";

    /// <summary>Probing distance at a point, mm.</summary>
    public string ProbingDistance { get; init; } = "";

    /// <summary>Calculation time, s.</summary>
    public string Calculating { get; init; } = "";

    /// <summary>Number of points that the gauge touches, if it is not the number of key points.</summary>
    public string Touches { get; init; } = "";
}

/// <summary>A named contribution to the gauge's uncertainty, as typed.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Value">Its standard uncertainty, mm.</param>
public sealed record ContributionDraft(string Name = "", string Value = "");
