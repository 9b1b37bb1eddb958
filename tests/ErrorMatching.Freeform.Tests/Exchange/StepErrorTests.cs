using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

/// <summary>What is wrong in a STEP file is named by line and instance, with what was found and what is expected.</summary>
public sealed class StepErrorTests
{
    // Lines 11 to 14 of the file.
    private static readonly string Corners = StepByHand.Points(101, "0.,0.,0.5", "0.,2.,0.5", "3.,0.,0.5", "3.,2.,0.5");

    // Lines 15 to 19: a face on the surface #100 that each test adds behind them, with a circle for its limit.
    private const string Face = "#90=ADVANCED_FACE('',(#91),#100,.T.);\n#91=FACE_BOUND('',#92,.T.);\n#92=EDGE_LOOP('',(#93)"
        + ");\n#93=ORIENTED_EDGE('',*,*,#94,.T.);\n#94=EDGE_CURVE('',#95,#95,#96,.T.);\n#95=VERTEX_POINT('',#104);\n";

    // The surface itself in line 15.
    [Theory]
    [InlineData(
        "B_SPLINE_SURFACE_WITH_KNOTS('',99,1,((#101,#102),(#103,#104)),.U.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),.U.)",
        "bad-value",
        "99 as attribute 2",
        "a whole number from 1 to")]
    [InlineData(
        "B_SPLINE_SURFACE_WITH_KNOTS('',1,1,(#101,#102),.U.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),.U.)",
        "bad-value",
        "no lists of poles",
        "rows of references to points are expected")]
    [InlineData(
        "B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((101,#102),(#103,#104)),.U.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),.U.)",
        "bad-value",
        "attribute 4",
        "reference")]
    [InlineData(
        "B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#100,#102),(#103,#104)),.U.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),.U.)",
        "bad-reference",
        "refers to #100 B_SPLINE_SURFACE_WITH_KNOTS",
        "CARTESIAN_POINT is expected")]
    [InlineData(
        "B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#101,#102),(#103,#104)),.U.,.F.,.F.,.F.,(2,2,1),(2,2),(0.,1.),(0.,1.),.U.)",
        "bad-value",
        "3 multiplicities for 2 knots",
        "as many of the one as of the other are expected")]
    [InlineData(
        "B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#101,#102),(#103,#104)),.U.,.F.,.F.,.F.,(2,9),(2,2),(0.,1.),(0.,1.),.U.)",
        "bad-value",
        "multiplicity 2 of the knots",
        "no whole number from 1 to 2")]
    [InlineData(
        "B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#101,#102),(#103,#104)),.U.,.F.,.F.,.F.,(2,2),(2,2),(0.,'1'),(0.,1.),.U.)",
        "bad-value",
        "attribute 11 has an item that is no number",
        "numbers are expected")]
    [InlineData(
        "B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#101,#102),(#103,#104)),.U.,.F.,.F.,.F.,(2,2),(2,2),(1.,0.),(0.,1.),.U.)",
        "bad-surface",
        "B_SPLINE_SURFACE_WITH_KNOTS",
        "knot")]
    [InlineData("B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#101,#102),(#103,#104)))", "bad-value", "it has 4 attributes", "more are expected")]
    [InlineData(
        "UNIFORM_SURFACE('',1,1,((#101,#102),(#103,#104)),.U.,.F.,.F.,.F.)", "not-read", "UNIFORM_SURFACE", "B_SPLINE_SURFACE_WITH_KNOTS")]
    [InlineData(
        "(BOUNDED_SURFACE()B_SPLINE_SURFACE(1,1,((#101,#102),(#103,#104)),.U.,.F.,.F.,.F.)B_SPLINE_SURFACE_WITH_KNOTS((2,2),(2,2),(0.,1.)"
            + ",(0.,1.),.U.)RATIONAL_B_SPLINE_SURFACE(((1.,1.)))SURFACE())",
        "bad-value",
        "2 weights for 4 poles",
        "one for each is expected")]
    [InlineData(
        "(BOUNDED_SURFACE()B_SPLINE_SURFACE(1,1,((#101,#102),(#103,#104)),.U.,.F.,.F.,.F.)B_SPLINE_SURFACE_WITH_KNOTS((2,2),(2,2),(0.,1.)"
            + ",(0.,1.),.U.)RATIONAL_B_SPLINE_SURFACE((1.,1.,1.,1.))SURFACE())",
        "bad-value",
        "weights that are not in rows",
        "rows as of the poles are expected")]
    [InlineData("PLANE('',#101)", "no-limits", "a plane or cylinder without a face", "a face is expected")]
    public void A_surface_is_refused_with_instance_and_line(string surface, string code, string found, string expected) =>
        Refused(StepByHand.File("#100", $"{Corners}\n#100={surface};"), code, 15, found, expected);

