using System.Text;

namespace ErrorMatching.Nc.Tests;

/// <summary>A good result is proved; whatever is done to it afterwards is found.</summary>
public sealed class ProofTests
{
    private const string Marker = "(ERRORMATCHING 0123456789ABCDEF)";

    private const string Before = """
        %
        O0001 (COUNTERPART)
        N1 G21 G17 G40 G90 G54
        N2 T1 M6
        N3 S3000 M3
        N4 G43 H1 G0 Z50.
        N10 G0 X-20. Y-5. Z5.
        N20 G1 Z-2. F200
        N100 G1 X0. Y0. F500 (lead in)
        N110 X10. Y0.
        N120 G3 X15. Y5. I0. J5.
        N130 G1 X15. Y15.
        N140 X25. Y20.
        N150 G2 X35. Y10. I0. J-10.
        N160 G1 X35.
        /N165 G4 P100
        N170 Y0.
        N180 G0 Z50.
        N190 M30
        %
        """;

    /// <summary>The result for 0.1 mm to the left, by hand: the lead-in slides along (4, 1), the fillet keeps its center,
    /// N130 ends on the line of N140.</summary>
    private static readonly string Good = Before
        .Replace("X0. Y0. F500", "X0.4 Y0.1 F500", StringComparison.Ordinal)
        .Replace("X10. Y0.", "X10. Y0.1", StringComparison.Ordinal)
        .Replace("X15. Y5. I0. J5.", "X14.9 Y5. I0. J4.9", StringComparison.Ordinal)
        .Replace("X15. Y15.", "X14.9 Y14.95", StringComparison.Ordinal);

