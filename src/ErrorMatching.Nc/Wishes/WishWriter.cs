using System.Buffers;
using System.Text.Encodings.Web;
using System.Text.Json;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Writes a wish with one named motion per line, so that people can read and compare wishes. Numbers have all digits that
/// distinguish a double from its neighbors (17 at most).</summary>
internal sealed class WishWriter : IDisposable
{
    private const int FlushAt = 1 << 16;

    private readonly Utf8JsonWriter _json;
    private readonly ArrayBufferWriter<byte> _line = new();
    private readonly Utf8JsonWriter _inLine;

    private WishWriter(Stream stream)
    {
        // A block number has no markup, and a marker is not used in web pages.
        var encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping;
        _json = new(stream, new JsonWriterOptions { Indented = true, NewLine = "\n", Encoder = encoder });
        _inLine = new(_line, new JsonWriterOptions { Encoder = encoder });
    }

    public static void Write(WishFile file, Stream stream)
    {
        using (var writer = new WishWriter(stream))
        {
            writer.Write(file);
        }

        stream.WriteByte((byte)'\n');
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        _inLine.Dispose();
        _json.Dispose();
    }

    private void Write(WishFile file)
    {
        _json.WriteStartObject();
        _json.WriteString("schema", WishFile.Schema);
        _json.WriteString("dialect", file.Dialect);
        if (BlockSkips.WordOf(file.BlockSkip) is { } blockSkip)
        {
            _json.WriteString("blockSkip", blockSkip);
        }

        WriteAssumed(file.Assumed);
        WriteRadii(file.ToolRadii);
        _json.WriteString("beforeSha256", file.BeforeSha256);
        _json.WriteNumber("leastIncrementMm", file.LeastIncrementMm);
        _json.WriteString("marker", file.Marker);
        if (file.Wish.EndPoints.Count > 0)
        {
            _json.WriteStartObject("endPoints");
            _json.WritePropertyName("by");
            Line(" "u8, json => Vector(json, file.Wish.By.X, file.Wish.By.Y, file.Wish.By.Z));
            WriteMotions("motions", file, "\n      "u8);
            _json.WriteEndObject();
        }
        else
        {
            WriteMotions("elements", file, "\n    "u8);
        }

        _json.WriteEndObject();
    }

    private void WriteAssumed(AssumedValues assumed)
    {
        if (assumed.Count == 0)
        {
            return;
        }

        _json.WriteStartArray("assume");
        foreach (var (variable, value) in assumed.Values)
        {
            _json.WriteStartObject();
            _json.WriteString("variable", variable);
            _json.WriteNumber("value", value);
            _json.WriteEndObject();
        }

        _json.WriteEndArray();
    }

    private void WriteRadii(ToolRadii radii)
    {
        if (radii.Otherwise is { } radius)
        {
            _json.WriteNumber("toolRadiusMm", radius);
        }

        if (radii.ByNumber.Count > 0)
        {
            _json.WriteStartArray("toolRadii");
            foreach (var (number, mm) in radii.ByNumber.OrderBy(r => r.Key))
            {
                _json.WriteStartObject();
                _json.WriteNumber("number", number);
                _json.WriteNumber("radiusMm", mm);
                _json.WriteEndObject();
            }

            _json.WriteEndArray();
        }
    }

    private void WriteMotions(string name, WishFile file, ReadOnlySpan<byte> indent)
    {
        _json.WriteStartArray(name);
        for (var i = 0; i < file.Motions.Count; i++)
        {
            var (motion, element) = (file.Motions[i], file.Wish.Elements.Count > 0 ? file.Wish.Elements[i] : (ElementWish?)null);
            var by = file.Wish.IsPointByPoint ? file.Wish.ByOf(i) : (Vector3?)null;
            Line(indent, json => WriteMotion(json, motion, element, by));
            if (_json.BytesPending > FlushAt)
            {
                _json.Flush();
            }
        }

        _json.WriteEndArray();
    }

    private static void WriteMotion(Utf8JsonWriter json, WishedMotion motion, ElementWish? wish, Vector3? by)
    {
        json.WriteStartObject();
        json.WriteString("block", motion.Block);
        json.WriteNumber("line", motion.Line);
        json.WriteNumber("motion", motion.Motion);
        if (by is { } vector)
        {
            json.WritePropertyName("by");
            Vector(json, vector.X, vector.Y, vector.Z);
        }

        if (wish is { } element)
        {
            json.WritePropertyName("start");
            Vector(json, element.Start.X, element.Start.Y);
            if (element.Middle != element.Start)
            {
                json.WritePropertyName("middle");
                Vector(json, element.Middle.X, element.Middle.Y);
            }

            if (element.End != element.Start)
            {
                json.WritePropertyName("end");
                Vector(json, element.End.X, element.End.Y);
            }

            if (element.IsFillet)
            {
                json.WriteBoolean("fillet", true);
            }
        }

        json.WriteEndObject();
    }

    private static void Vector(Utf8JsonWriter json, params ReadOnlySpan<double> coordinates)
    {
        json.WriteStartArray();
        foreach (var coordinate in coordinates)
        {
            json.WriteNumberValue(coordinate);
        }

        json.WriteEndArray();
    }

    // Writes a value on one line: the indentation of the whole document would spread each vector over four.
    private void Line(ReadOnlySpan<byte> indent, Action<Utf8JsonWriter> write)
    {
        _line.ResetWrittenCount();
        _line.Write(indent);
        _inLine.Reset();
        write(_inLine);
        _inLine.Flush();
        _json.WriteRawValue(_line.WrittenSpan, skipInputValidation: true);
    }
}
