namespace ErrorMatching.Nc.Tests;

/// <summary>Arcs in G18 or G19 that lead into a contour in XY and out of it: where the contour moves, the whole lead moves with it. The
/// tool goes to (20, -10), down to 2, on a quarter about (18, 2) to (18, 0), along a U of three lines, and up again at (-12, 2).</summary>
public sealed class VerticalArcTests
{
    private const string Before = "G90 G17\nN1 G0 X20. Y-10.\nN2 G0 Z10.\nN3 G1 Z2. F100\n";
    private const string After = "N9 G1 Z10.\nN10 G17\nN11 G0 X0. Y0.\nM30\n";
    private const string Contour = "N5 G1 X10.\nN6 Y10.\nN7 X-10.\n";
    private const string In = "N4 G18 G3 X18. Z0. I-2. K0.\n";
    private const string Out = "N8 G18 G3 X-12. Z2. I0. K2.\n";

    // To the left of N5 is -Y, of N6 -X, and of N7 -Y: across the plane of both arcs, so that no word of theirs changes.
    [Theory]
    [InlineData("fanuc", In, Out)]
    [InlineData("fanuc", "N4 G18 G3 X18. Z0. R2.\n", "N8 G18 G3 X-12. Z2. R2.\n")]
    [InlineData("fanuc", "N4 G18 G3 X18. Z0. I-2.\n", "N8 G18 G3 X-12. Z2. K2.\nG17\n")]
    [InlineData("fanuc", "G18\nN4 G3 X18. Z0. I-2.\nG17\n", "G18\nN8 G3 X-12. Z2. K2.\nG17\n")]
    [InlineData("fanuc", "N4 G91 G18 G3 X-2. Z-2. I-2. K0.\nG90\n", "N8 G91 G18 G3 X-2. Z2. I0. K2.\nG90\n")]
    [InlineData("linuxcnc", In, Out)]
    [InlineData("linuxcnc", "N4 G18 G90.1 G3 X18. Z0. I18. K2.\nG91.1\n", "N8 G18 G90.1 G3 X-12. Z2. I-10. K2.\nG91.1\n")]
    [InlineData("grbl", In, Out)]
    [InlineData("siemens-840d", "N4 G18 G3 X18. Z0. CR=2.\n", "N8 G18 G3 X-12. Z2. CR=2.\n")]
    [InlineData("siemens-840d", "N4 G18 G3 X18. Z0. I=AC(18.) K=AC(2.)\n", "N8 G18 G3 X-12. Z2. I=AC(-10.) K=AC(2.)\n")]
    [InlineData("siemens-840d", "N4 G18 CIP X18. Z0. I1=19.41421 K1=0.58579\n", Out)]
    public void A_lead_follows_across_its_plane(string dialect, string lead, string leadOut)
    {
        var program = Before + lead + Contour + leadOut + After;
        foreach (var named in new[] { "N5..N7", "N4..N8" })
        {
            Assert.Equal(
                program.Replace("Y-10.", "Y-10.1", StringComparison.Ordinal).Replace("X10.\n", "X9.9\n", StringComparison.Ordinal)
                    .Replace("Y10.", "Y9.9", StringComparison.Ordinal),
                Bench.Normal(program, 0.1, named, NcDialects.Named(dialect)));
        }
    }

    // N6 alone goes by -0.1 in X; its neighbors slide, and so do not move the arcs. N5 is along Y then: the arc leads to it across.
    [Theory]
    [InlineData("fanuc", "X18. Z0. I-2. K0.", "X17.9 Z0. I-2. K0.")]
    [InlineData("fanuc", "X18. Z0. R2.", "X17.9 Z0. R2.")]
    [InlineData("linuxcnc", "G90.1 X18. Z0. I18. K2.", "G90.1 X17.9 Z0. I17.9 K2.")]
    [InlineData("siemens-840d", "X18. Z0. CR=2.", "X17.9 Z0. CR=2.")]
    [InlineData("siemens-840d", "X18. Z0. I=AC(18.) K=AC(2.)", "X17.9 Z0. I=AC(17.9) K=AC(2.)")]
    public void A_lead_follows_along_its_plane(string dialect, string arc, string moved)
    {
        const string Rest = "\nN5 G1 Y10.\nN6 X-10.\nN9 G0 Z10.\n";

        Assert.Equal(
            Before.Replace("X20.", "X19.9", StringComparison.Ordinal) + "N4 G18 G3 " + moved + Rest,
            Bench.Normal(Before + "N4 G18 G3 " + arc + Rest, 0.1, "N5", NcDialects.Named(dialect)));
    }

