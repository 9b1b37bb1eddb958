using System.Globalization;

namespace ErrorMatching.Nc.Tests;

/// <summary>The same displacements in every way to spell a motion; expected words are worked out by hand.</summary>
public sealed class DisplaceSpellingTests
{
    private const string Siemens = "G90 G17 G71 G40\n";

    [Fact]
    public void Chain_of_IC_words_keeps_its_sum()
    {
        // Along +X, +Y, -X: 0.1 to the left shortens both legs, and the last one by as much as the first, so that it ends where it did.
        var result = Bench.Normal(
            Siemens + "G0 X0 Y0\nN10 G1 X=IC(10) F100\nN20 Y=IC(10)\nN30 X=IC(-15)\nN40 G0 Z50\n", 0.1, "N10..N20", NcDialects.Siemens840D);
        Assert.Equal(Siemens + "G0 X0 Y0.1\nN10 G1 X=IC(9.9) F100\nN20 Y=IC(9.9)\nN30 X=IC(-14.9)\nN40 G0 Z50\n", result);
    }

    [Fact]
    public void AC_words_in_increments_are_places()
    {
        var result = Bench.Normal(
            Siemens + "G0 X0 Y0\nG91\nN10 G1 X=AC(10) F100\nN20 Y10\nN30 X=AC(-5)\n", 0.1, "N10..N20", NcDialects.Siemens840D);
        Assert.Equal(Siemens + "G0 X0 Y0.1\nG91\nN10 G1 X=AC(9.9) F100\nN20 Y9.9\nN30 X=AC(-5)\n", result);
    }

    [Fact]
    public void Radius_by_CR_and_over_half_a_turn()
    {
        // Half a circle of 10 about the origin, 0.1 to the inside.
        var half = Bench.Normal(
            Siemens + "G0 X-20 Y0\nN10 G1 X-10 Y0 F100\nN20 G2 X10 Y0 CR=10\nN30 G1 X20 Y0\n", -0.1, "N20", NcDialects.Siemens840D);
        Assert.Equal(Siemens + "G0 X-20 Y0\nN10 G1 X-9.9 Y0 F100\nN20 G2 X9.9 Y0 CR=9.9\nN30 G1 X20 Y0\n", half);

        // The long way about (3, 4) with radius 5, between two radial lines, 0.1 to the outside.
        var more = Bench.Normal(
            Siemens + "G0 X-6 Y-8\nN10 G1 X0 Y0 F100\nN20 G2 X6 Y0 CR=-5\nN30 G1 X12 Y-8\n", 0.1, "N20", NcDialects.Siemens840D);
        Assert.Equal(Siemens + "G0 X-6 Y-8\nN10 G1 X-0.06 Y-0.08 F100\nN20 G2 X6.06 Y-0.08 CR=-5.1\nN30 G1 X12 Y-8\n", more);
    }

