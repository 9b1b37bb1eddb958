namespace ErrorMatching.Nc.Tests;

/// <summary>Where an origin is set the tool stands where it stood:
/// else all that follows would move along on the piece, although no word of it changes.</summary>
public sealed class PlaceDependentTests
{
    private const string Before = "G90 G17 G40\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nG92 X0. Y0.\nN20 G1 X5. Y5.\n";

    [Theory]
    [InlineData(true, "G92 X0. Y0.")]
    [InlineData(false, "G0 X3. Y3. Z0.\nG92 X0. Y0.")]
    public void An_end_that_moved_by_one_increment_is_found_where_an_origin_is_set(bool isFound, string origin)
    {
        var before = Before.Replace("G92 X0. Y0.", origin, StringComparison.Ordinal);
        var after = before.Replace("N10 G1 X10. Y0.", "N10 G1 X10. Y0.001", StringComparison.Ordinal);
        var proof = Verdict.OnEnds(before, after, "N10", new(0, 0.001, 0));

        Assert.Equal(!isFound, proof.Holds);
        Assert.Equal(isFound ? [4] : [], proof.Failures.Select(f => f.Place.Line));
    }

    // Behind the origin the line begins at the same numbers as before, so only the place before it shows that it moved.
    [Fact]
    public void A_displaced_line_is_found_where_an_origin_is_set_behind_it()
    {
        const string Last = "G90 G17 G40\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nG92 X0. Y0.\nM30\n";
        var after = Last.Replace("N10 G1 X10. Y0.", "N10 G1 X10. Y0.001", StringComparison.Ordinal)
            .Replace("G0 X0. Y0. Z0.", "G0 X0. Y0.001 Z0.", StringComparison.Ordinal);

        var failure = Assert.Single(Verdict.OnElements(Last, after, ("N10", 0.001)).Failures);
        Assert.Equal(4, failure.Place.Line);
    }
}