    [Fact]
    public void A_lead_in_yz_follows_too()
    {
        // From (20, -10) about (Y -8, Z 2) down to Y -8; the line goes up along Y and is displaced to the left, to X 19.9.
        const string Program = "G90 G17\nN1 G0 X20. Y-10.\nN3 G0 Z2.\nN4 G19 G3 Y-8. Z0. J2. F100\nN5 G1 Y10.\nN6 X-10.\n"
            + "N8 G0 Z10.\nM30\n";

        Assert.Equal(Program.Replace("X20.", "X19.9", StringComparison.Ordinal), Bench.Normal(Program, 0.1, "N5", NcDialects.FanucMill));
    }

    [Fact]
    public void Ends_that_move_by_a_vector_take_the_lead_along()
    {
        Assert.Equal(
            "G90 G17\nN1 G0 X20.1 Y-9.8\nN2 G0 Z10.\nN3 G1 Z2.3 F100\nN4 G18 G3 X18.1 Z0.3 I-2. K0.\nN5 G1 X10.1\nN6 Y10.2\nN7 X-9.9\n"
                + "N8 G18 G3 X-11.9 Z2.3 I0. K2.\n" + After,
            Bench.By(Before + In + Contour + Out + After, new(0.1, 0.2, 0.3), "N4..N7"));

        // As for any block, what leads to the first named one stays.
        Assert.Equal(
            Before + In + "N5 G1 X10.1 Y-9.8\nN6 Y10.2\nN7 X-9.9\nN8 G18 G3 X-11.9 Z2. I0. K2.\n" + After,
            Bench.By(Before + In + Contour + Out + After, new(0.1, 0.2, 0), "N5..N7"));
    }

    [Fact]
    public void A_feed_above_the_contour_ends_where_the_lead_begins()
    {
        const string Program = "G90 G17\nG0 X40. Y-10.\nG1 Z2. F100\nN3 X20.\n" + In + Contour
            + "N8 G18 G3 X-12. Z2. K2.\nN9 G1 X-40.\nM30\n";

        Assert.Equal(
            Program.Replace("N3 X20.", "N3 X20. Y-10.1", StringComparison.Ordinal).Replace("X10.\n", "X9.9\n", StringComparison.Ordinal)
                .Replace("Y10.", "Y9.9", StringComparison.Ordinal).Replace("X-40.", "X-40. Y10.", StringComparison.Ordinal),
            Bench.Normal(Program, 0.1, "N5..N7"));
    }

    // From another cut of the same depth, up and down again: that cut stays. Along their plane one arc takes up the difference.
    [Fact]
    public void A_cut_at_the_other_end_of_the_lead_stays()
    {
        const string Program = "G90 G17\nG0 X40. Y-10.\nG1 Z0. F100\nN3 X22.\nN4 G18 G3 X20. Z2. K2.\nN5 G3 X18. Z0. I-2.\n";

        Assert.Equal(NcRefusalCodes.NoPositioning, Bench.RefusedNormal(Program + "N6 G1 X10.\nN7 G0 Z9.\n", 0.1, "N6").Code);
        var along = Bench.Normal(Program + "N6 G1 Y10.\nN7 G0 Z9.\n", 0.1, "N6");
        Assert.StartsWith("G90 G17\nG0 X40. Y-10.\nG1 Z0. F100\nN3 X22.\n", along, StringComparison.Ordinal);
        Assert.EndsWith("N5 G3 X17.9 Z0. I-2.\nN6 G1 Y10.\nN7 G0 Z9.\n", along, StringComparison.Ordinal);
    }

