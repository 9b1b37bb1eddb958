using System.Text.Json;

namespace ErrorMatching.Measurement;

/// <summary>How a gauge or a shop writes its result files.</summary>
/// <remarks>
/// The formats that come with the library are <c>points</c> and <c>feature-table</c>; they are data, read by the same reader as a shop's own description:
/// <code>
/// { "kind": "points", "encoding": "windows-1252", "delimiter": ";", "decimalComma": true, "skipLines": 4, "unit": "inch",
///   "columns": { "label": "Nr", "x": "X", "y": 3, "z": null } }
/// </code>
/// Members left out are those of the named format of that kind (<c>points</c> where the kind is left out too). If any column is given by name, the first line
/// behind the skipped ones is the header; if all are given by position, it is data.
/// </remarks>
public sealed record MeasurementFormat
{
    internal MeasurementFormat()
    {
    }

    /// <summary>One line per point under the header <c>point,x_mm,y_mm[,z_mm]</c>.</summary>
    public static MeasurementFormat Points { get; } = FormatJson.Embedded("points");

    /// <summary>One line per coordinate under the header <c>feature,item,nominal,actual,deviation</c>; other columns, such as the tolerance, are ignored.</summary>
    public static MeasurementFormat FeatureTable { get; } = FormatJson.Embedded("feature-table");

    /// <summary>How the table is laid out in the file.</summary>
    internal TableLayout Layout => new(SkipLines, Delimiter, DecimalComma, Columns.NeedHeader);

    /// <summary>The formats that come with the library; what a description leaves out is the first one's where it names no kind.</summary>
    internal static IReadOnlyList<MeasurementFormat> All { get; } = [Points, FeatureTable];

    /// <summary>Name of one of <see cref="EncodingNames"/>.</summary>
    public required string Encoding { get; init; }

    /// <summary>What stands between two cells: comma, semicolon, tab or vertical bar.</summary>
    public required char Delimiter { get; init; }

    /// <summary>True if numbers are written 32,067 and not 32.067.</summary>
    public required bool DecimalComma { get; init; }

    /// <summary>How many lines stand above the table. They are read for <see cref="MeasurementFile.HeaderFields"/> only.</summary>
    public required int SkipLines { get; init; }

    /// <summary>The unit of the coordinates.</summary>
    public required LengthUnit Unit { get; init; }

    /// <summary>Which columns hold what.</summary>
    public required MeasurementColumns Columns { get; init; }

    /// <summary>The largest file that is read, in bytes.</summary>
    public required int MaxBytes { get; init; }

    /// <summary>The most points that a file may have.</summary>
    public required int MaxPoints { get; init; }

    /// <summary>How the file arranges its points: the name of one of the formats that come with the library.</summary>
    public string Kind => Columns.Kind;

    /// <summary>The names of the encodings that can be read.</summary>
    public static IReadOnlyList<string> EncodingNames => SourceText.EncodingNames;

    /// <summary>A format by name or by description.</summary>
    /// <param name="format">A JSON string that names a format, or an object that describes one.</param>
    /// <exception cref="MeasurementException">The name is unknown, or the description has a member that is unknown or wrong
    /// (<see cref="MeasurementError.BadFormat"/>); <see cref="MeasurementException.Path"/> says which.</exception>
    public static MeasurementFormat FromJson(JsonElement format) => FormatJson.Read(format);

    /// <summary>A format by name or by description, from JSON text with comments and trailing commas allowed.</summary>
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
            // A member name with an escape that is no character is an invalid operation to the parser, not bad JSON.
            throw new MeasurementException(MeasurementError.BadFormat, "text that is not JSON: " + e.Message.TrimEnd('.'), "the name of a format or a JSON object", path: "$", cause: e);
        }
    }
}
