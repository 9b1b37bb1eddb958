using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

public sealed class IgesReadingTests
{
    [Fact]
    public void Inches_become_millimeters()
    {
        var file = new IgesText(
            "1H,,1H;,4HTEST,4HTEST,4HTEST,4HTEST,32,38,6,308,15,4HTEST,1.,1,4HINCH,1,0.01,15H20260101.000000,1.E-6,1000.;");
        file.Add(128, IgesText.Flat(3, 2, 0.5));
        Assert.Equal(0, (file.Read().Spline.PointAt(1, 1) - new Point3(76.2, 50.8, 12.7)).Length, 1e-12);
    }

    [Theory]
    [InlineData("1.,2,2HMM", 1)]
    [InlineData("1.,6,1HM", 1000)]
    [InlineData("1.,10,2HCM", 10)]
    [InlineData("1.,3,4HINCH", 25.4)]
    [InlineData("1.,3,2HUM", 0.001)]
    [InlineData("0.5,2,2HMM", 2)]
    [InlineData(",,", 25.4)]
    [InlineData("1.,2,", 1)]
    public void Unit_flag_unit_name_and_scale_decide_on_the_size(string unit, double millimeters)
    {
        var file = new IgesText($"1H,,1H;,4HTEST,4HTEST,4HTEST,4HTEST,32,38,6,308,15,4HTEST,{unit},1,0.01;");
        file.Add(128, IgesText.Flat(3, 2));
        Assert.Equal(3 * millimeters, file.Read().Spline.PointAt(1, 1).X, 1e-12 * millimeters);
    }

    [Theory]
    [InlineData("1.,2,4HINCH")]
    [InlineData("1.,3,5HCUBIT")]
    [InlineData("1.,12,2HMM")]
    [InlineData("-1.,2,2HMM")]
    public void A_unit_that_contradicts_itself_is_refused(string unit)
    {
        var file = new IgesText($"1H,,1H;,4HTEST,4HTEST,4HTEST,4HTEST,32,38,6,308,15,4HTEST,{unit},1,0.01;");
        file.Add(128, IgesText.Flat(3, 2));
        Assert.Equal("bad-unit", Assert.Throws<InputException>(() => file.Read()).Code);
    }

    [Fact]
    public void Delimiters_can_be_others_and_stand_in_strings()
    {
        var file = new IgesText("1H//1H#/9Ha/b#c,d;e/4HTEST/4HTEST/4HTEST/32/38/6/308/15/4HTEST/1./2/2HMM/1/0.01#") { End = '#' };
        var name = file.Add(406, "406/1/8HA/#B,;CD", form: 15, dependent: true);
        file.Add(128, IgesText.Flat(3, 2).Replace(',', '/') + $"/0/1/{name}");
        Assert.Equal("A/#B,;CD", file.Read().Name);
    }

    [Fact]
    public void Defaulted_delimiters_and_missing_sections_are_read()
    {
        var file = new IgesText(",,4HTEST,4HTEST,4HTEST,4HTEST,32,38,6,308,15,4HTEST,1.,2,2HMM,1,0.01;") { Framed = false };
        file.Add(128, IgesText.Flat(3, 2));
        Assert.Equal(3, file.Read().Spline.PointAt(1, 1).X);
    }

    [Theory]
    [InlineData("\r\n")]
    [InlineData("")]
    [InlineData("   \n\n")]
    public void Records_end_as_they_like(string end)
    {
        var file = new IgesText();
        file.Add(128, IgesText.Flat(3, 2));
        var bytes = Encoding.Latin1.GetBytes(Encoding.Latin1.GetString(file.Bytes()).Replace("\n", end, StringComparison.Ordinal));
        Assert.Equal(3, SurfaceReader.Read(bytes, "a.iges", null, outsideIsUp: true).Spline.PointAt(1, 1).X);
    }

    [Fact]
    public void Exponents_of_Fortran_are_read()
    {
        var file = new IgesText();
        file.Add(128, IgesText.Flat(3, 2).Replace("3,", "3.0D+0,", StringComparison.Ordinal));
        Assert.Equal(3, file.Read().Spline.PointAt(1, 1).X);
    }

    [Fact]
    public void A_rational_cylinder_is_round()
    {
        // A quarter of a cylinder about y, radius 50: weights 1, cos 45, 1.
        var w = Math.Sqrt(0.5).ToString("R", System.Globalization.CultureInfo.InvariantCulture);
        var file = new IgesText();
        file.Add(
            128,
            $"128,2,1,2,1,0,0,0,0,0,0.,0.,0.,1.,1.,1.,0.,0.,1.,1.,1.,{w},1.,1.,{w},1.,-50.,0.,0.,-50.,0.,50.,0.,0.,50.,-50.,30.,0.,-50.,"
                + $"30.,50.,0.,30.,50.,0.,1.,0.,1.");
        var spline = file.Read().Spline;
        Assert.True(spline.IsRational);
        for (var i = 1; i < 20; i++)
        {
            var p = spline.PointAt(i / 20.0, 0.3);
            Assert.Equal(50, Math.Sqrt((p.X * p.X) + (p.Z * p.Z)), 1e-12);
            Assert.Equal(9, p.Y, 1e-12);
        }
    }

