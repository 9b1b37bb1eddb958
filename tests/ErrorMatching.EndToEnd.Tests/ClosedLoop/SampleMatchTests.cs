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
        foreach (var point in report.KeyPoints)
        {
            var normal = new Flat(point.Normal.X, point.Normal.Y);
            var actual = (point.Actual - point.Theoretical).Dot(point.Normal);
            var found = cut.Probe(new(point.Theoretical.X, point.Theoretical.Y), normal) - actual;
            Assert.True(Math.Abs(found - point.PredictedMm) <= 0.003, FormattableString.Invariant($"{sample} {point.Point}: predicted {point.PredictedMm:0.0000}, cut {found:0.0000}, was {-point.DecidedMm:0.0000}"));
        }
    }

    private static MatchResult Match(string sample)
    {
        var job = MatingJob.Read(Repository.PathTo("samples", sample, "job.json"));
        var program = job.PathOf(job.Counterpart.Program);
        var outcome = Matcher.Match(new(
            job,
            MeasurementReader.Read(job.PathOf(job.Part.Theoretical), MeasurementFormat.Points),
            MeasurementReader.Read(job.PathOf(job.Part.Measured), job.Gauge.Format),
            null,
            program,
            File.ReadAllBytes(program)));
        Assert.True(outcome.Result is not null, string.Join('\n', outcome.Refusals.Select(r => r.Message)));
        return outcome.Result;
    }
}