    // The arc is all that is between the two, and its start cannot move.
    [Fact]
    public void An_arc_does_not_become_a_helix()
    {
        const string Program = "G90 G17\nG0 X40. Y-10.\nG1 Z0. F100\nN3 X20.\nN4 G18 G2 X18. Z2. I-2.\nN5 G1 X10.\nN7 G0 Z9.\n";
        var refusal = Bench.RefusedNormal(Program, 0.1, "N5");

        Assert.Equal((NcRefusalCodes.NoPositioning, 5), (refusal.Code, refusal.Place.Line));
    }

    [Fact]
    public void Vertical_arcs_alone_are_no_boundary()
    {
        var refusal = Bench.RefusedNormal(Before + In + Contour + Out + After, 0.1, "N4");

        Assert.Equal(NcRefusalCodes.NoMotion, refusal.Code);
        Assert.Contains("lead", refusal.Message, StringComparison.Ordinal);
    }

    // G18 with an arc does not say that the lines behind it are in ZX; G18 before a line does, and so does G18 where no G17 was.
    [Theory]
    [InlineData("G17 G0 X0 Y0 Z0\nG18 G3 X2 Z-2 I2 K0\nG1 X9", "XY ZX* XY")]
    [InlineData("G17\nG0 X0 Y0 Z0\nG18\nG3 X2 Z-2 I2 K0\nG1 X9\nG17 G3 X10 Y1 J1\nG1 Y5\nG19 G2 Y6 Z-1 K1\nG0 Z9",
        "XY ZX* XY XY XY YZ* XY")]
    [InlineData("G17 G0 X0 Y0 Z0\nG18\nG1 X5\nG3 X2 Z-2 I2 K0\nG1 X9", "XY ZX ZX ZX")]
    [InlineData("G17 G0 X0 Y0 Z0\nG18 G1 X5\nG3 X2 Z-2 I2 K0\nG1 X9", "XY ZX ZX ZX")]
    [InlineData("G0 X0 Y0 Z0\nG18 G3 X2 Z-2 I2 K0\nG1 X9", "XY ZX ZX")]
    [InlineData("G18\nG0 X0 Y0 Z0\nG3 X2 Z-2 I2 K0\nG1 X9", "ZX ZX ZX")]
    [InlineData("G17 G0 X0 Y0 Z0\nG18 G3 X2 Z-2 I2 K0\nG41 D1 G1 X9\nX12\nG40 X15\nX18", "XY ZX* ZX ZX ZX XY")]
    public void Lines_stay_in_the_plane_of_the_contours(string program, string planes)
    {
        var path = Bench.Read(program + "\n", NcDialects.FanucMill);

        Assert.Equal(planes, string.Join(' ', path.Motions.Select(m => m.Plane + (m.IsVertical ? "*" : ""))));
    }

    // The twin of a program in Klartext: a contour along X behind an arc in G18.
    [Fact]
    public void Klartext_and_its_twin_change_the_same_words()
    {
        const string Klartext = "0 BEGIN PGM A MM\n1 TOOL CALL 23 Z S8979\n2 L X+313 Y-203.6 R0 FMAX\n3 L Z+5 R0 FMAX\n4 CC X+305 Z+5\n"
            + "5 CP IPA+90 DR+ F1000\n6 L X-45 Z-3\n7 L Y-170\n8 L X+305\n9 END PGM A MM\n";
        const string Twin = "G90 G17\nN2 G0 X313. Y-203.6\nN3 G0 Z5.\nN5 G18 G3 X305. Z-3. I-8. K0. F1000\n"
            + "N6 G1 X-45. Z-3.\nN7 Y-170.\nN8 X305.\n";

        Assert.Equal(
            Klartext.Replace("Y-203.6", "Y-203.65", StringComparison.Ordinal).Replace("X-45", "X-45.05", StringComparison.Ordinal)
                .Replace("Y-170", "Y-169.95", StringComparison.Ordinal),
            Bench.Normal(Klartext, 0.05, "N6..N8", NcDialects.HeidenhainKlartext));
        Assert.Equal(
            Twin.Replace("Y-203.6", "Y-203.65", StringComparison.Ordinal).Replace("X-45.", "X-45.05", StringComparison.Ordinal)
                .Replace("Y-170.", "Y-169.95", StringComparison.Ordinal),
            Bench.Normal(Twin, 0.05, "N6..N8", NcDialects.FanucMill));
    }

