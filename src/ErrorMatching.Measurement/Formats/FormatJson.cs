using System.Globalization;
using System.Text.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>Reads the description of a format member by member. Unknown members are errors and never ignored.</summary>
internal static class FormatJson
{
    private const int MostBytes = 1 << 30;
    private const int MostPoints = 10_000_000;
    private const int MostSkippedLines = 10_000;

    public static JsonDocumentOptions Options { get; } = new()
    {
        AllowTrailingCommas = true,
        CommentHandling = JsonCommentHandling.Skip,
        AllowDuplicateProperties = false
    };

    // The kinds of point arrangement. Their default columns are data, in a file of the same name.
    private static readonly MeasurementColumns[] Kinds = [
        new PointColumns(default, default, default, null), new FeatureTableColumns(default, default, default, default, null)];

    public static MeasurementFormat Embedded(string kind)
    {
        using var stream = typeof(FormatJson).Assembly.GetManifestResourceStream($"ErrorMatching.Measurement.Formats.{kind}.json")!;
        using var document = JsonDocument.Parse(stream, Options);
        return Apply(document.RootElement, new MeasurementFormat
        {
            Encoding = "",
            Delimiter = '\0',
            DecimalComma = false,
            SkipLines = 0,
            Unit = default,
            Columns = Kinds.Single(k => k.Kind == kind),
            MaxBytes = 0,
            MaxPoints = 0,
        });
    }

    public static MeasurementFormat Read(JsonElement format)
    {
        try
        {
            return format.ValueKind switch
            {
                JsonValueKind.String when Named(format) is { } named => named,
                JsonValueKind.Object => Apply(format, Kind(format)),
                _ => throw Bad("$", format, $"the name of a format ({Names(k => k)}) or an object that describes one"),
            };
        }
        catch (InvalidOperationException e)
        {
            // Escapes such as \ud800 are valid JSON but not valid text. Reading them as text is the only invalid operation possible here.
            throw MeasurementRefusal.Of(MeasurementError.BadFormat, "an escape that is no character", "text", path: "$", cause: e);
        }
    }

    private static MeasurementFormat? Named(JsonElement name) => MeasurementFormat.All.FirstOrDefault(f => name.ValueEquals(f.Kind));

    private static string Names(Func<string, string> shown) => string.Join(" or ", Kinds.Select(k => shown(k.Kind)));

    private static MeasurementFormat Kind(JsonElement format) => !format.TryGetProperty("kind", out var kind)
        ? MeasurementFormat.All[0]
        : (kind.ValueKind == JsonValueKind.String ? Named(kind) : null) ?? throw Bad("$.kind", kind, Names(k => $"\"{k}\""));

    private static MeasurementFormat Apply(JsonElement json, MeasurementFormat format)
    {
        foreach (var member in json.EnumerateObject())
        {
            var (path, value) = ("$." + member.Name, member.Value);
            format = member.Name switch
            {
                "kind" => format,
                "encoding" => format with { Encoding = OneOf(path, value, SourceText.EncodingNames) },
                "delimiter" => format with { Delimiter = OneOf(path, value, [",", ";", "\t", "|"])[0] },
                "decimalComma" => format with { DecimalComma = Flag(path, value) },
                "skipLines" => format with { SkipLines = Whole(path, value, 0, MostSkippedLines) },
                "unit" => format with { Unit = OneOf(path, value, ["mm", "inch"]) == "mm" ? LengthUnit.Millimeter : LengthUnit.Inch },
                "columns" => format with { Columns = Columns(value, format.Columns) },
                "maxBytes" => format with { MaxBytes = Whole(path, value, 1, MostBytes) },
                "maxPoints" => format with { MaxPoints = Whole(path, value, 1, MostPoints) },
                _ => throw Unknown(path, "kind, encoding, delimiter, decimalComma, skipLines, unit, columns, maxBytes or maxPoints"),
            };
        }

        return format;
    }

    private static MeasurementColumns Columns(JsonElement json, MeasurementColumns columns)
    {
        if (json.ValueKind != JsonValueKind.Object)
        {
            throw Bad("$.columns", json, "an object with a column name or position for each quantity");
        }

        foreach (var member in json.EnumerateObject())
        {
            var (path, value) = ("$.columns." + member.Name, member.Value);
            if (columns.Members.FirstOrDefault(m => m.Name == member.Name) is not { Name: not null } known)
            {
                throw Unknown(path, string.Join(", ", columns.Members.SkipLast(1).Select(m => m.Name)) + " or " + columns.Members[^1].Name);
            }

            columns = columns.With(known.Name, known.IsOptional ? Optional(path, value) : Column(path, value));
        }

        return columns;
    }

    private static ColumnSelector? Optional(string path, JsonElement json) =>
        json.ValueKind == JsonValueKind.Null ? null : Column(path, json);

    private static ColumnSelector Column(string path, JsonElement json) => json switch
    {
        { ValueKind: JsonValueKind.String } when !string.IsNullOrWhiteSpace(json.GetString()) =>
            ColumnSelector.Named(json.GetString()!.Trim()),
        { ValueKind: JsonValueKind.Number } when json.TryGetInt32(out var position) && position >= 1 => ColumnSelector.At(position),
        _ => throw Bad(path, json, "the name of a column, or its position counted from 1"),
    };

    private static string OneOf(string path, JsonElement json, IReadOnlyList<string> words) =>
        Text(json) is { } text && words.Contains(text, StringComparer.Ordinal)
            ? text
            : throw Bad(path, json, "one of " + string.Join(", ", words.Select(MeasurementRefusal.Quote)));

    private static bool Flag(string path, JsonElement json) =>
        json.ValueKind is JsonValueKind.True or JsonValueKind.False ? json.GetBoolean() : throw Bad(path, json, "true or false");

    private static int Whole(string path, JsonElement json, int least, int most) =>
        json.ValueKind == JsonValueKind.Number && json.TryGetInt32(out var value) && value >= least && value <= most
            ? value
            : throw Bad(path, json, string.Create(CultureInfo.InvariantCulture, $"a whole number from {least} to {most}"));

    private static string? Text(JsonElement json) => json.ValueKind == JsonValueKind.String ? json.GetString() : null;

    private static InputException Unknown(string path, string expected) =>
        MeasurementRefusal.Of(MeasurementError.BadFormat, "an unknown member", expected, path: path);

    private static InputException Bad(string path, JsonElement json, string expected) =>
        MeasurementRefusal.Of(MeasurementError.BadFormat, MeasurementRefusal.Quote(json.GetRawText()), expected, path: path);
}
