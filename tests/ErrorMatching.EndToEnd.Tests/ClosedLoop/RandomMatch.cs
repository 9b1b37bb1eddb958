using System.Globalization;
using System.Text;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Hands a random part to the system as a user would: a job, measured points as CSV, a program.</summary>
internal static class RandomMatch
{
    /// <summary>Feed-forward: the part deviates, the nominal program follows.</summary>
    public static MatchInput FeedForward(RandomPart part) => FeedForward(part, "fanuc");

    /// <summary>The same for a program in another dialect.</summary>
    public static MatchInput FeedForward(RandomPart part, string dialect) =>
        Input(part, "part", Csv(part, p => p.Theoretical), Csv(part, p => p.Actual), null, dialect);

    /// <summary>Feedback: a counterpart was cut and came out off by a share of the deviation; the part deviates as well.</summary>
    public static MatchInput Feedback(RandomPart part, double share) =>
        Input(
            part,
            "counterpart",
            Csv(part, p => p.Theoretical),
            Csv(part, p => p.Actual),
            Csv(part, p => p.Theoretical + ((p.Actual - p.Theoretical) * share)));

    /// <summary>Feed-forward of a part whose key points deviate one by one, as no line, arc or smooth curve can follow.</summary>
    public static MatchInput Rough(RandomPart part, double amplitude)
    {
        var random = new Random(part.Seed);
        var rough = part.KeyPoints.ToDictionary(
            p => p.Label,
            p => part.Frame.ToPart(p.Place + (p.Normal * (amplitude * ((2 * random.NextDouble()) - 1)))),
            StringComparer.Ordinal);
        return Input(part, "part", Csv(part, p => p.Theoretical), Csv(part, p => rough[p.Label]), null);
    }

    /// <summary>Feed-forward of a part whose boundary deviates along its normals as a function says, for a job that allows
    /// offsets.</summary>
    /// <param name="part">The part.</param>
    /// <param name="deviation">The deviation of a key point along its normal, mm.</param>
    /// <param name="correction">The job's <c>correction</c>.</param>
    public static MatchInput Offsets(RandomPart part, Func<RandomKeyPoint, double> deviation, string correction) =>
        Input(
            part,
            "part",
            Csv(part, p => p.Theoretical),
            Csv(part, p => part.Frame.ToPart(p.Place + (p.Normal * deviation(p)))),
            null,
            "linuxcnc",
            correction);

    /// <summary>The same for a gauge with noise and features with limits of 20 um.</summary>
    public static MatchInput Offsets(
        RandomPart part, Func<RandomKeyPoint, double> measured, string? correction, double uncertaintyMm) =>
        Input(
            part,
            "part",
            Csv(part, p => p.Theoretical),
            Csv(part, p => part.Frame.ToPart(p.Place + (p.Normal * measured(p)))),
            null,
            "linuxcnc",
            correction,
            text => text.Replace("[0, 0]", "[-0.02, 0.02]", StringComparison.Ordinal).Replace(
                "0.0000001", Text(uncertaintyMm), StringComparison.Ordinal));

    private static MatchInput Input(
        RandomPart part,
        string from,
        byte[] theoretical,
        byte[] actual,
        byte[]? counterpart,
        string dialect = "fanuc",
        string? correction = null,
        Func<string, string>? change = null)
    {
        var text = Job(part, from, dialect, correction);
        var job = MatingJob.Parse(Encoding.UTF8.GetBytes(change?.Invoke(text) ?? text), "random.json");
        return new(
            job,
            MeasurementReader.Read(theoretical, "theoretical.csv", job.Gauge.Format),
            MeasurementReader.Read(actual, "part.csv", job.Gauge.Format),
            counterpart is null ? null : MeasurementReader.Read(counterpart, "counterpart.csv", job.Gauge.Format),
            "counterpart.nc",
            Encoding.ASCII.GetBytes(part.Program));
    }

    private static string Job(RandomPart part, string from, string dialect, string? correction)
    {
        var features = part.Features.Select(
            f => $$"""{ "name": "{{f.Name}}", "kind": "{{f.Kind}}", "points": {{Points(f)}}, "blocks": ["{{f.Blocks}}"], "toleranceMm": [0, 0]{{f.More}} }""");
        return $$"""
            {
              "kind": "mating", "name": "Random {{part.Seed}}",
              "part": { "theoretical": "theoretical.csv", "measured": "part.csv" },
              "gauge": { "format": "points", "uncertaintyMm": 0.0000001 },
              "features": [ {{string.Join(",\n", features)}} ],
              "counterpart": {
                "program": "counterpart.nc", "dialect": "{{dialect}}", "toolDiameterMm": {{Text(2 * part.ToolRadius)}}, "measured": "counterpart.csv",
                "frame": { "mirror": "{{part.Frame.Mirror}}", "rotateDeg": {{Text(part.Frame.RotateDegrees)}}, "translateMm": [{{Text(part.Frame.Translate.U)}}, {{Text(part.Frame.Translate.V)}}] }
              },
              "compensation": { "from": "{{from}}" }{{(correction is null ? "" : $", \"correction\": {correction}")}}
            }
            """;
    }

    private static string Points(RandomFeature feature)
    {
        var groups = feature.Groups.Select(g => $"[{string.Join(", ", g.Select(p => $"\"{p.Label}\""))}]").ToList();
        return groups.Count == 1 ? groups[0] : $"[{string.Join(", ", groups)}]";
    }

    private static byte[] Csv(RandomPart part, Func<RandomKeyPoint, Flat> place)
    {
        var text = new StringBuilder("point,x_mm,y_mm\n");
        foreach (var point in part.KeyPoints)
        {
            var at = place(point);
            text.Append(CultureInfo.InvariantCulture, $"{point.Label},{at.U:0.000000000},{at.V:0.000000000}\n");
        }

        return Encoding.ASCII.GetBytes(text.ToString());
    }

    private static string Text(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
