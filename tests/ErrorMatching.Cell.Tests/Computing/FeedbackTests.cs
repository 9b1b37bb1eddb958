using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

public sealed class FeedbackTests
{
    [Fact]
    public void A_counterpart_of_a_feed_forward_job_is_recorded_and_makes_no_program()
    {
        var recorded = Assert.IsType<NothingToSend>(Samples.Compute(
            Samples.Part("complex-mating") with
            {
                Piece = "counterpart",
                Measurement = Samples.File("complex-mating", "counterpart.csv")
            }));
        Assert.Equal(CorrectionCodes.FirstArticle, recorded.Code);
        Assert.Equal(64, recorded.Basis.Identity.Length);
        Assert.Null(recorded.Report);
        Assert.EndsWith("; not-compared", Stated.As(recorded.Reason), StringComparison.Ordinal);
    }

    [Fact]
    public void The_part_of_a_feedback_job_is_recorded_and_makes_no_program()
    {
        using var folder = new TemporaryFolder();
        var part = Samples.Part("complex-mating") with { Job = Samples.Feedback(folder) };
        Assert.Equal(CorrectionCodes.PartRecorded, Assert.IsType<NothingToSend>(Samples.Compute(part)).Code);
        Assert.Equal(
            "missing-point", Samples.Refusal(part with { Measurement = new("part.csv", "point,x_mm,y_mm\n1,2,3\n"u8.ToArray()) }).Code);
    }

    [Fact]
    public void A_counterpart_waits_for_its_part()
    {
        using var folder = new TemporaryFolder();
        var counterpart = Counterpart(Samples.Feedback(folder));
        Assert.Equal(CorrectionCodes.PartUnmeasured, Samples.Refusal(counterpart with { Part = null }).Code);
        Assert.Equal(
            CorrectionCodes.PartUnmeasured,
            Assert.IsType<RefusedComputation>(new CorrectionComputer(Samples.NoLimits).Identify(counterpart with { Part = null })).Code);
        var computed = Samples.Program(counterpart);
        Assert.True(computed.ChangedWords > 0);
        Assert.NotEqual(
            computed.Basis.Identity,
            Samples.Program(counterpart with { Part = Samples.File("complex-mating", "counterpart-after.csv") }).Basis.Identity);
    }

    [Fact]
    public void A_report_without_a_lot_begins_a_new_one_and_says_so()
    {
        using var folder = new TemporaryFolder();
        var request = Counterpart(Samples.Feedback(folder) with { Accumulates = true });
        var first = Samples.Program(request);
        var old = System.Text.Encoding.UTF8.GetString(first.Report.Span).Replace("\"lot\"", "\"none\"", StringComparison.Ordinal);
        var again = request with
        {
            Measurement = Samples.File("complex-mating", "counterpart-after.csv"),
            Base = first.Program,
            Sums = first.Sums,
            Previous = new("report.json", System.Text.Encoding.UTF8.GetBytes(old)),
        };
        var next = Samples.Program(again, Samples.NoLimits with { SumLimitMm = 5 });
        Assert.Contains("a new lot begins", System.Text.Encoding.UTF8.GetString(next.Report.Span), StringComparison.Ordinal);
    }

    [Fact]
    public void Corrections_of_a_job_that_accumulates_add_up_and_the_sum_is_limited()
    {
        using var folder = new TemporaryFolder();
        var request = Counterpart(Samples.Feedback(folder) with { Accumulates = true });
        var first = Samples.Program(request);
        Assert.Equal(first.Corrections, first.Sums.Points);

        // The second piece was cut with the first correction and measured again.
        var next = request with
        {
            Measurement = Samples.File("complex-mating", "counterpart-after.csv"),
            Base = first.Program,
            Sums = CorrectionSums.FromJson(first.Sums.ToJson())
        };
        var policy = Samples.NoLimits with { SumLimitMm = 5 };
        var second = Samples.Program(next, policy);
        Assert.Equal(Convert.ToHexStringLower(System.Security.Cryptography.SHA256.HashData(first.Program.Span)), second.Basis.BaseSha256);
        Assert.NotEqual(first.Basis.Identity, second.Basis.Identity);
        for (var i = 0; i < first.Corrections.Count; i++)
        {
            var (a, b, sum) = (first.Corrections[i], second.Corrections[i], second.Sums.Points[i]);
            Assert.Equal((a.Point, a.X + b.X, a.Y + b.Y), (sum.Point, sum.X, sum.Y));
        }

        // Between two points the program lies further from the original one than at any of them.
        Assert.True(second.SumMm > second.Sums.Points.Max(p => Math.Sqrt((p.X * p.X) + (p.Y * p.Y))));

        var refused = Samples.Refusal(next, policy with { SumLimitMm = second.SumMm - 0.0001 });
        Assert.Equal(CorrectionCodes.OverSumLimit, refused.Code);
        Assert.Contains($"At block {refused.Block} ", refused.Reason.Sentence, StringComparison.Ordinal);
        Assert.IsType<ComputedProgram>(Samples.Compute(next, policy with { SumLimitMm = second.SumMm }));
    }

    [Fact]
    public void Without_a_limit_of_its_own_the_sum_has_that_of_one_step()
    {
        using var folder = new TemporaryFolder();
        var request = Counterpart(Samples.Feedback(folder) with { Accumulates = true });
        var policy = Samples.NoLimits with { LimitMm = 0.9 };
        Assert.IsType<ComputedProgram>(Samples.Compute(request, policy));
        var tired = request with
        {
            Base = File.ReadAllBytes(folder["counterpart.nc"]),
            Sums = CorrectionSums.None.Plus([new("elsewhere", 0.91, 0, 0)])
        };
        Assert.Equal(CorrectionCodes.OverSumLimit, Samples.Refusal(tired, policy).Code);
        Assert.IsType<ComputedProgram>(Samples.Compute(tired, policy with { SumLimitMm = 0.92 }));
    }

    [Fact]
    public void A_measurement_that_the_program_follows_already_is_not_applied_again()
    {
        using var folder = new TemporaryFolder();
        var request = Counterpart(Samples.Feedback(folder) with { Accumulates = true });
        var first = Samples.Program(request);
        Assert.Equal("same-measurement", Samples.Refusal(request with { Base = first.Program, Sums = first.Sums }).Code);
    }

    [Fact]
    public void Only_feedback_accumulates()
    {
        var part = Samples.Part("complex-mating");
        Assert.Equal(CorrectionCodes.NotFeedback, Samples.Refusal(part with { Job = part.Job with { Accumulates = true } }).Code);
    }

    [Fact]
    public void A_correction_never_starts_from_another_program_by_accident()
    {
        using var folder = new TemporaryFolder();
        var request = Counterpart(Samples.Feedback(folder));
        Assert.Throws<ArgumentException>(() => Samples.Compute(request with { Base = "M30"u8.ToArray() }));
        Assert.Throws<ArgumentException>(() => Samples.Compute(
            request with { Job = request.Job with { Accumulates = true }, Sums = CorrectionSums.None.Plus([new("1", 1, 0, 0)]) }));
    }

    private static CorrectionRequest Counterpart(CellJobSettings job) => new()
    {
        Job = job,
        Piece = "counterpart",
        Measurement = Samples.File("complex-mating", "counterpart.csv"),
        Part = Samples.File("complex-mating", "part.csv"),
    };
}
