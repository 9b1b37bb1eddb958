using System.Text.Json;

namespace ErrorMatching.Cell;

/// <summary>The sum of corrections at each measured point since the original program. Lengths in mm.</summary>
public sealed class CorrectionSums
{
    private const string Schema = "errormatch/cell-sums/1";

    private static readonly JsonWriterOptions Options = new() { Indented = true, NewLine = "\n" };

    private CorrectionSums(IReadOnlyList<PointCorrection> points) => Points = points;

    /// <summary>No corrections yet.</summary>
    public static CorrectionSums None { get; } = new([]);

    /// <summary>The sums, each point once, in the order in which points were first corrected.</summary>
    public IReadOnlyList<PointCorrection> Points { get; }

    /// <summary>The point of the largest sum; null if there is none.</summary>
    public PointCorrection? Largest => Points.MaxBy(p => p.LengthMm);

    /// <summary>These sums plus one more correction. A point that the correction does not contain keeps its sum.</summary>
    /// <exception cref="ArgumentException">The correction names a point twice.</exception>
    public CorrectionSums Plus(IReadOnlyList<PointCorrection> corrections)
    {
        ArgumentNullException.ThrowIfNull(corrections);
        var sums = Points.ToList();
        var places = sums.Select((s, i) => (s.Point, i)).ToDictionary(p => p.Point, p => p.i, StringComparer.Ordinal);
        var named = new HashSet<string>(StringComparer.Ordinal);
        foreach (var correction in corrections)
        {
            if (!named.Add(correction.Point))
            {
                throw new ArgumentException($"Point {correction.Point} is corrected twice.", nameof(corrections));
            }

            if (places.TryGetValue(correction.Point, out var at))
            {
                var sum = sums[at];
                sums[at] = sum with { X = sum.X + correction.X, Y = sum.Y + correction.Y, Z = sum.Z + correction.Z };
            }
            else
            {
                sums.Add(correction);
            }
        }

        return new(sums);
    }

    /// <summary>The sums as a document for the store: the same sums give the same bytes, and <see cref="FromJson"/> restores them to the
    /// last bit.</summary>
    public byte[] ToJson()
    {
        using var stream = new MemoryStream();
        using (var json = new Utf8JsonWriter(stream, Options))
        {
            json.WriteStartObject();
            json.WriteString("schema", Schema);
            json.WriteStartArray("points");
            foreach (var point in Points)
            {
                json.WriteStartObject();
                json.WriteString("point", point.Point);
                json.WriteNumber("x", point.X);
                json.WriteNumber("y", point.Y);
                json.WriteNumber("z", point.Z);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        stream.WriteByte((byte)'\n');
        return stream.ToArray();
    }

    /// <summary>Reads the sums from a document that <see cref="ToJson"/> wrote.</summary>
    /// <exception cref="InvalidDataException">It is not such a document.</exception>
    public static CorrectionSums FromJson(ReadOnlyMemory<byte> json)
    {
        try
        {
            using var document = JsonDocument.Parse(json);
            var root = document.RootElement;
            return root.GetProperty("schema").GetString() == Schema
                ? None.Plus([.. root.GetProperty("points").EnumerateArray().Select(PointOf)])
                : throw new InvalidDataException($"Found a document of another kind; expected {Schema}.");
        }
        catch (Exception e) when (
            e is JsonException or KeyNotFoundException or InvalidOperationException or FormatException or ArgumentException)
        {
            throw new InvalidDataException($"The sums of corrections cannot be read: {e.Message}", e);
        }
    }

    private static PointCorrection PointOf(JsonElement item) =>
        new(
            item.GetProperty("point").GetString() ?? throw new FormatException("A point has no name."),
            Number(item, "x"),
            Number(item, "y"),
            Number(item, "z"));

    private static double Number(JsonElement item, string name) =>
        item.GetProperty(name).GetDouble() is var value && double.IsFinite(value)
            ? value
            : throw new FormatException($"{name} is not finite.");
}
