namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Section 4.2 of the paper, recomputed from tables 2, 3 and 4 as printed.</summary>
public sealed class CurveMatingTableTests
{
    private static readonly PublishedTable Part = PublishedTable.CurvePart;
    private static readonly PublishedTable Before = PublishedTable.CurveBefore;
    private static readonly PublishedTable After = PublishedTable.CurveAfter;

    // The paper's figure for the uncompensated counterpart: its converted column moved back by the tool radius.
    // It is a test of the reading, not an error that a gauge would find: the plain difference of the tables is 0.320.
    [Fact]
    public void Uncompensated_error_is_0_116_at_point_8()
    {
        Assert.Equal((0.116m, "8"), Before.LargestDifference("converted_x_mm", Part, "x_mm", Part.Points, add: 3));
        Assert.Equal((0.320m, "5"), Before.LargestDifference("measured_x_mm", Part, "x_mm", Part.Points));
    }

    [Fact]
    public void Compensated_error_is_0_048_but_for_the_misprint_of_point_7()
    {
        Assert.Equal((0.128m, "7"), After.LargestDifference("measured_x_mm", Part, "x_mm", Part.Points));
        Assert.Equal((0.048m, "1"), After.LargestDifference("measured_x_mm", Part, "x_mm", Part.Points.Where(p => p != "7")));
        Assert.Equal(1.439m, After.At("7", "measured_x_mm"));
        Assert.Equal(0.028m, 1.339m - Part.At("7", "x_mm"));
    }

    // No reading of the tables gives the 28 % of the abstract.
    [Fact]
    public void Improvement_is_59_percent() => Assert.Equal(59, Math.Round(100 * (1 - (0.048m / 0.116m))));

    [Fact]
    public void Uncompensated_counterpart_lies_beyond_the_part_at_every_point() =>
        Assert.All(Part.Points, p => Assert.InRange(Before.At(p, "measured_x_mm") - Part.At(p, "x_mm"), 0.2m, 0.32m));
}
