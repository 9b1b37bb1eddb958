namespace ErrorMatching.Freeform;

/// <summary>What a kind of template may hold: the one for probing programs, and the one for programs that cut.</summary>
internal sealed record TemplateGrammar
{
    /// <summary>Condition: the job names the tool that the program is for.</summary>
    public const string Tool = "tool";

    /// <summary>Condition: it names it by name, not by number.</summary>
    public const string ToolByName = "tool-by-name";

    /// <summary>Places of the tool, which have a value only where the job names one.</summary>
    public static readonly string[] ToolPlaces = ["tool.number", "tool.name", "tool.offset"];

    /// <summary>What the built-in ones are called among the resources, behind their names.</summary>
    public required string Extension { get; init; }

    /// <summary>The key of the job under which a shop names its own.</summary>
    public required string Under { get; init; }

    /// <summary>Names of the built-in ones.</summary>
    public required IReadOnlyList<string> BuiltIn { get; init; }

    /// <summary>Names of the sections.</summary>
    public required IReadOnlyList<string> Sections { get; init; }

    /// <summary>The section that must not be missing.</summary>
    public required string Needed { get; init; }

    /// <summary>What stands in it, for messages.</summary>
    public required string NeededHint { get; init; }

    /// <summary>Places for values of the program, those of the tool included.</summary>
    public required IReadOnlyList<string> Places { get; init; }

    /// <summary>Places for values of a point; none where there is no loop over points.</summary>
    public IReadOnlyList<string> PointPlaces { get; init; } = [];

    /// <summary>Conditions of the program.</summary>
    public required IReadOnlyList<string> Conditions { get; init; }

    /// <summary>Conditions of a point.</summary>
    public IReadOnlyList<string> PointConditions { get; init; } = [];

    /// <summary>True if there is a loop over points.</summary>
    public bool HasPoints => PointPlaces.Count > 0;
}
