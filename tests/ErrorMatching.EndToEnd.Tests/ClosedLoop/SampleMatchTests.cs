using System.Globalization;
using System.Text;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The samples through the pure core, judged by the referee: the counterpart follows the part as far as the report predicts.</summary>
public sealed class SampleMatchTests
{
    private const double ToolRadius = 3;

    [Theory]
    [InlineData("curve-mating")]
    [InlineData("complex-mating")]
    public void Cut_from_the_new_program_the_counterpart_leaves_the_predicted_error(string sample)
    {
        var result = Match(sample);
        var report = MatchReporter.Report(result, "counterpart.nc", 0);
        var cut = new VirtualCut(RefereeInterpreter.Run(Encoding.ASCII.GetString(result.Program.Span)), ToolRadius);

        Assert.True(report.Proof.Holds);
        var outside = new List<(string Point, bool WasWithin)>();
        foreach (var point in report.KeyPoints)
        {
            var normal = new Flat(point.Normal.X, point.Normal.Y);
            var actual = (point.Actual - point.Theoretical).Dot(point.Normal);
            var found = cut.Probe(new(point.Theoretical.X, point.Theoretical.Y), normal) - actual;
            Assert.True(Math.Abs(found - point.PredictedMm) <= 0.003, FormattableString.Invariant($"{sample} {point.Point}: predicted {point.PredictedMm:0.0000}, cut {found:0.0000}, was {-point.DecidedMm:0.0000}"));

            // All samples tolerate 0.05 mm to both sides; as designed, the counterpart lacks what the part has too much.
            if (Math.Abs(found) > 0.05)
            {
                outside.Add((point.Point, Math.Abs(actual) <= 0.05));
            }
        }

        Assert.Equal(outside.Select(o => o.Point), report.Outside.Points);
        Assert.Equal(outside.Where(o => o.WasWithin).Select(o => o.Point), report.Outside.DrivenOut);
        Assert.Equal(sample == "complex-mating" ? ["2", "4"] : [], report.Outside.Points);
    }

    /// <summary>A gauge delivers parts that are all a little different; none of them may be refused because of the rounding of a program's words.</summary>
    [Theory]
    [InlineData("complex-mating", 0.003)]
    [InlineData("complex-mating", 0.01)]
    [InlineData("complex-mating", 0.04)]
    [InlineData("curve-mating", 0.01)]
    public void Parts_near_the_sample_are_all_matched(string sample, double spread)
    {
        var refused = new List<string>();
        for (var seed = 0; seed < 100; seed++)
        {
            var random = new Random(seed);
            var outcome = Outcome(sample, measurement => Shifted(measurement, () => spread * ((2 * random.NextDouble()) - 1)));
            refused.AddRange(outcome.Refusals.Select(r => FormattableString.Invariant($"{seed}: {r.Message}")));
        }

        Assert.True(refused.Count == 0, string.Join('\n', refused));
    }

    private static byte[] Shifted(byte[] csv, Func<double> shift)
    {
        var lines = Encoding.ASCII.GetString(csv).TrimEnd().Split('\n');
        var rows = lines.Skip(1).Select(l => l.TrimEnd('\r').Split(','));
        var shifted = rows.Select(r => string.Join(',', [r[0], .. r[1..].Select(v => (double.Parse(v, CultureInfo.InvariantCulture) + shift()).ToString("F4", CultureInfo.InvariantCulture))]));
        return Encoding.ASCII.GetBytes(string.Join('\n', [lines[0], .. shifted]));
    }

    private static MatchResult Match(string sample)
    {
        var outcome = Outcome(sample, m => m);
        Assert.True(outcome.Result is not null, string.Join('\n', outcome.Refusals.Select(r => r.Message)));
        return outcome.Result;
    }

    private static MatchOutcome Outcome(string sample, Func<byte[], byte[]> part)
    {
        var job = MatingJob.Read(Repository.PathTo("samples", sample, "job.json"));
        var program = job.PathOf(job.Counterpart.Program);
        return Matcher.Match(new(
            job,
            MeasurementReader.Read(job.PathOf(job.Part.Theoretical), MeasurementFormat.Points),
            MeasurementReader.Read(part(File.ReadAllBytes(job.PathOf(job.Part.Measured))), "part.csv", job.Gauge.Format),
            null,
            program,
            File.ReadAllBytes(program)));
    }
}
