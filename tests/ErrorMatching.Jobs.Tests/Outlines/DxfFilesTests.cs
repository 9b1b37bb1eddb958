using System.Text;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Forms, units, layers and notes of DXF files.</summary>
public sealed class DxfFilesTests
{
    private static readonly DxfSample Everything = new DxfSample()
        .Unit(4)
        .Layer("OUTLINE")
        .Block("B", 1, 2, [.. DxfSample.Entity("LINE", "0", 10, 0, 20, 0, 11, 1, 21, 1), .. DxfSample.Entity("TEXT", "0", 10, 0, 20, 0)])
        .Entities(
        [
            .. DxfSample.Entity("LINE", "OUTLINE", 10, 0.1, 20, 0.2, 11, 1e-3, 21, -7),
            "310 00FF0A",
            "1071 5",
            .. DxfSample.Entity("ARC", "0", 10, 1, 20, 1, 40, 2, 50, 10, 51, 200),
            .. DxfSample.Entity("LWPOLYLINE", "OUTLINE", 90, 3, 70, 1, 10, 0, 20, 0, 42, 0.5, 10, 4, 20, 0, 10, 4, 20, 9),
            .. DxfSample.Entity("SPLINE", "0", 71, 2, 72, 6, 73, 3, 40, 0, 40, 0, 40, 0, 40, 1, 40, 1, 40, 1),
            "10 0", "20 0", "10 5", "20 9", "10 9", "20 0",
            .. DxfSample.Entity("INSERT", "0", 10, 7, 20, 7), "2 B",
            .. DxfSample.Entity("ELLIPSE", "0", 10, 1, 20, 1, 11, 2, 21, 1, 40, 0.5, 41, 0, 42, 3, 230, 1),
        ]);

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Binary_files_give_what_their_text_gives(bool hasShortCodes)
    {
        // Extended data has codes of two bytes in either form.
        var sample = Everything;
        var text = DxfReader.Read(sample.Bytes(), "part.dxf", null);
        var binary = DxfReader.Read(sample.Binary(hasShortCodes), "part.dxf", null);
        Assert.Equal(7 + 1, text.Curves.Count);
        Assert.Equal(text.Unit, binary.Unit);
        Assert.Equal(text.Notes, binary.Notes);
        Assert.Equal(text.Curves.Select(Geometry), binary.Curves.Select(Geometry));
        Assert.StartsWith("LINE at byte ", binary.Curves[0].Entity, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("\n")]
    [InlineData("\r\n")]
    [InlineData("\r")]
    public void Line_ends_and_blanks_do_not_matter(string end)
    {
        var text = Everything.Text(end).Replace("OUTLINE" + end, "  OUTLINE \t" + end, StringComparison.Ordinal);
        var drawing = DxfReader.Read(Encoding.UTF8.GetBytes("999" + end + "a comment" + end + text + end), "part.dxf", null);
        Assert.Equal(Everything.Read().Curves.Select(Geometry), drawing.Curves.Select(Geometry));
    }

    [Theory]
    [InlineData(1, 25.4)]
    [InlineData(2, 304.8)]
    [InlineData(4, 1)]
    [InlineData(5, 10)]
    [InlineData(6, 1000)]
    [InlineData(8, 0.0000254)]
    [InlineData(9, 0.0254)]
    [InlineData(13, 0.001)]
    [InlineData(14, 100)]
    public void The_unit_is_that_of_the_header(int code, double mm)
    {
        var drawing = DxfSample.Of(DxfSample.Entity("CIRCLE", "0", 10, 100, 20, 0, 40, 50)).Unit(code).Read();
        Assert.Equal(new DrawingUnit(mm, true), drawing.Unit);
        var circle = (DrawnArc)drawing.Curves[0];
        Assert.Equal(100 * mm, circle.Center.X, 1e-12 * 100 * mm);
        Assert.Equal(50 * mm, circle.Radius, 1e-12 * 50 * mm);
    }

    [Fact]
    public void A_unit_that_nobody_states_is_told()
    {
        var line = DxfSample.Entity("LINE", "0", 10, 0, 20, 0, 11, 2, 21, 0);
        Assert.Equal(new DrawingUnit(1, false), DxfSample.Of(line).Read().Unit);
        Assert.Equal(new DrawingUnit(1, false), DxfSample.Of(line).Unit(0).Read().Unit);
    }

    [Fact]
    public void The_unit_of_the_caller_wins()
    {
        var sample = DxfSample.Of(DxfSample.Entity("LINE", "0", 10, 0, 20, 0, 11, 2, 21, 0)).Unit(18);
        Assert.Equal("bad-unit", sample.Refused().Code);
        var drawing = sample.Read(25.4);
        Assert.Equal(new DrawingUnit(25.4, true), drawing.Unit);
        Assert.Equal(50.8, drawing.Curves[0].To.X, 1e-12);
    }

    [Fact]
    public void Layers_that_are_off_or_frozen_are_told()
    {
        var drawing = new DxfSample()
            .Layer("Cut").Layer("Off", color: -3).Layer("Frozen", flags: 1).Layer("Locked", flags: 4)
            .Block("B", 0, 0, [
                .. DxfSample.Entity("LINE", "0", 10, 0, 20, 0, 11, 1, 21, 0),
                .. DxfSample.Entity("LINE", "CUT", 10, 0, 20, 0, 11, 2, 21, 0)])
            .Entities(
            [
                .. DxfSample.Entity("LINE", "cut", 10, 0, 20, 0, 11, 3, 21, 0),
                .. DxfSample.Entity("LINE", "OFF", 10, 0, 20, 0, 11, 4, 21, 0),
                .. DxfSample.Entity("LINE", "Frozen", 10, 0, 20, 0, 11, 5, 21, 0),
                .. DxfSample.Entity("LINE", "Locked", 10, 0, 20, 0, 11, 6, 21, 0),
                .. DxfSample.Entity("INSERT", "Off", 10, 0, 20, 0), "2 B",
                .. DxfSample.Entity("INSERT", "Frozen", 10, 0, 20, 0), "2 B",
            ]).Read();
        Assert.Equal([("Cut", 3.0), ("Locked", 6), ("Cut", 2)], drawing.Curves.Select(c => (c.Layer, c.To.X)));
        Assert.Equal(["Passed over on layers that are off or frozen: 4 entities (\"Off\", \"Frozen\")."], drawing.Notes);
    }

    [Fact]
    public void What_is_no_curve_is_told()
    {
        var drawing = DxfSample.Of(
        [
            .. DxfSample.Entity("LINE", "0", 10, 0, 20, 0, 11, 3, 21, 0),
            .. DxfSample.Entity("TEXT", "0", 10, 0, 20, 0),
            .. DxfSample.Entity("TEXT", "0", 10, 0, 20, 0),
            .. DxfSample.Entity("HATCH", "0", 10, 0, 20, 0),
            .. DxfSample.Entity("LINE", "0", 67, 1, 10, 0, 20, 0, 11, 3, 21, 0),
            .. DxfSample.Entity("LINE", "0", 60, 1, 10, 0, 20, 0, 11, 3, 21, 0),
            .. DxfSample.Entity("LINE", "0", 10, 1, 20, 1, 11, 1, 21, 1),
            .. DxfSample.Entity("CIRCLE", "0", 10, 1, 20, 1, 40, 0),
            .. DxfSample.Entity("CIRCLE", "0", 10, 1, 20, 1, 40, 2, 210, 1, 220, 0, 230, 0),
            .. DxfSample.Entity("LINE", "0", 10, 1, 20, 1, 30, 0, 11, 5, 21, 1, 31, 2),
            .. DxfSample.Entity("LWPOLYLINE", "0", 90, 2, 43, 0.5, 10, 0, 20, 0, 10, 7, 20, 0),
        ]).Read();
        Assert.Equal([3.0, 5, 7], drawing.Curves.Select(c => c.To.X));
        Assert.Equal(
            [
                "Passed over as no curves: 2 TEXT, 1 HATCH.",
                "Passed over in paper space: 1 entity (first: LINE at line 41).",
                "Passed over as invisible: 1 entity (first: LINE at line 55).",
                "Passed over as shorter than 0.000001 mm: 1 curve (first: LINE at line 69).",
                "Passed over, because a radius or an axis is 0: 1 entity (first: CIRCLE at line 81).",
                "Passed over, because their extrusion is not along Z: 1 entity (first: CIRCLE at line 91).",
                "Projected onto XY, because Z changes along them: 1 entity (first: LINE at line 107).",
                "Read as their center lines, because they have a width: 1 entity (first: LWPOLYLINE at line 123).",
            ],
            drawing.Notes);
    }

    [Fact]
    public void The_same_height_everywhere_does_not_matter()
    {
        var drawing = DxfSample.Of(DxfSample.Entity("LINE", "0", 10, 1, 20, 1, 30, 9, 11, 5, 21, 1, 31, 9)).Read();
        Assert.Single(drawing.Curves);
        Assert.Empty(drawing.Notes);
    }

    [Theory]
    [InlineData("ANSI_1252", 1252, "Außenkontur")]
    [InlineData("ANSI_1251", 1251, "Контур")]
    [InlineData("ANSI_932", 932, "外形線")]
    [InlineData("ANSI_936", 936, "联通")]
    public void Names_of_layers_are_in_the_code_page_of_the_header(string page, int number, string name)
    {
        var sample = DxfSample.Of(DxfSample.Entity("LINE", name, 10, 0, 20, 0, 11, 3, 21, 0))
            .Header("9 $ACADVER", "1 AC1015", "9 $DWGCODEPAGE", "3 " + page);
        var encoding = CodePagesEncodingProvider.Instance.GetEncoding(number)!;
        Assert.Equal([name], DxfReader.Read(encoding.GetBytes(sample.Text()), "part.dxf", null).Layers);
    }

    [Fact]
    public void Names_of_layers_may_be_in_UTF_8_or_escaped()
    {
        var sample = DxfSample.Of(
        [
            .. DxfSample.Entity("LINE", "Außen", 10, 0, 20, 0, 11, 3, 21, 0),
            .. DxfSample.Entity("LINE", @"A\U+00DFen", 10, 0, 20, 0, 11, 3, 21, 0),
        ]);
        Assert.Equal(["Außen", "Aßen"], sample.Header("9 $ACADVER", "1 AC1032", "9 $DWGCODEPAGE", "3 ANSI_1252").Read().Layers);
    }

    [Fact]
    public void A_header_that_ends_twice_is_one_header()
    {
        // As dxflib 2.0 writes it.
        var text = DxfSample.Of(DxfSample.Entity("LINE", "0", 10, 0, 20, 0, 11, 2, 21, 0)).Header("9 $ACADVER", "1 AC1015").Unit(1).Text()
            .Replace("  9\n$INSUNITS", "  0\nENDSEC\n  9\n$INSUNITS", StringComparison.Ordinal);
        Assert.Equal(new DrawingUnit(25.4, true), DxfReader.Read(Encoding.UTF8.GetBytes(text), "part.dxf", null).Unit);
    }

    [Fact]
    public void Blocks_without_names_are_no_error() => Assert.Single(
        DxfSample.Of(DxfSample.Entity("LINE", "0", 10, 0, 20, 0, 11, 2, 21, 0)).Block("", 0, 0).Block("", 0, 0).Read().Curves);

    [Fact]
    public void Data_of_other_programs_in_an_entity_is_no_geometry()
    {
        var drawing = DxfSample.Of(
            "0 LINE", "8 0", "102 {OTHER", "10 99", "11 99", "102 }", "10 1", "20 2", "11 3", "21 4", "1001 OTHER", "1010 77").Read();
        Assert.Equal((1.0, 3.0), (drawing.Curves[0].From.X, drawing.Curves[0].To.X));
    }

    // Places differ between the forms of a file.
    private static string Geometry(DrawnCurve curve) => curve switch
    {
        DrawnCourse course => course.Layer + string.Concat(course.Points),
        DrawnArc arc => (arc with { Entity = "" }).ToString(),
        _ => FormattableString.Invariant($"{curve.Layer} {curve.From} {curve.To}"),
    };
}