    [Fact]
    public void Centers_by_AC_stay_and_by_IC_change()
    {
        var places = Bench.Normal(
            Siemens + "G0 X0 Y0\nN10 G1 X10 Y0 F100\nN20 G3 X15 Y5 I=AC(10) J=AC(5)\nN30 G1 X15 Y20\n",
            0.25,
            "N10..N30",
            NcDialects.Siemens840D);
        Assert.Contains("N20 G3 X14.75 Y5 I=AC(10) J=AC(5)\n", places, StringComparison.Ordinal);
        var increments = Bench.Normal(
            Siemens + "G0 X0 Y0\nN10 G1 X10 Y0 F100\nN20 G3 X=IC(5) Y=IC(5) I=IC(0) J=IC(5)\nN30 G1 X15 Y20\n",
            0.25,
            "N10..N30",
            NcDialects.Siemens840D);
        Assert.Contains("N20 G3 X=IC(4.75) Y=IC(4.75) I=IC(0) J=IC(4.75)\n", increments, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("TRANS X100 Y50\n")]
    [InlineData("TRANS X100\nATRANS Y50 Z3\n")]
    [InlineData("")]
    public void Shifted_frame_changes_the_same_words(string frame)
    {
        // N10 goes up; the rapid behind it gains the X that it no longer begins with.
        var result = Bench.Normal($"{Siemens}{frame}G0 X5 Y5 Z0\nN10 G1 Y15 F100\nG0 Y20 M8\nX0\n", 0.1, "N10", NcDialects.Siemens840D);
        Assert.Equal($"{Siemens}{frame}G0 X4.9 Y5 Z0\nN10 G1 Y15 F100\nG0 X5 Y20 M8\nX0\n", result);
        var arc = Bench.Normal(
            $"{Siemens}{frame}G0 X0 Y0\nN10 G1 X10 Y0 F100\nN20 G3 X15 Y5 I=AC(10) J=AC(5)\nN30 G1 X15 Y20\n",
            0.25,
            "N10..N30",
            NcDialects.Siemens840D);
        Assert.Contains("N20 G3 X14.75 Y5 I=AC(10) J=AC(5)\n", arc, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("ROT RPL=30")]
    [InlineData("MIRROR X0")]
    [InlineData("SCALE X2 Y2")]
    [InlineData("TRANS X5\nAROT RPL=30")]
    public void Frame_that_is_more_than_a_shift_is_refused(string frame) =>
        Assert.Equal(
            NcRefusalCodes.ActiveTransform,
            Bench.RefusedNormal($"{Siemens}{frame}\nG0 X0 Y0 Z0\nN10 G1 X10 F100\n", 0.1, "N10", NcDialects.Siemens840D).Code);

    [Theory]
    [InlineData("linuxcnc", "G2 Z-3 I10 J0 P3", "G2 Z-3 I9.9 J0 P3")]
    [InlineData("siemens-840d", "G2 X-10 Y0 Z-3 I10 J0 TURN=2", "G2 X-9.9 Y0 Z-3 I9.9 J0 TURN=2")]
    [InlineData("fanuc", "G2 Z-3 I10 J0", "G2 Z-3 I9.9 J0")]
    [InlineData("fanuc", "G2 I10 J0", "G2 I9.9 J0")]
    [InlineData("fanuc", "G2 I10", "G2 I9.9")]
    [InlineData("fanuc", "G2 X-10 Y0 R10 (one place)", null)]
    [InlineData("linuxcnc", "G2 X10 Y0 Z-9 I10 J0 P3", "G2 X9.9 Y0 Z-9 I9.9 J0 P3")]
    public void Full_circles_and_helices(string dialect, string arc, string? displaced)
    {
        // About the origin with radius 10, 0.1 to the right of clockwise: inside. The lead-in and lead-out are radial.
        var program = $"G90 G17 G40\nG0 X-20 Y0 Z0\nN10 G1 X-10 Y0 F100\nN20 {arc}\nN30 G1 "
            + $"{(arc.Contains("X10", StringComparison.Ordinal) ? "X20" : "X-20")} Y0\n";
        if (displaced is null)
        {
            Assert.Equal(NcRefusalCodes.BadArc, Bench.RefusedNormal(program, -0.1, "N20", NcDialects.Named(dialect)).Code);
            return;
        }

        Assert.Equal(
            program.Replace("X-10 Y0 F100", "X-9.9 Y0 F100", StringComparison.Ordinal).Replace(arc, displaced, StringComparison.Ordinal),
            Bench.Normal(program, -0.1, "N20", NcDialects.Named(dialect)));
    }

    [Fact]
    public void Full_circle_in_increments()
    {
        var result = Bench.Normal("G90 G17\nG0 X-20. Y0.\nG91\nN10 G1 X10. F100\nN20 G2 I10. J0.\nN30 G1 X-10.\n", -0.1, "N20");
        Assert.Equal("G90 G17\nG0 X-20. Y0.\nG91\nN10 G1 X10.1 F100\nN20 G2 I9.9 J0.\nN30 G1 X-10.1\n", result);
    }

    [Fact]
    public void Nothing_but_coordinates_changes()
    {
        const string Program =
            "G90 G17\nT3 M6\nG0 X0. Y0. S8000 M3\nN10 G1 X10. F100.5 M8 D3\nN20 Y10. F250. S9000\nN30 X-5. M9 (S1 F2 X3)\n";
        var result = Bench.Normal(Program, 0.1, "N10..N20");
        Assert.Equal(
            Program.Replace("Y0. S8000", "Y0.1 S8000", StringComparison.Ordinal).Replace("X10.", "X9.9", StringComparison.Ordinal), result);
    }

    [Fact]
    public void Fifteen_decimals_are_kept()
    {
        var result = Bench.Normal("G90 G17\nG0 X0. Y0.\nN10 G1 X10.000000000000000 Y0.000000000000001 F100\nN20 X10. Y10.\n", 0.1, "N10");
        Assert.Equal("G90 G17\nG0 X0. Y0.1\nN10 G1 X10.000000000000000 Y0.100000000000001 F100\nN20 X10. Y10.\n", result);
    }

    [Fact]
    public void Hundred_thousand_increments_do_not_drift()
    {
        // A zigzag; wherever it is displaced, the blocks behind it end where they did, to the last digit.
        var path = Bench.Read(
            "G90 G17 G0 X0. Y0. Z0.\nG91 G1 F100\n"
                + string.Concat(
                    Enumerable.Range(1, 100_000).Select(i => string.Create(
                        CultureInfo.InvariantCulture, $"N{i} X0.3 Y{(i % 2 == 0 ? "0.1" : "-0.1")}\n")))
                + "N200000 X1. Y1.\n");
        var wish = DisplacementWish.Normal(path, [.. Enumerable.Range(1000, 99_000)], 0.0123).Result!;
        var now = NcInterpreter.Run(Bench.Rewritten(path, wish).Program, path.Dialect);
        Assert.Equal(new(30_001, 1, 0), path.Motions[^1].End);
        Assert.Equal(path.Motions[^1].End, now.Motions[^1].End);
        Assert.Equal(path.Motions[500].End, now.Motions[500].End);
        Assert.Equal(path.Motions[50_000].End.Y + 0.0123, now.Motions[50_000].End.Y, 0.002);
    }

    [Theory]

    // The entry comes from below, steep, and stays an entry from below.
    [InlineData("X0. Y-5.", "X0. Y0.", 0.1, true)]
    [InlineData("X0. Y-5.", "X0. Y0.", -0.1, true)]

    // Nearly along the contour: 0.05 below it; displaced by 0.1 to the right it would come from above.
    [InlineData("X-10. Y-0.05", "X0. Y0.", -0.1, false)]
    [InlineData("X-10. Y-0.05", "X0. Y0.", 0.1, true)]

    // 0.15 long: less than half would be left.
    [InlineData("X0. Y-0.15", "X0. Y0.", -0.1, false)]
    [InlineData("X0. Y-0.15", "X0. Y0.", 0.1, true)]
    public void Entry_of_compensation_passes_where_it_stays_one(string from, string to, double left, bool passes)
    {
        var program = $"G90 G17 G40\nG0 {from} Z0.\nG41 D1 G1 {to} F100\nN10 X10.\nN20 Y10.\nG40 G1 X20. Y20.\n";
        if (passes)
        {
            var now = Bench.Read(Bench.Normal(program, left, "N10..N20"));
            Assert.Equal(left, now.Motions[1].End.Y, 1e-9);
            return;
        }

        var refusal = Bench.RefusedNormal(program, left, "N10..N20");
        Assert.Equal((NcRefusalCodes.CompensationEntry, 3), (refusal.Code, refusal.Place.Line));
    }

    [Fact]
    public void Exit_of_compensation_and_entry_by_an_arc_are_checked_too()
    {
        const string Exit = "G90 G17 G40\nG0 X0. Y-5. Z0.\nG41 D1 G1 X0. Y0. F100\nN10 X10.\nG40 X10.15 Y0.\n";
        Assert.Equal(
            (NcRefusalCodes.CompensationEntry, 5),
            Bench.RefusedNormal(Exit.Replace("X10.15 Y0.", "X10. Y0.15", StringComparison.Ordinal), 0.1, "N10") is var r
                ? (r.Code, r.Place.Line)
                : default);
        const string Arc = "G90 G17 G40\nG0 X-5. Y-5. Z0.\nG41 D1 G2 X0. Y0. I5. J0. F100\nN10 G1 X10.\nN20 Y10.\nG40 X20. Y20.\n";
        Assert.Equal(
            (NcRefusalCodes.CompensationEntry, 3), Bench.RefusedNormal(Arc, 0.1, "N10..N20") is var a ? (a.Code, a.Place.Line) : default);
    }
}
