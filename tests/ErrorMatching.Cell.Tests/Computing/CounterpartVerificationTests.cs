using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>What a measured counterpart of a feed-forward job says of the program that cut it.
/// Figures are the paper's (Wang 2021, section 4.3).</summary>
public sealed class CounterpartVerificationTests
{
    [Fact]
    public void A_counterpart_is_compared_with_the_part_that_its_program_was_made_for()
    {
        var recorded = Recorded(Counterpart());
        using var report = JsonDocument.Parse(recorded.Report!.Value);
        Assert.Equal("errormatch/verify/1", report.RootElement.GetProperty("schema").GetString());
        var angle = report.RootElement.GetProperty("features").EnumerateArray().Single(f => f.GetProperty("name").GetString() == "L1-L2");
        Assert.Equal(
            (81, true),
            (
                Math.Round(angle.GetProperty("improvementPercent").GetDouble()),
                report.RootElement.GetProperty("beforeMeasured").GetBoolean()));
        Assert.Contains(
            "counterpart against part", System.Text.Encoding.UTF8.GetString(recorded.Page!.Value.Span), StringComparison.Ordinal);
        Assert.StartsWith("first-article; ", Stated.As(recorded.Reason), StringComparison.Ordinal);
    }

    [Fact]
    public void Where_no_counterpart_was_cut_without_compensation_it_is_taken_as_designed()
    {
        using var folder = new TemporaryFolder();
        var job = Samples.Copied(folder);
        File.WriteAllText(job.File, File.ReadAllText(job.File).Replace("\"measured\": \"counterpart.csv\",", "", StringComparison.Ordinal));
        using var report = JsonDocument.Parse(Recorded(Counterpart() with { Job = job }).Report!.Value);
        Assert.False(report.RootElement.GetProperty("beforeMeasured").GetBoolean());
    }

    [Fact]
    public void What_cannot_be_compared_is_evidence_all_the_same()
    {
        using var folder = new TemporaryFolder();
        var job = Samples.Copied(folder);
        File.Delete(folder["counterpart.csv"]);
        var recorded = Recorded(Counterpart() with { Job = job });
        Assert.Null(recorded.Report);
        Assert.Contains("not-comparable(", Stated.As(recorded.Reason), StringComparison.Ordinal);
        Assert.Contains("counterpart.csv", recorded.Reason.Sentence, StringComparison.Ordinal);
    }

    // Compared with itself, it would be within all limits.
    [Fact]
    public void A_copy_of_the_parts_measurement_verifies_nothing()
    {
        var recorded = Recorded(Counterpart() with { Measurement = Samples.File("complex-mating", "part.csv") });
        Assert.Null(recorded.Report);
        Assert.Contains("not-comparable(", Stated.As(recorded.Reason), StringComparison.Ordinal);
        Assert.Contains("part.csv", recorded.Reason.Sentence, StringComparison.Ordinal);
    }

    [Fact]
    public void The_record_says_how_many_points_are_outside_their_limits() => Assert.Matches(
        @"^first-article; verified-outside\(\d+, 16, .*\)$", Stated.As(Recorded(Counterpart()).Reason));

    private static CorrectionRequest Counterpart() =>
        Samples.Part("complex-mating") with
        {
            Piece = "counterpart",
            Measurement = Samples.File("complex-mating", "counterpart-after.csv"),
            Part = Samples.File("complex-mating", "part.csv")
        };

    private static NothingToSend Recorded(CorrectionRequest request)
    {
        var recorded = Assert.IsType<NothingToSend>(Samples.Compute(request));
        Assert.Equal(CorrectionCodes.FirstArticle, recorded.Code);
        return recorded;
    }
}
