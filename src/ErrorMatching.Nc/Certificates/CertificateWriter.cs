using System.Buffers;
using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using ErrorMatching.Geometry;
using ErrorMatching.Json;

namespace ErrorMatching.Nc;

/// <summary>Writes a certificate with one member or moved motion per line. Measured lengths have nine decimals, wishes all digits that
/// distinguish a double from its neighbors.</summary>
internal sealed class CertificateWriter : IDisposable
{
    private static readonly JsonWriterOptions Options = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    private readonly Certificate _certificate;
    private readonly ArrayBufferWriter<byte> _bytes = new();
    private readonly ArrayBufferWriter<byte> _line = new();
    private readonly Utf8JsonWriter _json;

    private CertificateWriter(Certificate certificate)
    {
        _certificate = certificate;
        _json = new(_line, Options);
    }

    public static byte[] Write(Certificate certificate)
    {
        using var writer = new CertificateWriter(certificate);
        writer.Write();
        return writer._bytes.WrittenSpan.ToArray();
    }

    /// <inheritdoc/>
    public void Dispose() => _json.Dispose();

    private void Write()
    {
        var (before, after) = (_certificate.Task.Before, _certificate.Task.After);
        Append("{\n");
        Member("schema", json => json.WriteStringValue(Certificate.Schema));
        Member("baseSha256", json => json.WriteStringValue(ContentHash.Sha256(before.Program.Bytes.Span)));
        Member("resultSha256", json => json.WriteStringValue(ContentHash.Sha256(after.Program.Bytes.Span)));
        Member("dialect", WriteFacts);
        WriteCodes();
        WriteIncrement();
        Member("marker", WriteMarker);
        Member("wish", json => json.WriteStringValue(_certificate.Task.Wish.EndPoints.Count > 0 ? "points" : "elements"));
        WriteMoved();
        Append("  \"seal\": \"");
        var seal = ContentHash.Sha256(_bytes.WrittenSpan[..^"  \"seal\": \"".Length]);
        Append(seal + "\"\n}\n");
    }

    // What the judge cannot see in the programs: how numbers without a point and short radii are read.
    private void WriteFacts(Utf8JsonWriter json)
    {
        var dialect = _certificate.Task.Before.Dialect;
        json.WriteStartObject();
        json.WriteString("name", dialect.Name);
        json.WriteString("syntax", KebabNames.Of(dialect.Syntax.ToString()));
        json.WriteBoolean("integersAreIncrements", dialect.IntegersAreIncrements);
        json.WriteStartObject("decimals");
        json.WriteNumber("mm", dialect.MetricDecimals);
        json.WriteNumber("inch", dialect.InchDecimals);
        json.WriteEndObject();
        json.WriteNumber("arcMismatchMm", dialect.ArcMismatchMm);
        json.WriteEndObject();
    }

