namespace ErrorMatching.Freeform;

/// <summary>What a kind of template may contain. There is one kind for probing programs and one for cutting programs.</summary>
internal sealed record TemplateGrammar
{
    /// <summary>Condition: the job names the tool.</summary>
    public const string Tool = "tool";

    /// <summary>Condition: the job names the tool by name, not by number.</summary>
    public const string ToolByName = "tool-by-name";

    /// <summary>Condition: the job has the number of an order.</summary>
    public const string Order = "order";

    /// <summary>Placeholders of the tool, which have a value only if the job names one.</summary>
    public static readonly string[] ToolPlaces = ["tool.number", "tool.name", "tool.offset"];

    /// <summary>Ending of the built-in templates' resource names.</summary>
    public required string Extension { get; init; }

    /// <summary>The key of the job that names a shop's own template.</summary>
    public required string Under { get; init; }

    /// <summary>Names of the built-in templates.</summary>
    public required IReadOnlyList<string> BuiltIn { get; init; }

    public required IReadOnlyList<string> Sections { get; init; }

    public required string Needed { get; init; }

    /// <summary>The content of the required section, for messages.</summary>
    public required string NeededHint { get; init; }

    /// <summary>Placeholders of the program, including those of the tool.</summary>
    public required IReadOnlyList<string> Places { get; init; }

    /// <summary>Placeholders of a point; none if there is no loop over points.</summary>
    public IReadOnlyList<string> PointPlaces { get; init; } = [];

    public required IReadOnlyList<string> Conditions { get; init; }

    public IReadOnlyList<string> PointConditions { get; init; } = [];

    /// <summary>The section of a file beside the program; null if there is none.</summary>
    public string? Beside { get; init; }

    /// <summary>True if there is a loop over points.</summary>
    public bool HasPoints => PointPlaces.Count > 0;
}
