using System.Globalization;

namespace ErrorMatching.Nc.Tests;

/// <summary>Controls lead the tool's center differently into a contour and around its corners; their dialects say how. Places are those of
/// a drawing, for a tool radius of 3 mm.</summary>
public sealed class CompensationRuleTests
{
    private const string Start = "G17 G40 G90 G0 X-20 Y0 Z5\nG41 D1 G1 X0 F100\n";

    private static readonly NcDialect TypeB = OwnDialect.Of(
        """
        , "settings": {
          "compensationStart": { "value": "next-normal-or-corner", "statement": "Type B.", "source": "parameter 5003#0 = 1" }
        }
        """);

    [Fact]
    public void A_way_in_ends_at_right_angles_to_the_contour()
    {
        Assert.Equal(["Line -3 0", "Line -3 10"], Center("Y10\n", NcDialects.FanucMill));
        Assert.Equal(["Line -3 0", "Line -3 10"], Center("Y10\n", NcDialects.Siemens840D));
        Assert.Equal(["Line 3 0", "Line 3 -10"], Center("Y-10\n", NcDialects.FanucMill));
        Assert.Equal(["Line 3 0", "Line 3 -10"], Center("Y-10\n", NcDialects.Siemens840D));
    }

    [Fact]
    public void A_way_in_of_type_B_goes_around_an_outside_corner()
    {
        Assert.Equal(["Line -3 0", "Line -3 10"], Center("Y10\n", TypeB));
        Assert.Equal(["Line 3 3", "Line 3 -10"], Center("Y-10\n", TypeB));
        Assert.Equal(["Line 0 3", "Line 13 3", "Line 10 -10"], Center("X10\nG40 Y-10\n", TypeB));
    }

    [Fact]
    public void An_outside_corner_goes_on_to_the_intersection()
    {
        // The lines y = 3 and x + y = 10 + 3 sqrt 2.
        string[] wanted = ["Line 0 3", "Line 11.2426 3", "Line 22.1213 -7.8787"];
        Assert.Equal(wanted, Center("X10\nX20 Y-10\n", NcDialects.FanucMill));
        Assert.Equal(wanted, Center("G451\nX10\nX20 Y-10\n", NcDialects.Siemens840D));
    }

    [Fact]
    public void An_outside_corner_is_rounded_by_a_transition_circle()
    {
        string[] wanted = ["Line 0 3", "Line 10 3", "ArcClockwise 12.1213 2.1213", "Line 22.1213 -7.8787"];
        Assert.Equal(wanted, Center("X10\nX20 Y-10\n", NcDialects.Siemens840D));
        Assert.Equal(wanted, Center("G451\nG450\nX10\nX20 Y-10\n", NcDialects.Siemens840D));
        Assert.Equal(
            ["Line 0 3", "Line 10 3", "ArcClockwise 12.1213 -2.1213", "Line 2.1213 -12.1213"],
            Center("G451\nX10\nX0 Y-10\n", NcDialects.Siemens840D));
    }

    [Fact]
    public void A_sharp_outside_corner_is_cut_off_by_a_straight_piece() => Assert.Equal(
        ["Line 0 3", "Line 13 3", "Line 14.2426 0", "Line 2.1213 -12.1213"], Center("X10\nX0 Y-10\n", NcDialects.FanucMill));

    [Fact]
    public void A_straight_piece_leads_from_an_arc() => Assert.Equal(
        // A quarter about (10, -10) that ends downwards; the line turns back and right by 135 degrees.
        ["Line 0 3", "Line 10 3", "ArcClockwise 23 -10", "Line 23 -13", "Line 20 -14.2426", "Line 7.8787 -2.1213"],
        Center("X10\nG2 X20 Y-10 J-10\nG1 X10 Y0\n", NcDialects.FanucMill));

    [Fact]
    public void A_way_around_the_contour_s_end_is_not_followed()
    {
        Assert.Equal("compensation-unfollowed", Refused("KONT\nY-10\n", NcDialects.Siemens840D));
        Assert.Null(Refused("KONT\nY10\n", NcDialects.Siemens840D));
        Assert.Null(Refused("KONT\nNORM\nY-10\n", NcDialects.Siemens840D));
        Assert.Equal("compensation-unfollowed", Refused("KONT\nY10\nG40 X20\n", NcDialects.Siemens840D));
    }

    [Theory]
    [InlineData("X10\nY6.1\nX0\n", null)]
    [InlineData("X10\nY5.9\nX0\n", "compensation-gouge")]
    [InlineData("G3 X3 Y3 J3\nG1 Y9\n", null)]
    [InlineData("G3 X2.99 Y2.99 J2.99\nG1 Y9\n", "compensation-gouge")]
    [InlineData("G41 X10\n", null)]
    [InlineData("G42 X10\n", "compensation-unfollowed")]
    [InlineData("X10 D2\nX20\n", "compensation-unfollowed")]
    [InlineData("X10\nG55\nX20\n", "compensation-unfollowed")]
    public void What_does_not_fit_is_refused_on_every_control(string contour, string? code) =>
        Assert.Equal(code, Refused(contour, NcDialects.FanucMill));

    [Fact]
    public void An_arc_as_tight_as_the_tool_is_touched_from_its_center() => Assert.Equal(
        ["Line 0 3", "Line 0 3", "Line 0 9"], Center("G3 X3 Y3 J3\nG1 Y9\n", NcDialects.FanucMill));

    private static IEnumerable<string> Center(string contour, NcDialect dialect) => Follow(contour, dialect).Motions.Skip(1).Select(
        m => string.Create(CultureInfo.InvariantCulture, $"{m.Kind} {m.End.X + 0.0:0.####} {m.End.Y + 0.0:0.####}"));

    private static string? Refused(string contour, NcDialect dialect) => Follow(contour, dialect).Refusal?.Code;

    private static CompensatedPath Follow(string contour, NcDialect dialect) =>
        CompensatedPath.Of(NcInterpreter.Run(NcProgram.FromText(Start + contour), dialect.With(ToolRadii.Of(3))));
}
