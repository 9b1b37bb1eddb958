namespace ErrorMatching.Jobs;

/// <summary>One error. Properties that do not apply are null.</summary>
/// <param name="Code">Stable code, listed in docs/reference-console.md.</param>
/// <param name="Message">A sentence with the place, what was found and what is expected.</param>
public sealed record ErrorItem(string Code, string Message)
{
    /// <summary>The file as the user named it.</summary>
    public string? File { get; init; }

    /// <summary>Line of the file, from 1.</summary>
    public int? Line { get; init; }

    /// <summary>Cell or character of the line, from 1.</summary>
    public int? Column { get; init; }

    /// <summary>Place in a JSON file, such as <c>$.features[2].points</c>.</summary>
    public string? Path { get; init; }

    /// <summary>Block of an NC program as written, such as <c>N110</c>.</summary>
    public string? Block { get; init; }

    /// <summary>The message without the place, for text output that puts the place first; null if the message has no place.</summary>
    public string? Problem { get; init; }
}