    public static TheoryData<string, string> Tampered => new()
    {
        // A coordinate of a named block.
        { "X14.9 Y14.95", "X14.8 Y14.95" },
        { "X14.9 Y14.95", "X14.9 Y14.85" },
        { "X14.9 Y14.95", "X14.9 Y15.05" },
        { "X14.9 Y14.95", "X14.9 Y-14.95" },
        { "X14.9 Y14.95", "X15.1 Y15.05" },
        { "X14.9 Y14.95", "X14.9" },
        { "X14.9 Y14.95", "Y14.95" },
        { "X14.9 Y14.95", "X14.9 Y14.95 Z-2.1" },
        { "X14.9 Y14.95", "X14.9 Y14.95 Z-2." },
        { "X14.9 Y14.95", "X14.9  Y14.95" },
        { "X14.9 Y14.95", "X 14.9 Y14.95" },
        { "X14.9 Y14.95", "x14.9 Y14.95" },
        { "X14.9 Y14.95", "X14.9Y14.95" },
        { "X14.9 Y14.95", "Y14.95 X14.9" },
        { "X14.9 Y14.95", "X#14 Y14.95" },
        { "X14.9 Y14.95", "X14.9 Y14.95 (new)" },
        { "X14.9 Y14.95", "X14.9 Y14.95 F90." },
        { "X14.9 Y14.95", "X14.9 Y14.95 M0" },
        { "X14.9 Y14.95", "X14.9 Y14.95 I0." },
        { "X14.9 Y14.95", "X14.9 Y14.95 ,R1." },
        { "X10. Y0.1", "X9.9 Y0.1" },
        { "X10. Y0.1", "X10.1 Y0.1" },
        { "X10. Y0.1", "X10. Y-0.1" },
        { "X10. Y0.1", "X10. Y0.11" },
        { "X10. Y0.1", "X10. Y0." },
        { "X10. Y0.1", "X10.0 Y0.1" },
        // The border: too far along its own line, or not on it.
        { "X0.4 Y0.1 F500", "X0.8 Y0.2 F500" },
        { "X0.4 Y0.1 F500", "X0.3 Y0.1 F500" },
        { "X0.4 Y0.1 F500", "X0. Y0. F500" },
        { "X0.4 Y0.1 F500", "X0.4 Y0.1 F501" },
        { "X0.4 Y0.1 F500", "X0.4 Y0.1 F500." },
        // The arc.
        { "I0. J4.9", "I0. J4.8" },
        { "I0. J4.9", "I0. J-4.9" },
        { "I0. J4.9", "I0.1 J4.9" },
        { "I0. J4.9", "J4.9" },
        { "I0. J4.9", "I0. J4.9 K1." },
        { "I0. J4.9", "R4.9" },
        { "I0. J4.9", "I-0.07 J4.97" },
        { "G3 X14.9 Y5.", "G2 X14.9 Y5." },
        { "G3 X14.9 Y5.", "G1 X14.9 Y5." },
        { "G3 X14.9 Y5.", "G03 X14.9 Y5." },
        { "G3 X14.9 Y5.", "G3 X14.9 Y5.1" },
        { "G3 X14.9 Y5.", "G3 X14.9 Y4.9" },
        // Blocks that nobody named.
        { "X25. Y20.", "X25.1 Y20." },
        { "X25. Y20.", "X25. Y20.05" },
        { "X25. Y20.", "X25. Y20.0" },
        { "X35. Y10. I0. J-10.", "X35. Y10. I0. J-10.0" },
        { "X35. Y10. I0. J-10.", "X35. Y10. I0.001 J-10." },
        { "X35. Y10. I0. J-10.", "X35. Y10. R10." },
        { "N180 G0 Z50.", "N180 G0 Z-50." },
        { "N180 G0 Z50.", "N180 G1 Z50." },
        { "G1 Z-2. F200", "G1 Z-2.1 F200" },
        { "X-20. Y-5. Z5.", "X-19.9 Y-5. Z5." },
        { "/N165 G4 P100", "N165 G4 P100" },
        { "/N165 G4 P100", "/N165 G4 P1000" },
        { "G21 G17 G40 G90 G54", "G21 G18 G40 G90 G54" },
        { "G21 G17 G40 G90 G54", "G20 G17 G40 G90 G54" },
        { "G21 G17 G40 G90 G54", "G21 G17 G41 G90 G54" },
        { "G21 G17 G40 G90 G54", "G21 G17 G40 G91 G54" },
        { "G21 G17 G40 G90 G54", "G21 G17 G40 G90 G55" },
        { "T1 M6", "T2 M6" },
        { "S3000", "S9000" },
        { "H1", "H2" },
        { "(lead in)", "(lead  in)" },
        { "(lead in)", "(LEAD IN)" },
        { "(lead in)\r\n", "(lead in)\n" },
        { "(lead in)\r\n", "(lead in) \r\n" },
        { "(lead in)\r\n", "(lead in)\r\n\r\n" },
        { "N3 S3000 M3\r\n", "" },
        { "N3 S3000 M3\r\n", "M0\r\n" },
        { "N190 M30", "N190 M99" },
        { "O0001", "O0002" },
    };

