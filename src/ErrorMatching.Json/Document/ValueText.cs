using System.Globalization;

namespace ErrorMatching.Json;

/// <summary>Describes values and types in words.</summary>
internal static class ValueText
{
    private const int Longest = 40;

    public static string Of(JsonItem item) => item.Kind switch
    {
        JsonItemKind.Text => $"the text \"{Short(item.Text)}\"",
        JsonItemKind.Number => $"the number {Short(item.Text)}",
        JsonItemKind.Boolean => item.Flag ? "true" : "false",
        JsonItemKind.List =>
            item.Items.Count == 0 ? "an empty list" : string.Create(CultureInfo.InvariantCulture, $"a list of {item.Items.Count}"),
        JsonItemKind.Object => "an object",
        _ => "null",
    };

    public static string Of(JsonItemKind kind) => kind switch
    {
        JsonItemKind.Text => "text",
        JsonItemKind.Number => "a number",
        JsonItemKind.Boolean => "true or false",
        JsonItemKind.List => "a list",
        JsonItemKind.Object => "an object",
        _ => "null",
    };

    public static string OfType(string type) => type switch
    {
        "string" => "text",
        "number" => "a number",
        "integer" => "a whole number",
        "boolean" => "true or false",
        "array" => "a list",
        "object" => "an object",
        _ => "null",
    };

    /// <summary>A value as in JSON.</summary>
    public static string Literal(JsonItem item) => item.Kind == JsonItemKind.Text ? $"\"{item.Text}\"" : item.ToJson();

    public static string Or(IEnumerable<string> choices)
    {
        string[] all = [.. choices.Distinct(StringComparer.Ordinal)];
        return all.Length < 2 ? string.Concat(all) : string.Join(", ", all[..^1]) + " or " + all[^1];
    }

    private static string Short(string text) => text.Length <= Longest ? text : text[..Longest] + "...";

    public static string Number(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
