using ErrorMatching.Refusals;

namespace ErrorMatching.Nc.Tests;

/// <summary>Displacing contours under cutter compensation for a known tool: what the control could not cut any more is refused.</summary>
public sealed class CompensatedDisplacementTests
{
    // N50 is 3.1 mm long and has an inside corner at its start: a tool radius of 3 needs 3.
    private const string Step = "G21 G17 G40 G90 G91.1 G94 F100\nG0 X-20 Y0 Z5\n"
        + "N30 G41.1 D6 G1 X0\nN40 X10\nN50 Y3.1\nN60 X20\nN70 G40 Y20\n";

    [Fact]
    public void A_contour_that_the_tool_still_fits_into_is_displaced() =>
        Assert.Contains("N30 G41.1 D6 G1 X0 Y0.05\n", Bench.Normal(Step, 0.05, "N40", NcDialects.LinuxCnc), StringComparison.Ordinal);

    [Fact]
    public void A_corner_that_gets_too_short_is_refused_with_its_block()
    {
        var refusal = Bench.RefusedNormal(Step, 0.2, "N40", NcDialects.LinuxCnc);
        Assert.Equal((NcRefusalCodes.CompensationGouge, "N50", 5), (refusal.Code, refusal.Place.Block, refusal.Place.Line));
        Assert.Contains("displaced as asked", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void An_arc_that_gets_tighter_than_the_tool_is_refused()
    {
        const string Round = "G21 G17 G40 G90 G91.1 F100\nG0 X-20 Y0 Z5\nG41.1 D6 G1 X0\n"
            + "N40 X10\nN50 G3 X13.1 Y3.1 J3.1\nN60 G1 Y20\nG40 X0\n";
        Assert.Contains("G3", Bench.Normal(Round, 0.05, "N40..N60", NcDialects.LinuxCnc), StringComparison.Ordinal);
        Assert.Equal(NcRefusalCodes.CompensationGouge, Bench.RefusedNormal(Round, 0.15, "N40..N60", NcDialects.LinuxCnc).Code);
    }

    [Fact]
    public void A_way_in_that_gets_as_short_as_the_tool_is_refused()
    {
        const string Short = "G21 G17 G40 G90 F100\nG0 X0 Y3.2 Z5\nN30 G42.1 D6 G1 Y0\nN40 X10\nN50 Y-10\nG40 Y-20\n";
        Assert.Contains("Y0.1", Bench.Normal(Short, 0.1, "N40", NcDialects.LinuxCnc), StringComparison.Ordinal);
        var refusal = Bench.RefusedNormal(Short, 0.3, "N40", NcDialects.LinuxCnc);
        Assert.Equal((NcRefusalCodes.CompensationEntry, "N30"), (refusal.Code, refusal.Place.Block));
    }

    [Fact]
    public void A_program_that_the_control_refuses_as_it_is_is_not_displaced() => Assert.Equal(
        NcRefusalCodes.CompensationGouge,
        Bench.RefusedNormal(Step.Replace("Y3.1", "Y2.9", StringComparison.Ordinal), 0.01, "N60", NcDialects.LinuxCnc).Code);

    [Fact]
    public void Without_a_radius_only_the_ways_in_and_out_are_checked()
    {
        var unknown = Step.Replace("G41.1 D6", "G41 D1", StringComparison.Ordinal);
        Assert.Contains("Y0.2", Bench.Normal(unknown, 0.2, "N40", NcDialects.LinuxCnc), StringComparison.Ordinal);
        Assert.Equal(
            NcRefusalCodes.CompensationGouge,
            Bench.RefusedNormal(unknown, 0.2, "N40", NcDialects.LinuxCnc.With(ToolRadii.Of(3))).Code);
    }

    [Fact]
    public void The_proof_finds_what_the_control_could_not_cut()
    {
        // The wish is met, and only the tool says no.
        var path = Bench.Read(Step, NcDialects.LinuxCnc);
        var wish = Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N40"), 0.2));
        var result = Bench.Normal(Step.Replace("G41.1 D6", "G41 D1", StringComparison.Ordinal), 0.2, "N40", NcDialects.LinuxCnc)
            .Replace("G41 D1", "G41.1 D6", StringComparison.Ordinal);
        var proof = Prover.Check(path, NcProgram.FromText(result, NcSyntax.LinuxCnc), wish, 0.0001);
        Assert.Equal([NcRefusalCodes.CompensationGouge], proof.Failures.Select(f => f.Code));
    }

    [Fact]
    public void A_wish_stores_the_radii()
    {
        var radii = ToolRadii.OfTable(new Dictionary<int, double> { [2] = 4.975, [1] = 3 }, 2.5);
        var path = Bench.Read(Step.Replace("G41.1 D6", "G41 D1", StringComparison.Ordinal), NcDialects.LinuxCnc.With(radii));
        var wish = Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N40"), 0.01));
        using var stream = new MemoryStream();
        WishFile.Of(path, wish, 0.0001).WriteTo(stream);
        var read = WishFile.Read(stream.ToArray(), "wish.json").ToolRadii;
        Assert.Equal((2.5, 3, 4.975), (read.Otherwise, read.For(1), read.For(2)));
        Assert.Equal(2, read.ByNumber.Count);
    }

    private static T Usable<T>(Outcome<T> outcome)
        where T : class => outcome.Result ?? throw new InvalidOperationException(outcome.Refusal?.Message);
}
