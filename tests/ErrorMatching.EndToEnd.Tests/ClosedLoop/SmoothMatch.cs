using System.Globalization;
using System.Text;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Hands a smooth part to the system as a user would, and judges a path by the exact distance of the true boundary.</summary>
internal static class SmoothMatch
{
    public static MatchInput Input(SmoothPart part, double limitMm = 0.005)
    {
        var features = part.Features.Select(f => string.Create(
            CultureInfo.InvariantCulture,
            $$"""
            { "name": "{{f.Name}}", "kind": "{{f.Kind}}", "points": [{{string.Join(", ", f.Points.Select(p => $"\"{p}\""))}}],
              "blocks": ["{{f.Blocks}}"], "toleranceMm": [{{-limitMm}}, {{limitMm}}] }
            """));
        var text = string.Create(
            CultureInfo.InvariantCulture,
            $$"""
            {
              "kind": "mating", "name": "Smooth {{part.Seed}}",
              "part": { "theoretical": "theoretical.csv", "measured": "part.csv" },
              "gauge": { "format": "points", "uncertaintyMm": {{Math.Max(part.Noise, 1e-7)}} },
              "features": [ {{string.Join(",\n", features)}} ],
              "counterpart": { "program": "counterpart.nc", "dialect": "fanuc", "toolDiameterMm": {{2 * part.ToolRadius}} },
              "compensation": { "from": "part" }
            }
            """);
        var job = MatingJob.Parse(Encoding.UTF8.GetBytes(text), "smooth.json");
        return new(
            job,
            MeasurementReader.Read(Csv(part, p => p.Place), "theoretical.csv", job.Gauge.Format),
            MeasurementReader.Read(Csv(part, p => p.Actual), "part.csv", job.Gauge.Format),
            null,
            "counterpart.nc",
            Encoding.ASCII.GetBytes(part.Program));
    }

    /// <summary>How far each place of the true boundary is from what a path leaves, mm; positive if the path leaves more
    /// material.</summary>
    public static double[] Errors(SmoothPart part, IReadOnlyList<(Flat From, Flat To)> path) =>
        [.. part.Boundary.Select(b => DistanceTo(path, b.Actual) - part.ToolRadius)];

    /// <summary>The distance of a place from a path.</summary>
    public static double DistanceTo(IReadOnlyList<(Flat From, Flat To)> path, Flat place)
    {
        var least = double.PositiveInfinity;
        foreach (var (from, to) in path)
        {
            var (way, off) = (to - from, place - from);
            var length = way.Dot(way);
            var share = length > 0 ? Math.Clamp(off.Dot(way) / length, 0, 1) : 0;
            var left = off - (way * share);
            least = Math.Min(least, left.Dot(left));
        }

        return Math.Sqrt(least);
    }

    /// <summary>The cuts of a program, read by the referee.</summary>
    public static List<(Flat From, Flat To)> PathOf(ReadOnlyMemory<byte> program) =>
        [
            .. RefereeInterpreter.Run(Encoding.ASCII.GetString(program.Span)).Where(m => !m.Rapid)
                .Select(m => (m.From.In(WorkPlane.XY), m.To.In(WorkPlane.XY))).Where(m => m.Item1 != m.Item2)];

    public static double Rms(IReadOnlyCollection<double> values) => Math.Sqrt(values.Average(v => v * v));

    private static byte[] Csv(SmoothPart part, Func<SmoothPart.KeyPoint, Flat> place)
    {
        var text = new StringBuilder("point,x_mm,y_mm\n");
        foreach (var point in part.Points)
        {
            text.Append(CultureInfo.InvariantCulture, $"{point.Label},{place(point).U:0.0000000},{place(point).V:0.0000000}\n");
        }

        return Encoding.ASCII.GetBytes(text.ToString());
    }
}
