using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The tool that a program calls, by number or name, and its length offset.</summary>
/// <param name="Number">Number of the tool; null if it is called by name.</param>
/// <param name="Name">Name of the tool, for controls with tool names; null if it is called by number. Letters, digits, spaces and <c>_ - .
/// + / #</c>.</param>
/// <param name="LengthOffset">Number of the length offset: H, or the cutting edge D on Siemens controls.</param>
public sealed record ToolCall(int? Number, string? Name, int LengthOffset)
{
    /// <summary>Maximum length of a name (840D: 32).</summary>
    internal const int MostCharacters = 32;

    // A name must not end its surrounding text, or start a comment or a block.
    internal static bool IsName(string name) => name.Trim() == name && name.Length is > 0 and <= MostCharacters
        && name.All(c => char.IsAsciiLetterOrDigit(c) || c is ' ' or '_' or '-' or '.' or '+' or '/' or '#');

    /// <summary>The value of a template's placeholder.</summary>
    /// <exception cref="InputException">The tool has no such value (<c>bad-template</c>).</exception>
    internal string ValueOf(string place, string template) => place switch
    {
        "tool.number" when Number is { } number => number.ToString(CultureInfo.InvariantCulture),
        "tool.name" when Name is { } name => name,
        "tool.offset" => LengthOffset.ToString(CultureInfo.InvariantCulture),
        _ => throw InputException.At(
            "bad-template", template, $"it asks for {{{place}}}, but the job calls its tool by its {(Name is null ? "number" : "name")}."),
    };
}
