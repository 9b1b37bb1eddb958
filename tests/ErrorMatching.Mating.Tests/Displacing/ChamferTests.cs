namespace ErrorMatching.Mating.Tests;

/// <summary>
/// A straight cut between the flanks of a wedge. No key point lies on it, so its ends take what the flanks beside them take:
/// each end goes with its own flank. The proof compares the program with the wish, so only this says that the wish is right.
/// </summary>
public sealed class ChamferTests
{
    // A notch with flanks 4x + 3y = 0 and 4x - 3y = 120 and a bottom from (12, -16) to (18, -16).
    private const string Blunt = "%\nO1000\nN10 G21 G90 G17\nN20 G0 X-20. Y20.\nN30 G1 G41 D1 Y0. F300\nN40 X0.\n"
        + "N50 X12. Y-16.\nN55 X18.\nN60 X30. Y0.\nN70 X50.\nN80 G40 Y20.\nN90 M30\n%\n";

    private const string BluntFromBehind = "%\nO1000\nN10 G21 G90 G17\nN20 G0 X50. Y20.\nN30 G1 G42 D1 Y0. F300\nN40 X30.\n"
        + "N50 X18. Y-16.\nN55 X12.\nN60 X0. Y0.\nN70 X-20.\nN80 G40 Y20.\nN90 M30\n%\n";

    // The first flank goes 0.1 along its normal (0.8, 0.6), to 4x + 3y = 0.5, and the second stays.
    // The bottom goes 0.1 up at x = 12 and stays at x = 18: y = -15.7 - x / 60.
    // It meets the first flank at x = 47.6 / 3.95 = 12.0506, y = -15.9008, and the second where it did.
    [Fact]
    public void Each_end_of_a_chamfer_goes_with_its_own_flank() =>
        Assert.Equal(
            ["N40 X0.125", "N50 X12.051 Y-15.901", "N55 X18. Y-16."], Match(Blunt, "1 3.08 -3.94; 2 9.08 -11.94; 3 21 -12; 4 27 -4"));

    // The same seen in a mirror: 4x - 3y = 119.5 and y = -16.2 + x / 60.
    [Fact]
    public void The_other_flank_takes_the_other_end() =>
        Assert.Equal(["N55 X17.949 Y-15.901", "N60 X29.875 Y0."], Match(Blunt, "1 3 -4; 2 9 -12; 3 20.92 -11.94; 4 26.92 -3.94"));

    [Fact]
    public void The_sense_of_the_cut_changes_nothing() =>
        Assert.Equal(
            ["N55 X12.051 Y-15.901", "N60 X0.125 Y0."],
            Match(BluntFromBehind, "1 3.08 -3.94; 2 9.08 -11.94; 3 21 -12; 4 27 -4"));

    // A quarter of the bottom takes a quarter of the way from one flank's amount to the other's: 0.1, 0.075 and 0 in one line.
    [Fact]
    public void A_chamfer_in_two_blocks_stays_straight()
    {
        var parted = Blunt.Replace("N55 X18.", "N53 X13.5\nN55 X18.", StringComparison.Ordinal);
        var now = Match(parted, "1 3.08 -3.94; 2 9.08 -11.94; 3 21 -12; 4 27 -4");

        Assert.Equal(["N40 X0.125", "N50 X12.051 Y-15.901", "N53 X13.5 Y-15.925", "N55 X18. Y-16."], now);
    }

    private static string[] Match(string program, string part) => new MatchCase(program)
    {
        Theoretical = "1 3 -4; 2 9 -12; 3 21 -12; 4 27 -4",
        Part = part,
        Features = [MatchCase.Feature("triangle", "T1", "N50..N60", """[["1", "2"], ["3", "4"]]""")],
    }.Changed();
}
