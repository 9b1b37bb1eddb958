using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>The tool that a program calls: its number or its name, and where its length is stored.</summary>
/// <param name="Number">Number of the tool; null if it is called by its name.</param>
/// <param name="Name">
/// Name of the tool, on controls that know names; null if it is called by its number. Plain letters, digits, spaces and <c>_ - . + / #</c>.
/// </param>
/// <param name="LengthOffset">Number of the length offset: H, on Siemens controls the cutting edge D.</param>
public sealed record ToolCall(int? Number, string? Name, int LengthOffset)
{
    /// <summary>Most characters of a name (840D: 32).</summary>
    internal const int MostCharacters = 32;

    // Nothing in a name may end the text that it stands in, or begin a comment or a block.
    internal static bool IsName(string name) => name.Trim() == name && name.Length is > 0 and <= MostCharacters
        && name.All(c => char.IsAsciiLetterOrDigit(c) || c is ' ' or '_' or '-' or '.' or '+' or '/' or '#');

    /// <summary>What a place of a template stands for.</summary>
    /// <exception cref="FreeformException">The tool has no such thing (<c>bad-template</c>).</exception>
    internal string ValueOf(string place, string template) => place switch
    {
        "tool.number" when Number is { } number => number.ToString(CultureInfo.InvariantCulture),
        "tool.name" when Name is { } name => name,
        "tool.offset" => LengthOffset.ToString(CultureInfo.InvariantCulture),
        _ => throw new FreeformException(
            "bad-template", template, $"it asks for {{{place}}}, but the job calls its tool by its {(Name is null ? "number" : "name")}."),
    };
}
