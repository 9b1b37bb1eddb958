namespace ErrorMatching.Nc.Tests;

/// <summary>How far the joint of a named line may be from where its wish or a neighbor puts it, on both sides of each margin. The line
/// N10 goes from (0, 0) to (10, 0) and is displaced to y = 0.1.</summary>
public sealed class JointMarginTests
{
    // A free end moves by its wish, to one increment.
    [Theory]
    [InlineData("X0.", "X10.0009")]
    [InlineData("X0.", "X9.9991")]
    [InlineData("X0.", "X10.0011", "N10: an end moved by (0.001, 0.100), where neither the wish nor a neighbor puts it.")]
    [InlineData("X0.", "X9.9989", "N10: an end moved by (-0.001, 0.100), where neither the wish nor a neighbor puts it.")]
    [InlineData("X0.0009", "X10.")]
    [InlineData("X0.0011", "X10.", "N10: an end moved by (0.001, 0.100), where neither the wish nor a neighbor puts it.")]
    public void A_free_end_moves_by_its_wish(string start, string end, params string[] found) =>
        Assert.Equal(found, Found("G0 Z5.\n", start, end, "G0 Z5.\n"));

    // N20 rises by 45 degrees: the two meet at (10.1, 0.1). An end d further is 0.707 d off. 0.75 increments are allowed.
    [Theory]
    [InlineData("X10.1")]
    [InlineData("X10.101")]
    [InlineData("X10.099")]
    [InlineData("X10.1011", "N10: an end moved by (0.101, 0.100), where neither the wish nor a neighbor puts it.")]
    [InlineData("X10.0989", "N10: an end moved by (0.099, 0.100), where neither the wish nor a neighbor puts it.")]
    public void An_end_is_on_the_line_of_its_neighbor(string end, params string[] found) =>
        Assert.Equal(found, Found("N20 X20. Y10.\nG0 Z5.\n", "X0.", end, "N20 X20. Y10.\nG0 Z5.\n"));

    // The circle of radius 5 about (13, -4) crosses y = 0.1 at x = 13 - sqrt(25 - 4.1^2) = 10.13818.
    // An end d further is 0.5724 d inside. 1.6 increments are allowed. By its radius, the whole arc goes along. One that does
    // not slide should pass its old middle, moved by half of what its end moved.
    [Theory]
    [InlineData("X10.1382")]
    [InlineData("X10.1399")]
    [InlineData("X10.1365")]
    [InlineData(
        "X10.1411",
        "N10: an end moved by (0.141, 0.100), where neither the wish nor a neighbor puts it.",
        "N20: it lies 0.0783 mm from where it was wanted.")]
    [InlineData(
        "X10.1353",
        "N10: an end moved by (0.135, 0.100), where neither the wish nor a neighbor puts it.",
        "N20: it lies 0.0733 mm from where it was wanted.")]
    public void An_end_is_on_the_circle_of_its_neighbor(string end, params string[] found) =>
        Assert.Equal(found, Found("N20 G2 X18. Y-4. R5.\nG0 Z5.\n", "X0.", end, "N20 G2 X18. Y-4. R5.\nG0 Z5.\n"));

    // N20 goes on in the same direction, or turns by less than 5.7 degrees: its line then says nothing about the end of N10.
    [Theory]
    [InlineData("X20. Y0.5", "X10.05")] // 2.9 degrees
    [InlineData("X20. Y0.98", "X10.05")] // 5.6 degrees
    public void A_tangent_neighbor_puts_no_end(string neighbor, string end) =>
        Assert.Contains(
            "N10: an end moved by (0.050, 0.100), where neither the wish nor a neighbor puts it.",
            Found($"N20 {neighbor}\nG0 Z5.\n", "X0.", end, $"N20 {neighbor}\nG0 Z5.\n"));

    // At 5.8 degrees, N20 meets y = 0.1 at x = 10 + 0.1 / 0.1016 = 10.98425.
    [Fact]
    public void A_neighbor_that_turns_by_more_puts_the_end() =>
        Assert.Empty(Found("N20 X20. Y1.016\nG0 Z5.\n", "X0.", "X10.9843", "N20 X20. Y1.016\nG0 Z5.\n"));

    private static string[] Found(string rest, string start, string end, string restNow) =>
    [
        .. Verdict.OnElements(
            "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\n" + rest,
            $"G90 G17\nG0 {start} Y0.1 Z0.\nN10 G1 {end} Y0.1 F100\n{restNow}",
            ("N10", 0.1)).Failures.Select(f => f.Message),
    ];
}
