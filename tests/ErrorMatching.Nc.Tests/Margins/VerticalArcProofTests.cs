using System.Globalization;
using System.Text.RegularExpressions;

namespace ErrorMatching.Nc.Tests;

/// <summary>What the proof finds in results with arcs that lead into a contour in a vertical plane: each of their coordinates
/// matters.</summary>
public sealed partial class VerticalArcProofTests
{
    private const string Program = "G90 G17\nN1 G0 X20. Y-10.\nN2 G0 Z10.\nN3 G1 Z2. F100\nN4 G18 G3 X18. Z0. I-2. K0.\nN5 G17 G1 X10.\n"
        + "N6 Y10.\n"
        + "N7 X-10.\nN8 G18 G3 X-12. Z2. I0. K2.\nN9 G1 Z10.\nN10 G17\nN11 G0 X0. Y0.\nM30\n";

    private const string Left = "an upright arc left its plane: its ends moved differently across it.";
    private const string Unnamed = "it moved although neither it nor a motion beside it was named.";

    // N5 goes by -0.1 in Y, across the plane of N4: so must the rapid.
    private static readonly string Across = Program.Replace("Y-10.", "Y-10.1", StringComparison.Ordinal)
        .Replace("X10.", "X9.9", StringComparison.Ordinal).Replace("Y10.", "Y9.9", StringComparison.Ordinal);

    // N5 goes by -0.1 in X, along the plane of N4.
    private static readonly string Along = Program.Replace("N5 G17 G1 X10.\nN6 Y10.", "N5 G17 G1 Y10.", StringComparison.Ordinal);

    private static readonly string MovedAlong =
        Along.Replace("X20.", "X19.9", StringComparison.Ordinal).Replace("X18.", "X17.9", StringComparison.Ordinal);

    [Fact]
    public void Right_results_are_proved()
    {
        Assert.Empty(Of(Across));
        Assert.Empty(Of(MovedAlong, Along, "N5"));
    }

    // The start stays while the end goes: a helix, which no word of the arc shows if Y is in its block.
    [Fact]
    public void An_arc_whose_start_stays_behind_is_a_helix() => Assert.Contains(
        "5 N4: " + Left,
        Of(Across.Replace("Y-10.1", "Y-10.", StringComparison.Ordinal)
            .Replace("G18 G3 X18. Z0.", "G18 G3 X18. Y-10.1 Z0.", StringComparison.Ordinal)));

    [Fact]
    public void The_line_before_it_does_not_take_up_the_difference() => Assert.NotEmpty(
        Of(Across.Replace("Y-10.1", "Y-10.", StringComparison.Ordinal).Replace("N3 G1 Z2.", "N3 G1 Y-10.1 Z2.", StringComparison.Ordinal)));

    [Theory]
    [InlineData("N4 G18 G3", "N4 G3")]
    [InlineData("N4 G18 G3", "N4 G19 G3")]
    [InlineData("N4 G18 G3", "N4 G17 G3")]
    [InlineData("N4 G18 G3", "N4 G18 G2")]
    [InlineData("N5 G17 G1", "N5 G1")]
    [InlineData("N8 G18 G3", "N8 G3")]
    [InlineData("N8 G18 G3", "N8 G18 G2")]
    [InlineData("N10 G17\n", "N10\n")]
    public void A_lost_plane_or_another_sense_is_found(string words, string lost)
    {
        Assert.Contains(words, Across, StringComparison.Ordinal);
        Assert.NotEmpty(Of(Across.Replace(words, lost, StringComparison.Ordinal)));
    }

    // Each number of the lead and its contour, more and less by two increments.
    [Fact]
    public void No_coordinate_of_a_lead_can_be_another()
    {
        foreach (var (result, before, named) in new[] { (Across, Program, "N5..N7"), (MovedAlong, Along, "N5") })
        {
            var mutants = Coordinate().Matches(result).SelectMany(m => new[] { 0.002, -0.002 }.Select(by =>
                result[..m.Index] + (double.Parse(m.Value, CultureInfo.InvariantCulture) + by).ToString("0.0##",
                    CultureInfo.InvariantCulture)
                    + result[(m.Index + m.Length)..])).ToArray();
            Assert.InRange(mutants.Length, 30, 50);
            Assert.All(mutants, m => Assert.True(Of(m, before, named).Length > 0, m));
        }
    }

    // Its ends go alike to 1e-9, across its plane and along it.
    [Theory]
    [InlineData("X20.", "Y-10.1", true)]
    [InlineData("X20.", "Y-10.1000000008", true)]
    [InlineData("X20.", "Y-10.1000000012", false)]
    [InlineData("X20.0000000008", "Y-10.1", true)]
    [InlineData("X20.0000000012", "Y-10.1", false)]
    public void A_free_lead_goes_as_one(string x, string y, bool isProved)
    {
        var before = Program.Replace("X18. Z0.", "X18. Y-10. Z0.", StringComparison.Ordinal);
        var after = Across.Replace("X18. Z0.", "X18. Y-10.1 Z0.", StringComparison.Ordinal);
        Assert.Equal(isProved, Of(after.Replace("X20. Y-10.1", x + " " + y, StringComparison.Ordinal), before).Length == 0);
    }

