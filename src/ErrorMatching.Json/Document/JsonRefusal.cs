using ErrorMatching.Refusals;

namespace ErrorMatching.Json;

/// <summary>Makes refusals about values of JSON documents.</summary>
public static class JsonRefusal
{
    /// <summary>A refusal of the form "found ...; expected ..." about a value, with its JSON path, line and column.</summary>
    public static Refusal At(JsonItem item, string code, string found, string expected) =>
        Refusal.Of(code, found, expected, PlaceOf(item));

    /// <summary>A refusal of the form "found ...; expected ..." about a place of a document.</summary>
    public static Refusal At(JsonPlace place, string path, string code, string found, string expected) =>
        Refusal.Of(code, found, expected, new() { Line = place.Line, Column = place.Column, Path = path });

    /// <summary>Line, column and JSON path of a value.</summary>
    /// <param name="item">The value.</param>
    /// <param name="inside">Path inside the value, as if it were a document of its own, such as <c>$.columns.x</c>; null for the
    /// value.</param>
    public static InputPlace PlaceOf(JsonItem item, string? inside = null)
    {
        ArgumentNullException.ThrowIfNull(item);
        return new() { Line = item.Place.Line, Column = item.Place.Column, Path = item.Path + inside?[1..] };
    }
}
