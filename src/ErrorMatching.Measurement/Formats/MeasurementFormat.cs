using System.Text.Json;

namespace ErrorMatching.Measurement;

/// <summary>The format of a gauge's or a shop's result files.</summary>
/// <remarks>
/// The built-in formats are <c>points</c> and <c>feature-table</c>. They are data, read in the same way as a shop's own description:
/// <code>
/// { "kind": "points", "encoding": "windows-1252", "delimiter": ";", "decimalComma": true, "skipLines": 4, "unit": "inch",
///   "columns": { "label": "Nr", "x": "X", "y": 3, "z": null } }
/// </code>
/// Omitted members are taken from the built-in format of that kind (<c>points</c> if the kind is omitted). If any column is given by name,
/// the first line after the skipped ones is the header; if all are given by position, it is data.
/// </remarks>
public sealed record MeasurementFormat
{
    internal MeasurementFormat()
    {
    }

    /// <summary>One line per point under the header <c>point,x_mm,y_mm[,z_mm]</c>.</summary>
    public static MeasurementFormat Points { get; } = FormatJson.Embedded("points");

    /// <summary>One line per coordinate under the header <c>feature,item,nominal,actual,deviation</c>; other columns, such as the
    /// tolerance, are ignored.</summary>
    public static MeasurementFormat FeatureTable { get; } = FormatJson.Embedded("feature-table");

    internal TableLayout Layout => new(SkipLines, Delimiter, DecimalComma, Columns.NeedHeader);

    /// <summary>The built-in formats. A description without a kind uses the first one for omitted members.</summary>
    internal static IReadOnlyList<MeasurementFormat> All { get; } = [Points, FeatureTable];

    /// <summary>Name of one of <see cref="EncodingNames"/>.</summary>
    public required string Encoding { get; init; }

    /// <summary>The cell separator: comma, semicolon, tab or vertical bar.</summary>
    public required char Delimiter { get; init; }

    /// <summary>True if numbers are written 32,067 instead of 32.067.</summary>
    public required bool DecimalComma { get; init; }

    /// <summary>Number of lines above the table. They are only used for <see cref="MeasurementFile.HeaderFields"/>.</summary>
    public required int SkipLines { get; init; }

    /// <summary>The unit of the coordinates.</summary>
    public required LengthUnit Unit { get; init; }

    /// <summary>The assignment of the columns.</summary>
    public required MeasurementColumns Columns { get; init; }

    /// <summary>Maximum file size in bytes.</summary>
    public required int MaxBytes { get; init; }

    /// <summary>Maximum number of points.</summary>
    public required int MaxPoints { get; init; }

    /// <summary>The kind of point arrangement: the name of a built-in format.</summary>
    public string Kind => Columns.Kind;

    /// <summary>The names of the supported encodings.</summary>
    public static IReadOnlyList<string> EncodingNames => SourceText.EncodingNames;

    /// <summary>Reads a format by name or description.</summary>
    /// <param name="format">A JSON string that names a format, or an object that describes one.</param>
    /// <exception cref="InputException">The name is unknown, or the description has an unknown or wrong member
    /// (<see cref="MeasurementError.BadFormat"/>), named by <see cref="InputException.Path"/>.</exception>
    public static MeasurementFormat FromJson(JsonElement format) => FormatJson.Read(format);

    /// <summary>Reads a format by name or description, from JSON text with comments and trailing commas.</summary>
    /// <inheritdoc cref="FromJson(JsonElement)"/>
    public static MeasurementFormat FromJson(string json)
    {
        try
        {
            using var document = JsonDocument.Parse(json, FormatJson.Options);
            return FormatJson.Read(document.RootElement);
        }
        catch (Exception e) when (e is JsonException or InvalidOperationException)
        {
            // To the parser, a member name with an invalid character escape is an invalid operation, not bad JSON.
            throw MeasurementRefusal.Of(
                MeasurementError.BadFormat,
                "text that is not JSON: " + e.Message.TrimEnd('.'),
                "the name of a format or a JSON object",
                path: "$",
                cause: e);
        }
    }
}
