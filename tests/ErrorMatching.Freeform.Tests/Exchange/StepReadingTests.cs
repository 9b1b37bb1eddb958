using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

public sealed class StepReadingTests
{
    private static readonly string Corners = StepByHand.Points(101, "0.,0.,0.5", "0.,2.,0.5", "3.,0.,0.5", "3.,2.,0.5");

    private static readonly string Flat = Corners
        + "\n#100=B_SPLINE_SURFACE_WITH_KNOTS('TOP',1,1,((#101,#102),(#103,#104)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.)"
            + ",.UNSPECIFIED.);";

    [Fact]
    public void A_surface_without_a_face_is_whole()
    {
        var read = StepByHand.Read(StepByHand.File("#100", Flat));
        Assert.Equal("TOP", read.Name);
        Assert.True(read.Region.IsWhole);
        Assert.Equal(new Point3(3, 2, 0.5), read.Spline.PointAt(1, 1));
    }

    [Fact]
    public void Inches_become_millimeters()
    {
        var p = StepByHand.Read(StepByHand.File("#100", Flat, StepByHand.Inch)).Spline.PointAt(1, 1);
        Assert.Equal(0, (p - new Point3(76.2, 50.8, 12.7)).Length, 1e-12);
    }

    [Theory]
    [InlineData("$,.METRE.", 1000)]
    [InlineData(".CENTI.,.METRE.", 10)]
    [InlineData(".MICRO.,.METRE.", 0.001)]
    public void A_prefix_decides_on_the_size(string unit, double millimeters)
    {
        var p = StepByHand.Read(StepByHand.File("#100", Flat, $"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({unit}))")).Spline.PointAt(1, 1);
        Assert.Equal(3 * millimeters, p.X, 1e-12 * millimeters);
    }

    [Theory]
    [InlineData("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))", "bad-unit", 8)]
    [InlineData("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.RADIAN.))", "bad-unit", 9)]
    [InlineData("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.METRE.))", "bad-value", 9)]
    public void A_file_without_a_unit_of_length_is_refused(string unit, string code, int line)
    {
        var error = Assert.Throws<InputException>(() => StepByHand.Read(StepByHand.File("#100", Flat, unit)));
        Assert.Equal(code, error.Code);
        Assert.Equal(line, error.Place.Line);
    }

    [Fact]
    public void Comments_lines_and_escapes_are_read()
    {
        var text = Flat.Replace(
            "#100=B_SPLINE_SURFACE_WITH_KNOTS('TOP',1",
            "/* ; #7=' */ #100 /* a */\n = b_spline_surface_with_knots /**/ ( 'it''s \\X2\\6C34\\X0\\ \\X\\FC; \\S\\D' ,\r\n 1",
            StringComparison.Ordinal).Replace("#103", "\n#103\n", StringComparison.Ordinal);
        Assert.Equal("it's 水 ü; Ä", StepByHand.Read(StepByHand.File("#100", text)).Name);
    }

    [Fact]
    public void A_rational_cylinder_is_round()
    {
        var w = Math.Sqrt(0.5).ToString("R", System.Globalization.CultureInfo.InvariantCulture);
        var points = StepByHand.Points(101, "-50.,0.,0.", "-50.,30.,0.", "-50.,0.,50.", "-50.,30.,50.", "0.,0.,50.", "0.,30.,50.");
        var spline = StepByHand.Read(StepByHand.File(
            "#100",
            $"{points}\n#100=(BOUNDED_SURFACE()B_SPLINE_SURFACE(2,1,((#101,#102),(#103,#104),(#105,#106)),.CYLINDRICAL_SURF.,.F.,.F.,.F.)"
                + $"B_SPLINE_SURFACE_WITH_KNOTS((3,3),(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.)GEOMETRIC_REPRESENTATION_ITEM()"
                + $"RATIONAL_B_SPLINE_SURFACE(((1.,1.),({w},{w}),(1.,1.)))REPRESENTATION_ITEM('ROUND')SURFACE());")).Spline;
        Assert.True(spline.IsRational);
        for (var i = 1; i < 20; i++)
        {
            var p = spline.PointAt(i / 20.0, 0.3);
            Assert.Equal(50, Math.Sqrt((p.X * p.X) + (p.Z * p.Z)), 1e-12);
            Assert.Equal(9, p.Y, 1e-12);
        }
    }

    [Fact]
    public void A_plane_is_as_large_as_its_face()
    {
        // A triangle, one edge passed against its direction.
        var data = $"""
            {StepByHand.Points(101, "0.,0.,7.", "60.,0.,7.", "60.,40.,7.")}
            {StepByHand.Line(200, 101, 102)}
            {StepByHand.Line(210, 102, 103, forward: false)}
            {StepByHand.Line(220, 103, 101)}
            #9999=DIRECTION('',(1.,0.,0.));
            #300=EDGE_LOOP('',(#200,#210,#220));
            #301=FACE_OUTER_BOUND('',#300,.T.);
            #302=PLANE('',#303);
            #303=AXIS2_PLACEMENT_3D('',#101,$,$);
            #304=ADVANCED_FACE('SHELF',(#301),#302,.T.);
            #305=OPEN_SHELL('',(#304));
            #306=SHELL_BASED_SURFACE_MODEL('',(#305));
            """;
        var read = StepByHand.Read(StepByHand.File("#306", data));
        Assert.Equal("SHELF", read.Name);
        Assert.Equal(0, (read.Spline.PointAt(60, 40) - new Point3(60, 40, 7)).Length, 1e-12);
        Assert.Equal(1200, Math.Abs(RegionLoop.Area(Assert.Single(read.Region.Loops))), 1e-9);
        Assert.True(read.Region.Contains(50, 10));
        Assert.False(read.Region.Contains(10, 30));
    }