    // All motions are of one block, so that the path never goes back to an earlier one.
    [Fact]
    public void A_loop_around_a_single_motion_is_changed_once_or_refused()
    {
        var path = Bench.Read(
            "G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F300\n#1=0\no1 while [#1 LT 5]\nN10 Y1\n#1=[#1+1]\no1 endwhile\nN20 X30\nG0 Z5\n",
            NcDialects.LinuxCnc);
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N20"), 0.1));
        if (Rewriter.Apply(path, wish) is { IsUsable: true, Result: var rewrite })
        {
            Assert.Empty(Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm).Failures);
        }
    }

    // No circle runs through the ends and the middle of such an arc, as far as doubles tell.
    [Theory]
    [InlineData(0.1)]
    [InlineData(2)]
    public void An_arc_that_is_all_but_straight_is_proved_or_refused(double by)
    {
        var path = Bench.Read("G21 G17 G90 G54\nG0 X0 Y0 Z5\nG1 Z-1 F300\nN10 G1 X30 Y5\nN20 G3 X40 Y5 R2147483647\nN30 G1 X50 Y0\n");
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N10"), new(by, -by, 0)));
        if (Rewriter.Apply(path, wish) is { IsUsable: true, Result: var rewrite })
        {
            Assert.Empty(Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm).Failures);
        }
    }

    [Fact]
    public void Good_result_holds_and_names_what_moved()
    {
        var proof = Prove(Crlf(Good), 0.1);
        Assert.Empty(proof.Failures);
        Assert.True(proof.Holds && proof.UntouchedBytesIdentical);
        Assert.Equal((12, 5), (proof.Motions, proof.MovedMotions));
        Assert.Equal([("N100", NeighborRole.Slides), ("N140", NeighborRole.Slides)], proof.Neighbors.Select(n => (n.Block, n.Role)));
        Assert.Equal(0, proof.MaxDeviationFromWantedMm, 1e-9);
    }

    [Theory]
    [MemberData(nameof(Tampered))]
    public void Tampered_result_does_not_hold(string was, string now)
    {
        var good = Crlf(Good);
        Assert.Equal(2, good.Split(was).Length);
        var proof = Prove(good.Replace(was, now, StringComparison.Ordinal), 0.1);
        Assert.False(proof.Holds);
        Assert.NotEmpty(proof.Failures);
        Assert.All(proof.Failures, f => Assert.Equal(NcRefusalCodes.ProofFailed, f.Code));
    }

    [Theory]
    [InlineData(-0.1)]
    [InlineData(0.11)]
    [InlineData(0)]
    [InlineData(1)]
    public void Another_distance_or_sign_was_not_what_was_asked(double left) => Assert.False(Prove(Crlf(Good), left).Holds);

    [Fact]
    public void Unchanged_and_swapped_and_otherwise_displaced_programs_do_not_hold()
    {
        Assert.False(Prove(Crlf(Before), 0.1).Holds);
        var lines = Crlf(Good).Split("\r\n");
        (lines[9], lines[10]) = (lines[10], lines[9]);
        Assert.False(Prove(string.Join("\r\n", lines), 0.1).Holds);
        var other = Bench.Normal(Crlf(Before), 0.1, "N110..N140");
        Assert.False(Prove(other, 0.1).Holds);
        Assert.False(Prove(Bench.Normal(Crlf(Before), -0.1, "N110..N130"), 0.1).Holds);
        Assert.False(Prove(Crlf(Good) + "\u001a", 0.1).Holds);
        Assert.False(Prove(Crlf(Good) + "X", 0.1).Holds);
        Assert.False(Prove(Crlf(Good)[..^1], 0.1).Holds);
        Assert.False(Prove("", 0.1).Holds);
    }

    [Fact]
    public void Marker_is_one_comment_line_that_ends_like_its_neighbors()
    {
        var good = Crlf(Good);
        Assert.True(Marked("O0001 (COUNTERPART)\r\n" + Marker + "\r\n").Holds);
        Assert.Equal(Marker, Marked("O0001 (COUNTERPART)\r\n" + Marker + "\r\n").Marker);
        Assert.False(Marked("O0001 (COUNTERPART)\r\n").Holds);
        Assert.False(Marked("O0001 (COUNTERPART)\r\n" + Marker + "\r\n" + Marker + "\r\n").Holds);
        Assert.False(Marked("O0001 (COUNTERPART)\r\n" + Marker + "\n").Holds);
        Assert.False(Marked("O0001 (COUNTERPART)\r\n" + Marker + " M0\r\n").Holds);
        Assert.False(Marked("O0001 (COUNTERPART)\r\n" + Marker.Replace('0', '1') + "\r\n").Holds);
        Assert.False(
            Prove(
                good.Replace("O0001 (COUNTERPART)\r\n", "O0001 (COUNTERPART)\r\n" + Marker + "\r\n", StringComparison.Ordinal), 0.1).Holds);
        Assert.False(
            Prove(good.Replace("O0001 (COUNTERPART)\r\n", "O0001 (COUNTERPART)\r\nM0\r\n", StringComparison.Ordinal), 0.1, "M0").Holds);

        NcProof Marked(string head) => Prove(good.Replace("O0001 (COUNTERPART)\r\n", head, StringComparison.Ordinal), 0.1, Marker);
    }

    [Theory]
    [InlineData("X0.1 Y0.2 Z-1.1 F100", "X0.1 Y0.2 Z-1. F100")]
    [InlineData("X0.1 Y0.2 Z-1.1 F100", "X0.1 Y0.1 Z-1.1 F100")]
    [InlineData("X0.1 Y0.2 Z-1.1 F100", "X0.2 Y0.2 Z-1.1 F100")]
    [InlineData("N20 X10.1 Y0.2", "N20 X10.1 Y0.1")]
    [InlineData("N20 X10.1 Y0.2", "N20 X10.1")]
    [InlineData("X15. Y5. Z-1. I0.152 J4.746", "X15.1 Y5. Z-1. I0.152 J4.746")]
    [InlineData("X15. Y5. Z-1. I0.152 J4.746", "X15. Y5. Z-1.1 I0.152 J4.746")]
    [InlineData("I0.152 J4.746", "I0.252 J4.846")]
    [InlineData("I0.152 J4.746", "I0. J5.")]
    [InlineData("G0 Z5.", "G0 Z-5.")]
    [InlineData("G0 Z5.", "G0 X15. Z5.")]
    public void Tampered_end_points_do_not_hold(string was, string now)
    {
        var path = Bench.Read("G90 G17\nG0 X0. Y0. Z5.\nN10 G1 Z-1. F100\nN20 X10. Y0.\nN30 G3 X15. Y5. I0. J5.\nG0 Z5.\nX0.\n");
        var wish = DisplacementWish.EndsBy(path, Bench.Blocks(path, "N10..N20"), new(0.1, 0.2, -0.1)).Result!;
        var rewrite = Bench.Rewritten(path, wish);
        var good = Bench.Text(rewrite.Program);
        Assert.True(good.Contains(was, StringComparison.Ordinal), good);
        Assert.False(Prover.Check(path, NcProgram.FromText(good.Replace(was, now, StringComparison.Ordinal)), wish, 0.001).Holds);
    }

    [Theory]
    [InlineData("G0 Z6.", "G0 Z-6.", true)]
    [InlineData("G0 Z6.", "G0 Z60.", true)]
    [InlineData("G0 Z6.", "G0 Y0. Z6.", true)]
    [InlineData("G0 Z6.", "G0 Y0.1 Z6.", true)]
    [InlineData("G1 Z-1. F100", "G1 Z-2. F100", true)]
    [InlineData("G1 Z-1. F100", "G1 X0.05 Z-1. F100", true)]
    [InlineData("G0 X0. Y0.1 Z5.", "G0 X0. Y0.1 Z4.", true)]
    [InlineData("G0 X0. Y0.1 Z5.", "G0 X0. Y0. Z5.", true)]
    [InlineData("G0 Z6.", "G0 Z-6.", false)]
    [InlineData("G0 Z6.", "G0 Z60.", false)]
    [InlineData("G0 Z6.", "G0 X10. Z6.", false)]
    [InlineData("G0 Z6.", "G0 X10.1 Z6.", false)]
    [InlineData("X50. Y0.", "X50.", false)]
    public void Tampered_plunges_and_retracts_do_not_hold(string was, string now, bool isElements)
    {
        var path = Bench.Read("G90 G17\nG0 X0. Y0. Z5.\nG1 Z-1. F100\nN10 X10.\nG0 Z6.\nX50.\n");
        var wish = (isElements ? DisplacementWish.Normal(path, [3], 0.1) : DisplacementWish.EndsBy(path, [3], new(0.1, 0.1, 0))).Result!;
        var good = Bench.Text(Bench.Rewritten(path, wish).Program);
        Assert.True(good.Contains(was, StringComparison.Ordinal), good);
        Assert.False(Prover.Check(path, NcProgram.FromText(good.Replace(was, now, StringComparison.Ordinal)), wish, 0.001).Holds);
    }

    [Theory]
    [InlineData("N40 X0. Y0.1", "N40 X0. Y0.3")]
    [InlineData("N40 X0. Y0.1", "N40 X0. Y0.102")]
    [InlineData("N40 X0. Y0.1", "N40 X0. Y0.")]
    [InlineData("G0 X0. Y0.1", "G0 X0. Y0.")]
    public void Contour_that_no_longer_closes_does_not_hold(string was, string now)
    {
        var path = Bench.Read(
            "G90 G17\nG0 X0. Y0.\nG1 Z-1. F100\nN10 X10. Y0.\nN20 X10. Y10.\nN30 X0. Y10.\nN40 X0. Y0.\nG0 Z5.\nX50. Y50.\n");
        var wish = DisplacementWish.Normal(path, Bench.Blocks(path, "N10"), 0.1).Result!;
        var good = Bench.Text(Bench.Rewritten(path, wish).Program);
        Assert.True(good.Contains(was, StringComparison.Ordinal), good);
        Assert.False(Prover.Check(path, NcProgram.FromText(good.Replace(was, now, StringComparison.Ordinal)), wish, 0.001).Holds);
    }

    [Fact]
    public void Every_digit_of_a_changed_word_counts()
    {
        var good = Encoding.ASCII.GetBytes(Crlf(Good));
        var (checkedDigits, path) = (0, Bench.Read(Crlf(Before)));
        var wish = DisplacementWish.Normal(path, Bench.Blocks(path, "N110..N130"), 0.1).Result!;
        for (var i = 0; i < good.Length; i++)
        {
            if (char.IsAsciiDigit((char)good[i]))
            {
                var tampered = good.ToArray();
                tampered[i] = (byte)(tampered[i] == '9' ? '8' : tampered[i] + 1);
                Assert.False(Prover.Check(path, NcProgram.Read(tampered), wish, 0.001).Holds, Encoding.ASCII.GetString(tampered));
                checkedDigits++;
            }
        }

        Assert.InRange(checkedDigits, 100, 200);
    }

    [Theory]
    [InlineData("X=IC(10.1)", "X=IC(10.1]")]
    [InlineData("X=IC(10.1)", "X=AC(10.1)")]
    [InlineData("X=IC(10.1)", "X=IC(10.1 )")]
    [InlineData("CR=4.9", "CR=4.8")]
    [InlineData("CR=4.9", "CR=4.9 ;")]
    public void Tampered_addresses_of_several_letters_do_not_hold(string was, string now)
    {
        var path = Bench.Read(
            "G90 G17 G71\nG0 X0. Y-10. Z5.\nN9 G1 Y0. F100\nN10 X=IC(10.) Y0.\nN20 G3 X=AC(15.) Y=AC(5.) CR=5.\nN30 G1 Y15.\nG0 Z5.\n",
            NcDialects.Siemens840D);
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N9..N30"), 0.1));
        var good = Bench.Text(Bench.Rewritten(path, wish).Program);
        Assert.True(good.Contains(was, StringComparison.Ordinal), good);
        Assert.False(
            Prover.Check(path, NcProgram.FromText(good.Replace(was, now, StringComparison.Ordinal), NcSyntax.Siemens), wish, 0.001).Holds);
    }

    private static NcProof Prove(string result, double left, string? marker = null)
    {
        var path = Bench.Read(Crlf(Before));
        var wish = DisplacementWish.Normal(path, Bench.Blocks(path, "N110..N130"), left).Result!;
        return Prover.Check(path, NcProgram.FromText(result), wish, 0.001, marker);
    }

    private static string Crlf(string text) => text.ReplaceLineEndings("\r\n");
}
