using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>Named elements that are right at their ends and wrong between, or the wrong way round.</summary>
public sealed class ElementProofTests
{
    // A quarter of radius 10 about (0, 0), and a whole turn, which both go by (0.1, 0.2): start, middle and end alike.
    // A center that is 0.01 off along the middle's ray leaves the ends right and the middle 0.414 * 0.01 off.
    [Theory]
    [InlineData("X0. Y10.", "X0.1 Y10.2 I-10. J0.", true)]
    [InlineData("X0. Y10.", "X0.1 Y10.2 I-9.99 J0.01", false)]
    [InlineData("X10. Y0.", "X10.1 Y0.2 I-10. J0.", true)]
    [InlineData("X10. Y0.", "X10.1 Y0.2 I-10. J0.005", false)]
    [InlineData("X10. Y0.", "X10.1 Y0.2 I-10.005 J0.", false)]
    public void An_arc_that_goes_by_a_vector_takes_its_center_along(string end, string result, bool holds)
    {
        var before = $"G90 G17\nG0 X10. Y0. Z0.\nN10 G3 {end} I-10. J0. F100\nG0 Z5.\n";
        var after = $"G90 G17\nG0 X10.1 Y0.2 Z0.\nN10 G3 {result} F100\nG0 Z5.\n";
        var path = Bench.Read(before);
        var by = new Vector2(0.1, 0.2);
        var wish = DisplacementWish.OfElements([new(path.MotionOf(Bench.Blocks(path, "N10")[0]), by, by, by)]);

        Assert.Equal(holds, Prover.Check(path, NcProgram.FromText(after), wish, 0.001).Holds);
    }

    [Fact]
    public void An_arc_that_would_vanish_is_not_proved()
    {
        const string Before = "G90 G17\nG0 X10. Y0. Z0.\nN10 G3 X0. Y10. I-10. J0. F100\nG0 Z5.\n";
        var failures = Verdict.OnElements(Before, Before, ("N10", 10)).Failures;

        Assert.Contains(failures, f => f.Message.Contains("no circle runs", StringComparison.Ordinal));
    }

    // Half a millimeter long, it may go 1.302 mm: far enough for its ends to change places on the right line.
    [Fact]
    public void A_line_that_turned_round_is_not_proved()
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X0.5 Y0. F100\nG0 Z5.\n";
        const string After = "G90 G17\nG0 X0.5 Y0.1 Z0.\nN10 G1 X0. Y0.1 F100\nG0 Z5.\n";
        var failures = Verdict.OnElements(Before, After, ("N10", 0.1)).Failures;

        Assert.Contains(failures, f => f.Message.Contains("turned round", StringComparison.Ordinal));
    }
}