    [Fact]
    public void A_hole_in_a_spline_surface_is_found_in_space()
    {
        var data = $"""
            {Flat}
            #200=ORIENTED_EDGE('',*,*,#201,.F.);
            #201=EDGE_CURVE('',#202,#202,#204,.T.);
            #202=VERTEX_POINT('',#203);
            #203=CARTESIAN_POINT('',(2.,1.,0.5));
            #204=CIRCLE('',#205,0.5);
            #205=AXIS2_PLACEMENT_3D('',#206,$,$);
            #206=CARTESIAN_POINT('',(1.5,1.,0.5));
            #300=EDGE_LOOP('',(#200));
            #301=FACE_BOUND('',#300,.T.);
            #302=POLY_LOOP('',(#101,#102,#104,#103));
            #303=FACE_OUTER_BOUND('',#302,.T.);
            #304=ADVANCED_FACE('',(#301,#303),#100,.T.);
            #305=CLOSED_SHELL('',(#304));
            #306=MANIFOLD_SOLID_BREP('',#305);
            """;
        var region = StepByHand.Read(StepByHand.File("#306", data, StepByHand.Inch)).Region;
        Assert.Equal(2, region.Loops.Count);
        Assert.False(region.Contains(0.5, 0.5));
        Assert.True(region.Contains(0.1, 0.1));
        Assert.All(region.Loops[0], q => Assert.Equal(0.5, new Point2(3 * q.X, 2 * q.Y).DistanceTo(new(1.5, 1)), 1e-7));
    }

    [Fact]
    public void Surfaces_are_chosen_by_name_or_number()
    {
        var data = Flat + "\n"
            + Flat.Replace("#10", "#20", StringComparison.Ordinal)
                .Replace("'TOP'", "'NONE'", StringComparison.Ordinal)
                .Replace("3.,", "4.,", StringComparison.Ordinal);
        var file = StepByHand.File("#100,#200", data);
        Assert.Equal(3, StepByHand.Read(file, "TOP").Spline.PointAt(1, 1).X);
        Assert.Equal(4, StepByHand.Read(file, "2").Spline.PointAt(1, 1).X);
        Assert.Equal("2", StepByHand.Read(file, "2").Name);
        Assert.Equal("several-surfaces", Assert.Throws<InputException>(() => StepByHand.Read(file)).Code);
        Assert.Equal("no-such-surface", Assert.Throws<InputException>(() => StepByHand.Read(file, "BOTTOM")).Code);
    }

    [Theory]
    [InlineData("#100=TOROIDAL_SURFACE('',#101,50.,10.);", "not-read", "#100 TOROIDAL_SURFACE")]
    [InlineData(
        "#100=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#101,#102),(#103,#999)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.)"
            + ",.UNSPECIFIED.);",
        "bad-reference",
        "#999, which the file does not have")]
    [InlineData(
        "#100=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#101,#102),(#103)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.)"
            + ",.UNSPECIFIED.);",
        "bad-value",
        "rows of poles of different lengths")]
    [InlineData(
        "#100=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#101,#102),(#103,#104)),.UNSPECIFIED.,.F.,.F.,.F.,(2,1),(2,2),(0.,1.),(0.,1.)"
            + ",.UNSPECIFIED.);",
        "bad-surface",
        "knots")]
    [InlineData("#100=B_SPLINE_SURFACE_WITH_KNOTS('',1,x,((#101,#102),(#103,#104)));", "bad-instance", "\"(\" is expected")]
    [InlineData("#100=B_SPLINE_SURFACE_WITH_KNOTS('',1,1", "truncated", "ends within a statement")]
    [InlineData("#100=PLANE('',#101);\n#100=PLANE('',#101);", "bad-instance", "#100 is there twice")]
    public void What_cannot_be_read_is_named_with_its_line(string instance, string code, string said)
    {
        var file = StepByHand.File("#100", Corners + "\n" + instance);
        if (code == "truncated")
        {
            file = Encoding.Latin1.GetBytes(Encoding.Latin1.GetString(file).Split("ENDSEC;\nEND")[0]);
        }

        var error = Assert.Throws<InputException>(() => StepByHand.Read(file));
        Assert.Equal(code, error.Code);
        Assert.Contains(said, error.Problem, StringComparison.Ordinal);
        Assert.Equal(
            instance.Contains("twice", StringComparison.Ordinal) || instance.Contains('\n', StringComparison.Ordinal) ? 16 : 15,
            error.Place.Line);
    }

    [Fact]
    public void A_part_that_an_assembly_moves_is_refused()
    {
        var data = Flat + """

            #400=ITEM_DEFINED_TRANSFORMATION('','',#401,#402);
            #401=AXIS2_PLACEMENT_3D('',#101,$,$);
            #402=AXIS2_PLACEMENT_3D('',#104,$,$);
            """;
        Assert.Equal("assembly", Assert.Throws<InputException>(() => StepByHand.Read(StepByHand.File("#100", data))).Code);
        Assert.Equal("TOP", StepByHand.Read(StepByHand.File("#100", data.Replace("#104,$", "#101,$", StringComparison.Ordinal))).Name);
    }
}