    // What the face needs begins in line 21.
    [Theory]
    [InlineData(
        "#100=CONICAL_SURFACE('',#103,1.,0.5);", "not-read", 21, "#100 CONICAL_SURFACE", "Export the surface as a B-spline (NURBS)")]
    [InlineData(
        "#100=CYLINDRICAL_SURFACE('',#97,-5.);\n#97=AXIS2_PLACEMENT_3D('',#101,$,$);",
        "bad-value",
        21,
        "a radius of -5",
        "a positive one is expected")]
    [InlineData(
        "#100=PLANE('',#97);\n#97=AXIS2_PLACEMENT_3D('',#101,#98,#98);\n#98=DIRECTION('',(0.,0.,1.));",
        "bad-value",
        22,
        "axes of length zero or parallel to each other",
        "two that span a plane are expected")]
    [InlineData(
        "#100=PLANE('',#97);\n#97=AXIS2_PLACEMENT_3D('',#101,$,$);\n#96=CIRCLE('',#97,0.);",
        "bad-value",
        23,
        "a radius of 0",
        "a positive one is expected")]
    [InlineData(
        "#100=PLANE('',#97);\n#97=AXIS2_PLACEMENT_3D('',#101,$,$);\n#96=PARABOLA('',#97,1.);",
        "not-read",
        23,
        "a curve of this kind is not read",
        "Export edges as B-splines")]
    [InlineData(
        "#100=PLANE('',#97);\n#97=AXIS2_PLACEMENT_3D('',#101,$,$);\n#96=B_SPLINE_CURVE_WITH_KNOTS('',1,(#101,#104),.U.,.F.,.F.,(2,2),(1.,"
            + "0.),.U.);",
        "bad-curve",
        23,
        "B_SPLINE_CURVE_WITH_KNOTS",
        "knot")]
    [InlineData(
        "#100=PLANE('',#97);\n#97=AXIS2_PLACEMENT_3D('',#101,$,$);\n#96=SURFACE_CURVE('',#96,(),.CURVE_3D.);",
        "too-deep",
        19,
        "#94 EDGE_CURVE",
        "curves that refer to one another without end")]
    public void A_face_is_refused_with_instance_and_line(string data, string code, int line, string found, string expected) =>
        Refused(StepByHand.File("#90", $"{Corners}\n{Face}{data}"), code, line, found, expected);

    [Theory]
    [InlineData(
        "FACE_BOUND('',#92,.T.)",
        "EDGE_LOOP('',(#93))",
        "bad-reference",
        16,
        "#91 EDGE_LOOP",
        "FACE_BOUND or FACE_OUTER_BOUND is expected")]
    [InlineData(
        "EDGE_LOOP('',(#93))",
        "PATH('',(#93))",
        "not-read",
        17,
        "a loop of this kind is not read",
        "EDGE_LOOP, POLY_LOOP and VERTEX_LOOP are")]
    [InlineData("EDGE_LOOP('',(#93))", "POLY_LOOP('',(#101,#102))", "bad-loop", 17, "a loop of 2 points", "three are expected at least")]
    [InlineData(
        "ORIENTED_EDGE('',*,*,#94,.T.)", "ORIENTED_EDGE('',*,*,#94,1)", "bad-value", 18, "attribute 5 is not", "a word between points")]
    [InlineData(
        "ORIENTED_EDGE('',*,*,#94,.T.)",
        "ORIENTED_EDGE('',*,*,#95,.T.)",
        "bad-reference",
        18,
        "attribute 4 refers to #95 VERTEX_POINT",
        "EDGE_CURVE is expected")]
    [InlineData(
        "EDGE_CURVE('',#95,#95,#96,.T.)",
        "EDGE_CURVE('',#95,#95,#77,.T.)",
        "bad-reference",
        19,
        "attribute 4 refers to #77",
        "which the file does not have")]
    public void An_edge_is_refused_with_instance_and_line(string old, string text, string code, int line, string found, string expected)
    {
        Assert.Contains(old, Face, StringComparison.Ordinal);
        Refused(
            StepByHand.File(
                "#90",
                $"{Corners}\n{Face.Replace(old, text, StringComparison.Ordinal)}#100=PLANE('',#97);\n#97=AXIS2_PLACEMENT_3D('',#101,$,$)"
                    + $";\n#96=CIRCLE('',#97,1.);"),
            code,
            line,
            found,
            expected);
    }

    [Theory]
    [InlineData("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n", "no-data", null, "no instance", "#1 = ...;")]
    [InlineData("die\nfacet normal 0 0 1\n", "no-step", 1, "does not begin with ISO-10303-21", "a STEP file is expected")]
    [InlineData(
        "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=PLANE('',#2);\n#2 PLANE('',#3);\nENDSEC;\n",
        "bad-instance",
        6,
        "#2 PLANE",
        "#number = TYPE(...); is expected")]
    [InlineData(
        "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=PLANE('',#2);\n",
        "no-surface",
        null,
        "no face and no surface in any representation",
        "Export the surface or the solid itself")]
    public void A_file_is_refused(string text, string code, int? line, string found, string expected) =>
        Refused(Encoding.Latin1.GetBytes(text), code, line, found, expected);

    private static void Refused(byte[] file, string code, int? line, string found, string expected)
    {
        var error = Assert.Throws<InputException>(() => StepByHand.Read(file));
        Assert.Equal((code, "hand.stp", line), (error.Code, error.File, error.Place.Line));
        Assert.Contains(found, error.Problem, StringComparison.Ordinal);
        Assert.Contains(expected, error.Problem, StringComparison.Ordinal);
    }
}
