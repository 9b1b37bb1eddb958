using System.Text;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>The sum of corrections counts what lies between and beside the measured points as each step does.</summary>
public sealed class SumBetweenPointsTests
{
    private static readonly PolicySettings Unlimited = Samples.NoLimits with { SumLimitMm = 5 };

    [Fact]
    public void The_sum_since_the_original_is_measured_on_the_program_itself()
    {
        using var folder = new TemporaryFolder();
        var request = Request(folder);
        var first = Samples.Program(request);
        Assert.Equal(first.LargestMm, first.SumMm);

        // The piece is measured again as it was: the same correction a second time, but from the program that was corrected.
        var second = Samples.Program(
            request with { Base = first.Program, Sums = first.Sums, Measurement = request.Measurement with { Bytes = Again(request) } },
            Unlimited);
        Assert.InRange(second.SumMm, 1.97 * first.LargestMm, 2.03 * first.LargestMm);
        Assert.True(second.SumMm >= second.Sums.Largest!.LengthMm);
    }

    [Fact]
    public void A_program_that_lies_further_between_its_points_than_their_sums_say_is_over_the_limit()
    {
        using var folder = new TemporaryFolder();
        var request = Request(folder);

        // Sums that say nothing of a base that was displaced: only the programs themselves tell.
        var first = Samples.Program(request);
        var forgetful = request with
        {
            Base = first.Program,
            Sums = CorrectionSums.None.Plus([.. first.Corrections.Select(c => c with { X = 0, Y = 0 })]),
            Measurement = request.Measurement with { Bytes = Again(request) }
        };
        var computed = Samples.Program(forgetful, Unlimited);
        Assert.True(computed.SumMm > 1.5 * computed.Sums.Largest!.LengthMm);
        var refused = Samples.Refusal(forgetful, Samples.NoLimits with { SumLimitMm = computed.SumMm - 0.01 });
        Assert.Equal(CorrectionCodes.OverSumLimit, refused.Code);
        Assert.NotNull(refused.Block);
        Assert.IsType<ComputedProgram>(Samples.Compute(forgetful, Samples.NoLimits with { SumLimitMm = computed.SumMm }));
    }

    [Fact]
    public void An_original_with_other_motions_is_named()
    {
        using var folder = new TemporaryFolder();
        var request = Request(folder);
        var first = Samples.Program(request);
        var original = folder["counterpart.nc"];
        var lines = File.ReadAllLines(original).ToList();
        lines.Insert(lines.FindLastIndex(l => l.Contains("M30", StringComparison.Ordinal)), "G0 Z123.");
        File.WriteAllLines(original, lines);
        var refused = Samples.Refusal(
            request with { Base = first.Program, Sums = first.Sums, Measurement = request.Measurement with { Bytes = Again(request) } },
            Unlimited);
        Assert.Equal(CorrectionCodes.JobChanged, refused.Code);
        Assert.Contains("original", refused.Reason, StringComparison.Ordinal);
    }

    private static byte[] Again(CorrectionRequest request) => [.. request.Measurement.Bytes.Span, .. Encoding.ASCII.GetBytes("\n")];

    private static CorrectionRequest Request(TemporaryFolder folder)
    {
        var job = Samples.Feedback(folder) with { Accumulates = true };
        File.WriteAllText(job.File, File.ReadAllText(job.File).Replace("\"mapMm\": 1", "\"mapMm\": 3", StringComparison.Ordinal));
        return new()
        {
            Job = job,
            Piece = "counterpart",
            Measurement = Samples.File("complex-mating", "counterpart.csv"),
            Part = Samples.File("complex-mating", "part.csv"),
        };
    }
}