    // The center goes along to 1e-6.
    [Theory]
    [InlineData("X17.9 Z0. I-2. K0.")]
    [InlineData("X17.9 Z0. I-2.0000009 K0.")]
    [InlineData("X17.9 Z0. I-2.0000015 K0.", "N4: an upright arc has another radius although it moved as a whole.",
        "N4: it lies 0.0000 mm from where it was wanted.")]
    [InlineData("X17.9 Z0. I-2. K0.0000015", "N4: it lies 0.0000 mm from where it was wanted.")]
    public void The_center_goes_along_to_a_nanometer(string arc, params string[] found) => Assert.Equal(
        found.Where(f => f[1] == '4'),
        Of(MovedAlong.Replace("X17.9 Z0. I-2. K0.", arc, StringComparison.Ordinal), Along, "N5").Select(f => f[2..])
            .Where(f => f.StartsWith("N4", StringComparison.Ordinal)));

    // Where both of its ends are held, one arc becomes another in its plane: through its old middle, moved by half.
    [Fact]
    public void An_arc_between_two_places_stays_in_its_plane()
    {
        const string Held = "G90 G17\nG0 X40. Y-10.\nG1 Z0. F100\nN3 X22.\nN4 G18 G3 X20. Z2. K2.\nN5 G3 X18. Z0. I-2.\n";
        const string Rest = "N6 G17 G1 Y10.\nN7 G0 Z9.\n";
        var result = Bench.Normal(Held + Rest, 0.1, "N6");
        Assert.Empty(Verdict.OnElements(Held + Rest, result, ("N6", 0.1)).Failures);

        foreach (var letter in "IKXZ")
        {
            foreach (var by in new[] { 0.01, -0.01 })
            {
                var mutant = Regex.Replace(
                    result, $"(?<=^N4 .*{letter})-?[0-9.]+", m => (double.Parse(m.Value, CultureInfo.InvariantCulture) + by).ToString(
                        "0.0##", CultureInfo.InvariantCulture), RegexOptions.Multiline, TimeSpan.FromSeconds(1));
                Assert.True(mutant == result || Verdict.OnElements(Held + Rest, mutant, ("N6", 0.1)).Failures.Count > 0, mutant);
            }
        }
    }

    // The cut before the lead is another one: it ends where it did.
    [Fact]
    public void A_cut_of_the_same_depth_before_the_lead_stays()
    {
        const string Held = "G90 G17\nG0 X40. Y-10.\nG1 Z0. F100\nN3 X22. Y-10.\nN4 G18 G3 X20. Z2. K2.\nN5 G3 X18. Z0. I-2.\n"
            + "N6 G17 G1 X10.\nN7 G0 Z9.\n";

        Assert.Equal(
            ["4 N3: " + Unnamed, "5 N4: " + Unnamed],
            Verdict.Found(Verdict.OnElements(Held, Held.Replace("N3 X22. Y-10.", "N3 X22. Y-10.1", StringComparison.Ordinal), ("N6", 0.1)))
                .Where(f => f.EndsWith(Unnamed, StringComparison.Ordinal)));
    }

    // By a vector in space, the arc goes along in all three coordinates, and the plunge before it ends as much lower.
    [Theory]
    [InlineData("Z2.3", "Z0.3", true)]
    [InlineData("Z2.", "Z0.3", false)]
    [InlineData("Z2.3", "Z0.", false)]
    [InlineData("Z2.302", "Z0.3", false)]
    public void Ends_by_a_vector_in_space_take_the_arc_along(string plunge, string end, bool isRight)
    {
        var result = Program.Replace("X20. Y-10.", "X20.1 Y-9.8", StringComparison.Ordinal)
            .Replace("N3 G1 Z2.", "N3 G1 " + plunge, StringComparison.Ordinal)
            .Replace("N4 G18 G3 X18. Z0.", "N4 G18 G3 X18.1 " + end, StringComparison.Ordinal)
            .Replace("N5 G17 G1 X10.", "N5 G17 G1 X10. Y-10. Z0.", StringComparison.Ordinal);
        var before = Program.Replace("N5 G17 G1 X10.", "N5 G17 G1 X10. Y-10. Z0.", StringComparison.Ordinal);

        Assert.Equal(isRight, Verdict.OnEnds(before, result, "N4", new(0.1, 0.2, 0.3)).Holds);
    }

    private static string[] Of(string result, string before = Program, string named = "N5..N7")
    {
        var path = Bench.Read(before);
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, named), 0.1));
        return Verdict.Found(Prover.Check(path, NcProgram.FromText(result), wish, 0.001));
    }

    [GeneratedRegex("(?<=^N[1-9] .*[XYZIK])-?[0-9.]+", RegexOptions.Multiline, 1000)]
    private static partial Regex Coordinate();
}
