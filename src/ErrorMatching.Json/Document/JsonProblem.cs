using System.Globalization;

namespace ErrorMatching.Json;

/// <summary>A problem in a JSON document.</summary>
/// <param name="Code">A stable identifier for scripts, such as <c>unknown-key</c>.</param>
/// <param name="Path">The JSON path of the value, <c>$</c> for the whole document.</param>
/// <param name="Place">The location of the value.</param>
/// <param name="Found">What was found.</param>
/// <param name="Expected">What is expected instead.</param>
/// <param name="Message">A sentence with both.</param>
public sealed record JsonProblem(string Code, string Path, JsonPlace Place, string Found, string Expected, string Message)
{
    /// <summary>Line of the value, from 1.</summary>
    public int Line => Place.Line;

    /// <summary>Column of the value in Unicode characters, from 1.</summary>
    public int Column => Place.Column;

    /// <summary>Creates a problem with a value and a sentence from the finding and the expectation.</summary>
    public static JsonProblem At(JsonItem item, string code, string found, string expected)
    {
        ArgumentNullException.ThrowIfNull(item);
        return new(code, item.Path, item.Place, found, expected, $"found {found}; expected {expected}");
    }

    /// <summary>Line, column, path and sentence: <c>12:5 $.features[1].kind: found text "lime"; expected "line"</c>.</summary>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{Line}:{Column} {Path}: {Message}");
}
