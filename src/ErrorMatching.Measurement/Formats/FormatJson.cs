using System.Globalization;
using System.Text.Json;

namespace ErrorMatching.Measurement;

/// <summary>Reads the description of a format, member by member: what it does not know is an error, never ignored.</summary>
internal static class FormatJson
{
    private const int MostBytes = 1 << 30;
    private const int MostPoints = 10_000_000;
    private const int MostSkippedLines = 10_000;

    public static JsonDocumentOptions Options { get; } = new() { AllowTrailingCommas = true, CommentHandling = JsonCommentHandling.Skip, AllowDuplicateProperties = false };

    public static MeasurementFormat Embedded(string name)
    {
        using var stream = typeof(FormatJson).Assembly.GetManifestResourceStream($"ErrorMatching.Measurement.Formats.{name}.json")!;
        using var document = JsonDocument.Parse(stream, Options);
        var root = document.RootElement;
        var columns = root.GetProperty("columns");
        return Apply(root, new MeasurementFormat
        {
            Encoding = "",
            Delimiter = '\0',
            DecimalComma = false,
            SkipLines = 0,
            Unit = default,
            Columns = Kind(root) == MeasurementKind.Points ? Columns(columns, new PointColumns(default, default, default, null)) : Columns(columns, new FeatureTableColumns(default, default, default, default, null)),
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
                JsonValueKind.String when format.ValueEquals("points") => MeasurementFormat.Points,
                JsonValueKind.String when format.ValueEquals("feature-table") => MeasurementFormat.FeatureTable,
                JsonValueKind.Object => Apply(format, Kind(format) == MeasurementKind.Points ? MeasurementFormat.Points : MeasurementFormat.FeatureTable),
                _ => throw Bad("$", format, "the name of a format (points or feature-table) or an object that describes one"),
            };
        }
        catch (InvalidOperationException e)
        {
            // Escapes such as \ud800 are JSON, but no text; reading them as text is the only operation here that can be invalid.
            throw new MeasurementException(MeasurementError.BadFormat, "an escape that is no character", "text", path: "$", cause: e);
        }
    }

    private static MeasurementKind Kind(JsonElement format) => !format.TryGetProperty("kind", out var kind) ? MeasurementKind.Points
        : Text(kind) switch
        {
            "points" => MeasurementKind.Points,
            "feature-table" => MeasurementKind.FeatureTable,
            _ => throw Bad("$.kind", kind, "\"points\" or \"feature-table\""),
        };

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
            columns = (columns, member.Name) switch
            {
                (PointColumns c, "label") => c with { Label = Column(path, value) },
                (PointColumns c, "x") => c with { X = Column(path, value) },
                (PointColumns c, "y") => c with { Y = Column(path, value) },
                (PointColumns c, "z") => c with { Z = Optional(path, value) },
                (FeatureTableColumns c, "feature") => c with { Feature = Column(path, value) },
                (FeatureTableColumns c, "item") => c with { Item = Column(path, value) },
                (FeatureTableColumns c, "nominal") => c with { Nominal = Column(path, value) },
                (FeatureTableColumns c, "actual") => c with { Actual = Column(path, value) },
                (FeatureTableColumns c, "deviation") => c with { Deviation = Optional(path, value) },
                (PointColumns, _) => throw Unknown(path, "label, x, y or z"),
                _ => throw Unknown(path, "feature, item, nominal, actual or deviation"),
            };
        }

        return columns;
    }

    private static ColumnSelector? Optional(string path, JsonElement json) => json.ValueKind == JsonValueKind.Null ? null : Column(path, json);

    private static ColumnSelector Column(string path, JsonElement json) => json switch
    {
        { ValueKind: JsonValueKind.String } when !string.IsNullOrWhiteSpace(json.GetString()) => ColumnSelector.Named(json.GetString()!.Trim()),
        { ValueKind: JsonValueKind.Number } when json.TryGetInt32(out var position) && position >= 1 => ColumnSelector.At(position),
        _ => throw Bad(path, json, "the name of a column, or its position counted from 1"),
    };

    private static string OneOf(string path, JsonElement json, IReadOnlyList<string> words) =>
        Text(json) is { } text && words.Contains(text, StringComparer.Ordinal) ? text : throw Bad(path, json, "one of " + string.Join(", ", words.Select(MeasurementException.Quote)));

    private static bool Flag(string path, JsonElement json) =>
        json.ValueKind is JsonValueKind.True or JsonValueKind.False ? json.GetBoolean() : throw Bad(path, json, "true or false");

    private static int Whole(string path, JsonElement json, int least, int most) =>
        json.ValueKind == JsonValueKind.Number && json.TryGetInt32(out var value) && value >= least && value <= most
            ? value
            : throw Bad(path, json, string.Create(CultureInfo.InvariantCulture, $"a whole number from {least} to {most}"));

    private static string? Text(JsonElement json) => json.ValueKind == JsonValueKind.String ? json.GetString() : null;

    private static MeasurementException Unknown(string path, string expected) => new(MeasurementError.BadFormat, "an unknown member", expected, path: path);

    private static MeasurementException Bad(string path, JsonElement json, string expected) =>
        new(MeasurementError.BadFormat, MeasurementException.Quote(json.GetRawText()), expected, path: path);
}
