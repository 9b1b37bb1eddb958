using ErrorMatching.Nc;

namespace ErrorMatching.Mating.Tests;

/// <summary>Matches of programs under cutter compensation: what the job's tool could not cut is refused, and key points that it does not
/// touch are named.</summary>
public sealed class CompensatedMatchTests
{
    // A slot of 8.1 mm that is open to the left: its floor N50, its end N60 and its ceiling N70. The tool is inside.
    private const string Slot = "%\nO1000\nN10 G21 G90 G17\nN20 G0 X-20. Y4.\nN30 G1 G41 D1 X-10. Y0. F300\nN40 X0.\n"
        + "N50 X40.\nN60 Y8.1\nN70 X-10.\nN80 G40 X-20. Y4.\nN90 M30\n%\n";

    [Fact]
    public void A_correction_after_which_the_tool_still_fits_is_made() =>
        Assert.Equal(["N40 X0. Y0.05"], Floor(8, 0.05).Changed());

    [Fact]
    public void A_correction_after_which_the_tool_no_longer_fits_is_refused_with_its_block()
    {
        // 8.1 - 0.15 mm is less than its diameter.
        var refusal = Floor(8, 0.15).Refusal();
        Assert.Equal((NcRefusalCodes.CompensationGouge, "N60", 8), (refusal.Code, refusal.Place.Block, refusal.Place.Line));
        Assert.Contains(" 4 mm", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_program_that_the_job_s_tool_cannot_cut_is_refused_whatever_is_measured()
    {
        var refusal = Floor(9, 0).Refusal();
        Assert.Equal((NcRefusalCodes.CompensationGouge, "N60"), (refusal.Code, refusal.Place.Block));
    }

    [Theory]
    [InlineData(40, true)]
    [InlineData(36, false)]
    public void A_point_in_the_round_of_an_inside_corner_is_named(double x, bool isNamed)
    {
        // A tool of 3 mm passes the corner at 3 (sqrt 2 - 1) mm.
        var place = FormattableString.Invariant($"2 {x}");
        var warnings = (Floor(6, 0.1) with { Theoretical = $"1 10 0; {place} 0", Part = $"1 10 0.1; {place} 0.1" }).Report().Warnings;
        Assert.Equal(isNamed, warnings.Any(w => w is { Code: "point-not-reached", Values: ["2", "1.243", "N50"] }));
    }

    [Fact]
    public void The_wish_stores_the_tool_for_another_proof() =>
        Assert.Equal(3, Floor(6, 0.1).Match().WishFile().ToolRadii.Otherwise);

    [Theory]
    [InlineData("G41.1 D6", "linuxcnc", null)]
    [InlineData("G41.1 D6.2", "linuxcnc", "3.1")]
    [InlineData("G41 D1", "linuxcnc", null)]
    public void Another_radius_in_the_block_than_the_tool_s_is_warned_of(string on, string dialect, string? radius)
    {
        var program = Slot.Replace("G41 D1", on, StringComparison.Ordinal);
        var match = new MatchCase(program)
        {
            ToolDiameterMm = 6,
            Dialect = dialect,
            Theoretical = "1 10 0; 2 30 0",
            Part = "1 10 0.05; 2 30 0.05",
        };
        Assert.Equal(radius is null ? [] : new[] { $"N50 {radius} 3" }, Differing(match));
    }

    [Theory]
    [InlineData("TOOL CALL 1 Z S3000", null)]
    [InlineData("TOOL CALL 1 Z S3000 DR+0.2", "3.2")]
    [InlineData("TOOL DEF 1 L+0 R+2.5\nTOOL CALL 1 Z S3000", "2.5")]
    public void Another_radius_in_a_tool_call_than_the_tool_s_is_warned_of(string call, string? radius)
    {
        var match = new MatchCase($"0 BEGIN PGM A MM\n{call}\n1 L X-20 Y+4 Z+0 R0 FMAX\n2 L X-10 Y+0 RL F300\n5 L X+40\n6 L Y+8.1\n"
            + "7 L X-10\n8 L X-20 Y+4 R0\n9 END PGM A MM\n")
        {
            ToolDiameterMm = 6,
            Dialect = "heidenhain-klartext",
            Theoretical = "1 10 0; 2 30 0",
            Part = "1 10 0.05; 2 30 0.05",
            Features = [MatchCase.Line("L1", "N5", "1", "2")],
        };
        Assert.Equal(radius is null ? [] : new[] { $"5 {radius} 3" }, Differing(match));
    }

    private static IEnumerable<string> Differing(MatchCase match) =>
        match.Report().Warnings.Where(w => w.Code == "tool-radius-differs").Select(w => string.Join(' ', w.Values));

    private static MatchCase Floor(double diameter, double up) => new(Slot)
    {
        ToolDiameterMm = diameter,
        Theoretical = "1 10 0; 2 30 0",
        Part = FormattableString.Invariant($"1 10 {up}; 2 30 {up}"),
    };
}