    // Along its plane, the center that a block of its own states goes along, and the way that leads to the arc.
    [Theory]
    [InlineData("5 CP IPA+90 DR+", "5 CP IPA+90 DR+")]
    [InlineData("5 C X+305 Z-3 DR+", "5 C X+304.95 Z-3 DR+")]
    public void A_center_of_its_own_goes_along(string arc, string moved)
    {
        const string Head = "0 BEGIN PGM A MM\n1 TOOL CALL 23 Z S8979\n2 L X+313 Y-203.6 R0 FMAX\n3 L Z+5 R0 FMAX\n4 CC X+305 Z+5\n";
        const string Rest = " F1000\n6 L Y-170\n7 L X-45\n8 L Z+50 FMAX\n";

        Assert.Equal(
            Head.Replace("313", "312.95", StringComparison.Ordinal).Replace("305", "304.95", StringComparison.Ordinal) + moved + Rest,
            Bench.Normal(Head + arc + Rest, 0.05, "N6", NcDialects.HeidenhainKlartext));
    }

    // Two turns down to -2: the center goes along, and the rapid before it; no word of the helix does.
    [Theory]
    [InlineData("5 CP IPA+720 IZ-4 DR+")]
    [InlineData("5 CP IPA+720 Z-2 DR+")]
    [InlineData("5 CP PA+360 Z-2 DR+")]
    public void A_helix_in_Klartext_goes_along(string helix)
    {
        var program = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+25 Y+0 R0 FMAX\n3 L Z+2 R0 FMAX\n4 CC X+20 Y+0\n" + helix
            + " F500\n6 L X+25 Y+20\n7 L X-10\n8 L Z+50 FMAX\n9 END PGM A MM\n";

        Assert.Equal(
            program.Replace("X+25", "X+24.9", StringComparison.Ordinal).Replace("X+20", "X+19.9", StringComparison.Ordinal)
                .Replace("Y+20", "Y+19.9", StringComparison.Ordinal),
            Bench.Normal(program, 0.1, "N6..N7", NcDialects.HeidenhainKlartext));
        Assert.Equal(
            program.Replace("X+25 Y+0", "X+25.1 Y+0.2", StringComparison.Ordinal)
                .Replace("X+20 Y+0", "X+20.1 Y+0.2", StringComparison.Ordinal)
                .Replace("X+25 Y+20", "X+25.1 Y+20.2", StringComparison.Ordinal).Replace("X-10", "X-9.9", StringComparison.Ordinal),
            Bench.By(program, new(0.1, 0.2, 0), "N5..N7", NcDialects.HeidenhainKlartext));
    }

    // Down the wall of a bore, and once around at its bottom: the helix would cut into the wall on one side.
    [Fact]
    public void A_helix_on_a_named_circle_does_not_go_aside()
    {
        const string Program = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+25 Y+0 R0 FMAX\n3 L Z+2 R0 FMAX\n4 CC X+20 Y+0\n"
            + "5 CP IPA+720 IZ-4 DR+ F500\n6 CC X+20 Y+0\n7 CP IPA+360 DR+\n8 L X+20 Y+0\n9 END PGM A MM\n";

        Assert.Equal(
            (NcRefusalCodes.ArcForm, 6),
            (Bench.RefusedNormal(Program, 0.1, "N7", NcDialects.HeidenhainKlartext) is var refusal ? refusal.Code : "",
                refusal.Place.Line));
    }

    [Fact]
    public void Points_along_the_contour_take_the_lead_along()
    {
        var path = Bench.Read(Before + In + Contour + Out + After);
        var wish = Bench.Usable(PointwiseWish.Of(
            path, Bench.Blocks(path, "N4..N8"), [new(new(14, -10), new(0, -0.1)), new(new(0, 10), new(0, -0.1))])).Wish;
        var text = Bench.Text(Bench.Rewritten(path, wish).Program);

        Assert.Contains("N1 G0 X20. Y-10.1\n", text, StringComparison.Ordinal);
        Assert.Contains(In, text, StringComparison.Ordinal);
        Assert.Contains(Out, text, StringComparison.Ordinal);
    }
}
