using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>Reads the description of a format: checks it against the schema, and its columns against those of its kind.</summary>
/// <param name="problems">Receives what is wrong, with code <see cref="MeasurementError.BadFormat"/>.</param>
internal sealed class FormatReader(ICollection<Refusal> problems)
{
    private static readonly Lazy<JsonSchema> Schema = new(() => JsonSchema.Parse(Resource("format.schema"), "format.schema.json"));

    // The kinds of point arrangement. Their default columns are data, in a file of the same name.
    private static readonly MeasurementColumns[] Kinds = [
        new PointColumns(default, default, default, null), new FeatureTableColumns(default, default, default, default, null),
        new GridColumns(default, default, default, default, default)];

    public static MeasurementFormat Embedded(string kind)
    {
        var file = kind + ".json";
        var problems = new List<Refusal>();
        var format = new FormatReader(problems).Apply(JsonInput.Read(Resource(kind), file), new MeasurementFormat
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
        return problems.Count == 0 ? format with { Origin = FormatOrigin.Named } : throw new InputException(file, problems);
    }

    /// <summary>The format; null if something is wrong.</summary>
    /// <param name="format">Its name or description.</param>
    /// <param name="basis">The format of the members that a description without a kind omits.</param>
    public MeasurementFormat? Read(JsonItem format, MeasurementFormat basis)
    {
        var before = problems.Count;
        foreach (var problem in Schema.Value.Check(format))
        {
            problems.Add(problem.Code == "not-one-of"
                ? Refusal.Of(MeasurementError.BadFormat, problem.Found, "one of " + problem.Expected, problem.Place)
                : problem with { Code = MeasurementError.BadFormat });
        }

        if (problems.Count > before)
        {
            return null;
        }

        var named = MeasurementFormat.All.FirstOrDefault(f => f.Kind == (format.Find("kind") ?? format).Text);
        var read = format.Kind == JsonItemKind.Text ? named ?? MeasurementFormat.Recognized : Apply(format, named ?? basis);
        return problems.Count == before ? read : null;
    }

    private MeasurementFormat Apply(JsonItem json, MeasurementFormat format)
    {
        foreach (var (name, _, value) in json.Members)
        {
            format = name switch
            {
                "encoding" => format with { Encoding = value.Text },
                "delimiter" => format with { Delimiter = value.Text[0] },
                "decimalComma" => format with { DecimalComma = value.Flag },
                "skipLines" => format with { SkipLines = (int)value.Number },
                "unit" => format with { Unit = value.Text == "mm" ? LengthUnit.Millimeter : LengthUnit.Inch },
                "columns" => format with
                {
                    Columns = Columns(value, format.Columns),
                    Delimiter = format.Delimiter == '\0' ? MeasurementFormat.Points.Delimiter : format.Delimiter,
                    Origin = FormatOrigin.Described,
                },
                "line" => format with { Line = Line(json, value), Origin = FormatOrigin.Described },
                "maxBytes" => format with { MaxBytes = (int)value.Number },
                "maxPoints" => format with { MaxPoints = (int)value.Number },
                _ => format,
            };
        }

        return format;
    }

    // A log has lines, a table has columns.
    private LinePattern? Line(JsonItem format, JsonItem line)
    {
        var kind = format.Find("kind");
        var table = format.Find("columns") ?? format.Find("delimiter") ?? (kind?.Text is null or "points" ? null : kind);
        if (table is not null)
        {
            problems.Add(JsonRefusal.At(
                table, MeasurementError.BadFormat, "the description of a table beside \"line\"", "either columns or the lines of a log"));
            return null;
        }

        try
        {
            return LinePattern.Parse(line.Text, format.Find("decimalComma")?.Flag ?? false);
        }
        catch (InputException e)
        {
            problems.Add(JsonRefusal.At(line, MeasurementError.BadFormat, e.Refusals[0].Found, e.Refusals[0].Expected));
            return null;
        }
    }

    private MeasurementColumns Columns(JsonItem json, MeasurementColumns columns)
    {
        foreach (var member in json.Members)
        {
            var known = columns.Members.FirstOrDefault(m => m.Name == member.Name);
            if (known.Name is null)
            {
                var names = string.Join(", ", columns.Members.SkipLast(1).Select(m => m.Name)) + " or " + columns.Members[^1].Name;
                problems.Add(JsonRefusal.At(
                    member.Place, member.Value.Path, MeasurementError.BadFormat, $"the key \"{member.Name}\"", names));
            }
            else if (Column(member.Value) is { } column)
            {
                columns = columns.With(known.Name, column);
            }
            else if (member.Value.Kind == JsonItemKind.Null && known.IsOptional)
            {
                columns = columns.With(known.Name, null);
            }
            else
            {
                problems.Add(JsonRefusal.At(
                    member.Value,
                    MeasurementError.BadFormat,
                    MeasurementRefusal.Quote(member.Value.ToJson()),
                    "the name of a column, or its position counted from 1"));
            }
        }

        return columns;
    }

    private static ColumnSelector? Column(JsonItem json) => json switch
    {
        { Kind: JsonItemKind.Text } when !string.IsNullOrWhiteSpace(json.Text) => ColumnSelector.Named(json.Text.Trim()),
        { Kind: JsonItemKind.Number, Number: >= 1 and <= int.MaxValue } when Math.Floor(json.Number) == json.Number =>
            ColumnSelector.At((int)json.Number),
        _ => null,
    };

    private static byte[] Resource(string name)
    {
        using var stream = typeof(FormatReader).Assembly.GetManifestResourceStream($"ErrorMatching.Measurement.Formats.{name}.json")!;
        var bytes = new byte[stream.Length];
        stream.ReadExactly(bytes);
        return bytes;
    }
}
