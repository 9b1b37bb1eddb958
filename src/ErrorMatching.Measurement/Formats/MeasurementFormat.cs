using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>The format of a gauge's or a shop's result files.</summary>
/// <remarks>
/// The built-in formats are <c>points</c>, <c>feature-table</c> and <c>grid</c>. They are data, read as a shop's own description is:
/// <code>
/// { "kind": "points", "encoding": "windows-1252", "delimiter": ";", "decimalComma": true, "skipLines": 4, "unit": "inch",
///   "columns": { "label": "Nr", "x": "X", "y": 3, "z": null } }
/// </code>
/// Omitted members are taken from the built-in format of that kind (<c>points</c> if the kind is omitted). If any column is given by name,
/// the first line after the skipped ones is the header; if all are given by position, it is data. A log that is no table has a pattern of
/// its lines instead of columns: <c>{ "line": "TP{label} X{x} Y{y}", "unit": "mm" }</c>.
/// </remarks>
public sealed record MeasurementFormat
{
    internal MeasurementFormat()
    {
    }

    /// <summary>One line per point under the header <c>point,x_mm,y_mm[,z_mm]</c>. In a table without these names, <c>x</c>, <c>y</c> and
    /// <c>z</c> are millimeters, too, as in a plan of where to touch.</summary>
    public static MeasurementFormat Points { get; } = FormatReader.Embedded("points") is var points && points.Columns is PointColumns own
        ? points with
        {
            Columns = own with
            {
                X = ColumnSelector.First("x_mm", "x"),
                Y = ColumnSelector.First("y_mm", "y"),
                Z = ColumnSelector.First("z_mm", "z"),
            },
        }
        : points;

    /// <summary>One line per coordinate under the header <c>feature,item,nominal,actual,deviation</c>; other columns, such as the
    /// tolerance, are ignored.</summary>
    public static MeasurementFormat FeatureTable { get; } = FormatReader.Embedded("feature-table");

    /// <summary>One line per point of a grid under the header <c>i,j,x_mm,y_mm,z_mm</c>. The label of a point is <c>i,j</c>.</summary>
    public static MeasurementFormat Grid { get; } = FormatReader.Embedded("grid");

    /// <summary>The format <c>recognized</c>: the header shows the delimiter (comma, semicolon, tab, vertical bar or blanks) and the
    /// columns of one of the built-in formats. Names of coordinates may lack <c>_mm</c>, and <c>label</c> may replace <c>point</c>.
    /// Decimal points, millimeters, UTF-8.</summary>
    public static MeasurementFormat Recognized { get; } = Points with
    {
        Origin = FormatOrigin.Recognized,
        Delimiter = '\0',
        MaxBytes = Grid.MaxBytes,
        MaxPoints = Grid.MaxPoints,
    };

    internal TableLayout Layout => new(SkipLines, Delimiter, DecimalComma, Columns.NeedHeader);

    /// <summary>The built-in formats. A description without a kind uses the first one for omitted members.</summary>
    internal static IReadOnlyList<MeasurementFormat> All { get; } = [Points, FeatureTable, Grid];

    /// <summary>Name of one of <see cref="EncodingNames"/>.</summary>
    public required string Encoding { get; init; }

    /// <summary>The cell separator: comma, semicolon, tab, vertical bar, or a blank for one blank or more. NUL if the header shows
    /// it.</summary>
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

    /// <summary>The lines of a log that is no table; null for tables.</summary>
    internal LinePattern? Line { get; init; }

    internal FormatOrigin Origin { get; init; }

    /// <summary>The kind of point arrangement: the name of a built-in format.</summary>
    public string Kind => Columns.Kind;

    /// <summary>The names of the supported encodings.</summary>
    public static IReadOnlyList<string> EncodingNames => SourceText.EncodingNames;

    /// <summary>Reads a format by name or description, as part of a document.</summary>
    /// <param name="format">The name of a format, or an object that describes one.</param>
    /// <param name="problems">Receives what is wrong, with code <see cref="MeasurementError.BadFormat"/>.</param>
    /// <param name="basis">The format of the members that a description without a kind omits; null for <see cref="Points"/>.</param>
    /// <returns>The format; null if something is wrong.</returns>
    public static MeasurementFormat? Read(JsonItem format, ICollection<Refusal> problems, MeasurementFormat? basis = null)
    {
        ArgumentNullException.ThrowIfNull(format);
        ArgumentNullException.ThrowIfNull(problems);
        return new FormatReader(problems).Read(format, basis ?? Points);
    }

    /// <summary>Reads a format by name or description, from JSON text with comments and trailing commas.</summary>
    /// <param name="json">A JSON string that names a format, or an object that describes one.</param>
    /// <exception cref="InputException">The text is not JSON, the name is unknown, or the description has an unknown or wrong member
    /// (<see cref="MeasurementError.BadFormat"/>), named by its path.</exception>
    public static MeasurementFormat FromJson(string json)
    {
        ArgumentNullException.ThrowIfNull(json);
        var problems = new List<Refusal>();
        try
        {
            if (Read(JsonInput.Read(System.Text.Encoding.UTF8.GetBytes(json), "format"), problems) is { } format)
            {
                return format;
            }
        }
        catch (InputException e)
        {
            // What is wrong with the document, not with a member.
            var (found, expected) = (e.Refusals[0].Found, e.Refusals[0].Expected);
            throw MeasurementRefusal.Of(MeasurementError.BadFormat, found, expected, path: "$", cause: e);
        }

        // A description of its own is short: the path says enough.
        throw new InputException([.. problems.Select(p => p with { Place = new() { Path = p.Place.Path } })]);
    }
}
