using System.Text;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The dovetail, whose part's true errors are known: the key is judged by them, not by what was measured.</summary>
public sealed class DovetailSampleTests
{
    private const string Sample = "dovetail";

    /// <summary>Rounding of the program's words and chords of the cam, mm.</summary>
    private const double ProgramMm = 0.001;

    [Fact]
    public void Files_are_as_they_were_made()
    {
        Assert.Equal(DovetailPart.Theoretical, SampleFile.Text(Sample, "theoretical.csv"));
        Assert.Equal(DovetailPart.Part, SampleFile.Text(Sample, "part.csv"));
        Assert.Equal(DovetailPart.Before, SampleFile.Text(Sample, "counterpart.csv"));
        Assert.Equal(DovetailPart.After, SampleFile.Text(Sample, "counterpart-after.csv"));
        Assert.Equal(28, DovetailPart.KeyPoints.Count);
    }

    [Fact]
    public void Program_cuts_the_outline_as_designed()
    {
        var cut = Cut(SampleFile.Text(Sample, "counterpart.nc"));

        Assert.All(DovetailPart.KeyPoints, p => Assert.InRange(cut.Clearance(p.Place), -ProgramMm, ProgramMm));
        Assert.All(DovetailPart.KeyPoints, p => Assert.InRange(cut.Probe(p.Place, p.Normal), -ProgramMm, ProgramMm));
        // Everywhere else, it leaves at most what the tool cannot reach at both ends of the cam.
        Assert.All(DovetailPart.Everywhere, p => Assert.InRange(cut.Clearance(p.Place), -ProgramMm, 0.1));
    }

    [Fact]
    public void Key_follows_the_true_part_and_not_only_its_points()
    {
        var nominal = Cut(SampleFile.Text(Sample, "counterpart.nc"));
        var result = Match();
        var report = MatchReporter.Report(result, "counterpart.nc", 0);
        var cut = Cut(Encoding.ASCII.GetString(result.Program.Span));

        Assert.True(report.Proof.Holds);
        Assert.Empty(report.Outside.Points);
        AssertFollows(DovetailPart.KeyPoints);
        AssertFollows([.. DovetailPart.Everywhere.Where(p => nominal.Clearance(p.Place) <= ProgramMm)]);

        // A good estimate leaves little more than the limits allow to stay; a third is what every good one stays below.
        void AssertFollows(IReadOnlyList<DovetailPoint> points)
        {
            var before = Rms(points.Select(p => p.TrueMm));
            var left = Rms(points.Select(p => cut.Probe(p.Place, p.Normal) - p.TrueMm));
            Assert.InRange(left, 0, before / 3);
        }
    }

    [Fact]
    public void Each_element_out_of_its_limits_loses_two_thirds_of_its_error_or_more()
    {
        var cut = Cut(Encoding.ASCII.GetString(Match().Program.Span));
        var elements = DovetailPart.KeyPoints.Where(p => p.Element is not ("L1" or "L2")).GroupBy(p => p.Element).ToArray();

        Assert.Equal(8, elements.Length);
        Assert.All(elements, e => Assert.InRange(
            Rms(e.Select(p => cut.Probe(p.Place, p.Normal) - p.TrueMm)), 0, Rms(e.Select(p => p.TrueMm)) / 3));
    }

    private static double Rms(IEnumerable<double> values) => Math.Sqrt(values.Average(v => v * v));

    private static VirtualCut Cut(string program) => new(RefereeInterpreter.Run(program), DovetailPart.ToolRadius);

    private static MatchResult Match()
    {
        var job = MatingJob.Read(Repository.PathTo("samples", Sample, "job.json"));
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
