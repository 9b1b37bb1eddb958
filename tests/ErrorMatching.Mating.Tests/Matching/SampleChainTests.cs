using ErrorMatching.Measurement;

namespace ErrorMatching.Mating.Tests;

/// <summary>The samples, corrected again and again as a shop would: feed-forward first, then feedback on what came out.</summary>
public sealed class SampleChainTests
{
    [Theory]
    [InlineData("curve-mating")]
    [InlineData("circle-mating")]
    [InlineData("slot-mating")]
    [InlineData("complex-mating")]
    [InlineData("dovetail")]
    public void A_compensated_program_can_be_corrected_by_what_it_cut(string sample)
    {
        var job = Samples.Job(sample);
        var forward = Match(job, null, File.ReadAllBytes(job.PathOf(job.Counterpart.Program)));
        var feedback = job with { Compensation = job.Compensation with { From = CompensationSource.Counterpart } };
        var again = Match(feedback, "counterpart-after.csv", forward.Program);

        Assert.True(again.Proof.Holds);
        Assert.All(
            again.Maps.Zip(forward.Maps),
            m => Assert.Equal(m.Second.Passes.Select(p => (p.First, p.Last)), m.First.Passes.Select(p => (p.First, p.Last))));
    }

    private static MatchResult Match(MatingJob job, string? counterpart, ReadOnlyMemory<byte> program)
    {
        var outcome = Matcher.Match(new(
            job,
            MeasurementReader.Read(job.PathOf(job.Part.Theoretical), MeasurementFormat.Points),
            MeasurementReader.Read(job.PathOf(job.Part.Measured), job.Gauge.Format),
            counterpart is null ? null : MeasurementReader.Read(job.PathOf(counterpart), job.Gauge.Format),
            "counterpart.nc",
            program));
        Assert.True(outcome.Result is not null, string.Join('\n', outcome.Refusals));
        return outcome.Result;
    }
}