    [Fact]
    public void A_matrix_moves_the_surface_before_the_unit_scales_it()
    {
        var file = new IgesText("1H,,1H;,4HTEST,4HTEST,4HTEST,4HTEST,32,38,6,308,15,4HTEST,1.,1,4HINCH,1,0.01;");
        var first = file.Add(124, "124,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,7.");
        var second = file.Add(124, "124,0.,-1.,0.,1.,1.,0.,0.,2.,0.,0.,1.,3.", matrix: first);
        file.Add(128, IgesText.Flat(3, 2), matrix: second);
        var p = file.Read().Spline.PointAt(1, 1);
        Assert.Equal(25.4 * (1 - 2), p.X, 1e-12);
        Assert.Equal(25.4 * (2 + 3), p.Y, 1e-12);
        Assert.Equal(25.4 * (3 + 7), p.Z, 1e-12);
    }

    [Fact]
    public void Surfaces_are_chosen_by_name_or_number()
    {
        var file = new IgesText();
        var name = file.Add(406, "406,1,11HUPPER SHELL", form: 15, dependent: true);
        file.Add(128, IgesText.Flat(1, 1), label: "BASE");
        file.Add(128, IgesText.Flat(2, 1) + $",0,1,{name}");
        file.Add(128, IgesText.Flat(3, 1));
        file.Add(128, IgesText.Flat(9, 1), blanked: true);
        Assert.Equal(1, Width(file.Read("BASE")));
        Assert.Equal(2, Width(file.Read("UPPER SHELL")));
        Assert.Equal(3, Width(file.Read("3")));
        Assert.Equal("3", file.Read("3").Name);
        Assert.Equal("no-such-surface", Assert.Throws<InputException>(() => file.Read("4")).Code);
        var several = Assert.Throws<InputException>(() => file.Read());
        Assert.Equal("several-surfaces", several.Code);
        Assert.Contains(
            "1 \"BASE\" (x 0 to 1, y 0 to 1, z 0 to 0), 2 \"UPPER SHELL\" (x 0 to 2, y 0 to 1, z 0 to 0), 3 (x 0 to 3",
            several.Problem,
            StringComparison.Ordinal);
    }

    [Fact]
    public void A_kind_of_surface_that_is_not_read_is_named_with_its_place()
    {
        var file = new IgesText();
        file.Add(110, "110,0.,0.,0.,1.,0.,0.");
        file.Add(190, "190,1,1,1");
        var error = Assert.Throws<InputException>(() => file.Read());
        Assert.Equal("not-read", error.Code);
        Assert.Contains("entity 190 at D3", error.Problem, StringComparison.Ordinal);
        Assert.Equal(6, error.Place.Line);
    }

    [Fact]
    public void A_file_without_a_surface_says_what_it_has()
    {
        var file = new IgesText();
        file.Add(110, "110,0.,0.,0.,1.,0.,0.");
        var error = Assert.Throws<InputException>(() => file.Read());
        Assert.Equal("no-surface", error.Code);
        Assert.Contains("110 (1, first at D1)", error.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void A_parameter_that_is_no_number_is_named_with_its_line()
    {
        var file = new IgesText();
        file.Add(128, IgesText.Flat(3, 2).Replace("3,2,0,", "3,x2,0,", StringComparison.Ordinal));
        var error = Assert.Throws<InputException>(() => file.Read());
        Assert.Equal("bad-number", error.Code);
        Assert.Contains("entity 128 at D1", error.Problem, StringComparison.Ordinal);
        Assert.Equal(7, error.Place.Line);
    }

    [Fact]
    public void Missing_records_are_noticed()
    {
        var file = new IgesText();
        file.Add(128, IgesText.Flat(3, 2));
        var lines = Encoding.Latin1.GetString(file.Bytes()).Split('\n').ToList();
        lines.RemoveAt(5);
        var error = Assert.Throws<InputException>(() => SurfaceReader.Read(
            Encoding.Latin1.GetBytes(string.Join('\n', lines)), "a.igs", null, outsideIsUp: true));
        Assert.Equal("bad-record", error.Code);
        Assert.Equal(6, error.Place.Line);
    }

    [Fact]
    public void A_surface_limited_by_its_own_last_parameters_is_cut_there()
    {
        var file = new IgesText();
        file.Add(128, IgesText.Flat(60, 40).Replace("0.,1.,0.,1.", "0.25,0.5,0.,1.", StringComparison.Ordinal));
        var spline = file.Read().Spline;
        Assert.Equal(0.25, spline.KnotsU.Start);
        Assert.Equal(0.5, spline.KnotsU.End);
        Assert.Equal(30, spline.PointAt(0.5, 1).X, 1e-12);
    }

    [Fact]
    public void A_global_section_without_an_end_is_read_as_far_as_it_goes()
    {
        var file = new IgesText("1H,,1H;,4HTEST,4HTEST,4HTEST,4HTEST,32,38,6,308,15,4HTEST,1.,1,4HINCH,1,0.01");
        file.Add(128, IgesText.Flat(3, 2));
        Assert.Equal(76.2, file.Read().Spline.PointAt(1, 1).X, 1e-12);
    }

    private static double Width(PartSurface surface) => surface.Spline.PointAt(1, 1).X;
}