    // The meaning of each G code and M function up to the end of the original.
    private void WriteCodes()
    {
        var (dialect, program) = (_certificate.Task.Before.Dialect, _certificate.Task.Before.Program);
        var (codes, functions) = (new SortedDictionary<int, string>(), new SortedDictionary<int, string>());
        var ends = false;
        for (var i = 0; i < program.BlockCount && !ends; i++)
        {
            foreach (ref readonly var token in program.Tokens(program[i]))
            {
                if (token is { Kind: NcTokenKind.Word, Letter: (byte)'G' })
                {
                    var tenths = (int)Math.Clamp(Math.Round(token.Number.Value * 10), 0, int.MaxValue);
                    codes[tenths] = KebabNames.Of(dialect.MeaningOf(tenths).ToString());
                }
                else if (token is { Kind: NcTokenKind.Word, Letter: (byte)'M' })
                {
                    var function = (int)Math.Clamp(token.Number.Value, 0, int.MaxValue);
                    var role = dialect.FunctionOf(function);
                    functions[function] = KebabNames.Of(role.ToString());
                    ends |= role == FunctionRole.ProgramEnd;
                }
            }
        }

        Member("codes", json => WriteMeanings(json, codes.Select(c => ($"G{(c.Key / 10m).ToString("0.#", Invariant)}", c.Value))));
        Member("functions", json => WriteMeanings(json, functions.Select(f => ($"M{f.Key.ToString(Invariant)}", f.Value))));
    }

    private static System.Globalization.CultureInfo Invariant => System.Globalization.CultureInfo.InvariantCulture;

    private static void WriteMeanings(Utf8JsonWriter json, IEnumerable<(string Code, string Meaning)> meanings)
    {
        json.WriteStartObject();
        foreach (var (code, meaning) in meanings)
        {
            json.WriteString(code, meaning);
        }

        json.WriteEndObject();
    }

    private void WriteIncrement()
    {
        var task = _certificate.Task;
        var decimals = Math.Round(-Elementary.Log10(task.Increment));
        var isInch = Math.Abs((task.Increment * Elementary.Pow(10, decimals)) - 1) > 1e-9;
        Member("unit", json => json.WriteStringValue(isInch ? "inch" : "mm"));
        Member("leastIncrementMm", json => Number(json, task.Increment, 12));
        Member("toleranceMm", json =>
        {
            json.WriteStartObject();
            json.WritePropertyName("line");
            Number(json, task.LineTolerance);
            json.WritePropertyName("arc");
            Number(json, task.ArcTolerance);
            json.WritePropertyName("end");
            Number(json, task.Increment + 1e-6);
            json.WriteEndObject();
        });
    }

    private void WriteMarker(Utf8JsonWriter json)
    {
        if (_certificate.Marker is not { } marker)
        {
            json.WriteNullValue();
            return;
        }

        json.WriteStartObject();
        json.WriteNumber("line", _certificate.MarkerBlock + 1);
        json.WriteString("text", marker);
        json.WriteEndObject();
    }

    private void WriteMoved()
    {
        Append("  \"moved\": [");
        for (var i = 0; i < _certificate.Moved.Count; i++)
        {
            var moved = _certificate.Moved[i];
            Append(i == 0 ? "\n    " : ",\n    ");
            Raw(json => WriteMotion(json, moved));
        }

        Append(_certificate.Moved.Count == 0 ? "],\n" : "\n  ],\n");
        var motions = _certificate.Task.Before.Motions;
        var (runs, next, blocks, last) = (new List<(int First, int Last)>(), 0, 0, -2);
        for (var i = 0; i < motions.Length; i++)
        {
            if (i > 0 && motions.BlockOf(i) == motions.BlockOf(i - 1))
            {
                continue;
            }

            blocks++;
            var line = motions.BlockOf(i) + 1;
            if (next < _certificate.Moved.Count && motions.BlockOf(_certificate.Moved[next].Motion) + 1 == line)
            {
                next++;
                continue;
            }

            if (runs.Count > 0 && last == blocks - 1)
            {
                runs[^1] = (runs[^1].First, line);
            }
            else
            {
                runs.Add((line, line));
            }

            last = blocks;
        }

        Member("fixed", json =>
        {
            json.WriteStartArray();
            foreach (var (first, end) in runs)
            {
                json.WriteStartArray();
                json.WriteNumberValue(first);
                json.WriteNumberValue(end);
                json.WriteEndArray();
            }

            json.WriteEndArray();
        });
        Member("motions", json => json.WriteNumberValue(blocks));
    }

    private void WriteMotion(Utf8JsonWriter json, CertifiedMotion moved)
    {
        var was = _certificate.Task.Before.Motions[moved.Motion];
        var program = _certificate.Task.Before.Program;
        json.WriteStartObject();
        json.WriteNumber("line", was.Block + 1);
        json.WriteString("block", program.NumberOf(program[was.Block]));
        json.WriteString("as", KebabNames.Of(moved.As.ToString()));
        if (moved.Element is { } element)
        {
            WriteElement(json, moved, was, element);
        }
        else if (moved.As == CertifiedAs.Point)
        {
            Vector(json, "by", moved.By.X, moved.By.Y, moved.By.Z);
            var rest = moved.End - moved.By;
            Rounded(json, "rest", rest.X, rest.Y, rest.Z);
            if (was.IsArc)
            {
                var center = _certificate.Task.After.Motions[moved.Motion].Center - was.Center;
                Rounded(json, "center", center.X, center.Y);
            }
        }
        else
        {
            json.WriteStartObject("moved");
            Rounded(json, "start", moved.Start.X, moved.Start.Y, moved.Start.Z);
            Rounded(json, "end", moved.End.X, moved.End.Y, moved.End.Z);
            if (was.IsArc)
            {
                var center = _certificate.Task.After.Motions[moved.Motion].Center - was.Center;
                Rounded(json, "center", center.X, center.Y);
            }

            json.WriteEndObject();
        }

        json.WriteEndObject();
    }

    private void WriteElement(Utf8JsonWriter json, CertifiedMotion moved, in NcMotion was, in ElementWish wish)
    {
        Vector(json, "start", wish.Start.X, wish.Start.Y);
        if (was.IsArc)
        {
            Vector(json, "middle", wish.Middle.X, wish.Middle.Y);
        }

        Vector(json, "end", wish.End.X, wish.End.Y);
        if (moved is { As: CertifiedAs.Line, Carrier: { } line })
        {
            json.WriteNumber("shift", Round(line.Shift));
            json.WriteNumber("tilt", Round(line.Tilt));
        }
        else if (moved.Carrier is { } circle)
        {
            Rounded(json, "center", circle.Center.X, circle.Center.Y);
            json.WriteNumber("growth", Round(circle.Growth));
        }

        var (start, end) = (InPlane(was, moved.Start) - wish.Start, InPlane(was, moved.End) - wish.End);
        json.WriteStartObject("rest");
        Rounded(json, "start", start.X, start.Y);
        if (moved.Middle is { } middle)
        {
            Rounded(json, "middle", middle.X - wish.Middle.X, middle.Y - wish.Middle.Y);
        }

        Rounded(json, "end", end.X, end.Y);
        json.WriteEndObject();
        if (moved.As is CertifiedAs.Line or CertifiedAs.Arc)
        {
            json.WriteString("startBy", By(start));
            json.WriteString("endBy", By(end));
        }
    }

    // What fixes an end along its element: its own wish, or the cut that it meets there.
    private string By(Vector2 rest) => rest.Length <= _certificate.Task.Increment + 1e-6 ? "wish" : "meets";

    private static Vector2 InPlane(in NcMotion motion, Vector3 by) => motion.Plane.Project(default(Point3) + by) - Point2.Origin;

    private void Member(string name, Action<Utf8JsonWriter> write)
    {
        Append($"  \"{name}\": ");
        Raw(write);
        Append(",\n");
    }

    private void Raw(Action<Utf8JsonWriter> write)
    {
        _line.Clear();
        _json.Reset();
        write(_json);
        _json.Flush();
        _bytes.Write(_line.WrittenSpan);
    }

    private void Append(string text) => _bytes.Write(Encoding.ASCII.GetBytes(text));

    private static void Vector(Utf8JsonWriter json, string name, params ReadOnlySpan<double> values)
    {
        json.WriteStartArray(name);
        foreach (var value in values)
        {
            json.WriteNumberValue(value + 0.0);
        }

        json.WriteEndArray();
    }

    private static void Rounded(Utf8JsonWriter json, string name, params ReadOnlySpan<double> values)
    {
        json.WriteStartArray(name);
        foreach (var value in values)
        {
            json.WriteNumberValue(Round(value));
        }

        json.WriteEndArray();
    }

    private static void Number(Utf8JsonWriter json, double value, int decimals = 9) => json.WriteNumberValue(Round(value, decimals));

    // Without a negative zero.
    private static decimal Round(double value, int decimals = 9) => Math.Round((decimal)value, decimals) + 0m;
}
