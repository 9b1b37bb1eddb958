using System.Globalization;

namespace ErrorMatching.Refusals;

/// <summary>Where an input is at fault. Properties that do not apply are null.</summary>
public sealed record InputPlace
{
    /// <summary>No place: the whole of the inputs.</summary>
    public static InputPlace None { get; } = new();

    /// <summary>The file as the user named it.</summary>
    public string? File { get; init; }

    /// <summary>Line of the file, from 1.</summary>
    public int? Line { get; init; }

    /// <summary>Cell or character of the line, from 1.</summary>
    public int? Column { get; init; }

    /// <summary>Place in a JSON file, such as <c>$.features[2].points</c>.</summary>
    public string? Path { get; init; }

    /// <summary>Block of an NC program as the setter knows it, such as <c>N110</c> or <c>line 12</c>.</summary>
    public string? Block { get; init; }

    /// <summary>Name of the job's feature.</summary>
    public string? Feature { get; init; }

    /// <summary>Label of the key point.</summary>
    public string? Point { get; init; }

    /// <summary>File, line, column and path in words; empty if none applies.</summary>
    public override string ToString()
    {
        string?[] parts = [
            File,
            Line is { } line ? string.Create(CultureInfo.InvariantCulture, $"line {line}") : null,
            Column is { } column ? string.Create(CultureInfo.InvariantCulture, $"column {column}") : null,
            Path];
        return string.Join(", ", parts.Where(p => p is not null));
    }
}
