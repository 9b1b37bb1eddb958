using System.Globalization;
using System.Text.Json;

namespace ErrorMatching.Cell;

/// <summary>What waits at a cell's gauges, as it is published to the plant. It is not a step: the broker keeps the last message
/// only.</summary>
internal static class BacklogEvent
{
    /// <summary>The schema of the message.</summary>
    public const string Schema = "errormatch/backlog/1";

    /// <summary>The message as JSON.</summary>
    /// <param name="cell">The cell's name.</param>
    /// <param name="gauges">What waits.</param>
    /// <param name="now">The time.</param>
    public static byte[] Message(string cell, IReadOnlyList<GaugeBacklog> gauges, DateTimeOffset now)
    {
        using var bytes = new MemoryStream();
        using (var json = new Utf8JsonWriter(bytes))
        {
            json.WriteStartObject();
            json.WriteString("schema", Schema);
            json.WriteString("at", Time(now));
            json.WriteString("cell", cell);
            json.WriteNumber("waiting", gauges.Sum(g => g.Count));
            WriteAge(json, gauges.Select(g => g.Since).Min(), now);
            json.WriteStartArray("gauges");
            foreach (var gauge in gauges)
            {
                json.WriteStartObject();
                json.WriteString("gauge", gauge.Gauge);
                json.WriteNumber("files", gauge.Files);
                json.WriteNumber("pieces", gauge.Pieces);
                WriteAge(json, gauge.Since, now);
                json.WriteBoolean("growing", gauge.IsGrowing);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        return bytes.ToArray();
    }

    private static void WriteAge(Utf8JsonWriter json, DateTimeOffset? since, DateTimeOffset now)
    {
        if (since is not { } oldest) return;
        json.WriteString("oldestSince", Time(oldest));
        json.WriteNumber("oldestS", Math.Max(0, (long)(now - oldest).TotalSeconds));
    }

    private static string Time(DateTimeOffset time) =>
        time.UtcDateTime.ToString("yyyy-MM-ddTHH:mm:ss'Z'", CultureInfo.InvariantCulture);
}
