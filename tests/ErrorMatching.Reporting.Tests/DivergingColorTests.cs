using System.Globalization;

namespace ErrorMatching.Reporting.Tests;

public sealed class DivergingColorTests
{
    [Fact]
    public void Zero_is_nearly_white_and_both_ends_are_dark()
    {
        var middle = Rgb(DivergingColors.Count / 2);
        Assert.True(middle.R > 235 && middle.R == middle.G && middle.G == middle.B, $"{middle}");
        Assert.True(Rgb(0).B > Rgb(0).R + 80, "the lowest is blue");
        Assert.True(Rgb(DivergingColors.Count - 1).R > Rgb(DivergingColors.Count - 1).B + 80, "the highest is orange");
    }

    // WCAG 2: contrast of 3 : 1 is what a picture's parts need, and more than 1.1 : 1 between zero and the page, #16191d.
    [Fact]
    public void On_a_dark_page_zero_is_dark_and_both_ends_are_light()
    {
        static double Luma(string hex) => Luminance((
            Convert.ToInt32(hex[1..3], 16), Convert.ToInt32(hex[3..5], 16), Convert.ToInt32(hex[5..7], 16)));
        static double Contrast(string a, string b) => (Math.Max(Luma(a), Luma(b)) + 0.05) / (Math.Min(Luma(a), Luma(b)) + 0.05);
        var (zero, low, high) = (DivergingColors.DarkHexAt(0), DivergingColors.DarkHexAt(-1), DivergingColors.DarkHexAt(1));
        Assert.InRange(Contrast(zero, "#16191d"), 1.1, 1.5);
        Assert.InRange(Contrast(zero, low), 3, 21);
        Assert.InRange(Contrast(zero, high), 3, 21);
        Assert.Equal(DivergingColors.Hex(0), DivergingColors.HexAt(-1));
    }

    [Fact]
    public void Luminance_falls_from_zero_outwards_on_both_sides_alike()
    {
        var luminance = Enumerable.Range(0, DivergingColors.Count).Select(i => Luminance(Rgb(i))).ToArray();
        for (var i = 0; i < DivergingColors.Count / 2; i++)
        {
            Assert.True(luminance[i] < luminance[i + 1]);
            Assert.True(luminance[^(i + 1)] < luminance[^(i + 2)]);
            Assert.Equal(luminance[i], luminance[^(i + 1)], 0.05);
        }
    }

    // Lightness of CIE 1976, another scale than the one that the colors were made by: no step is much larger than the others.
    [Fact]
    public void Steps_look_alike()
    {
        var lightness = Enumerable.Range(0, DivergingColors.Count).Select(i => Lab(Linear(Rgb(i))).L).ToArray();
        var steps = lightness.Zip(lightness.Skip(1), (a, b) => Math.Abs(b - a)).ToArray();
        Assert.All(steps, s => Assert.InRange(s / steps.Average(), 0.75, 1.25));
    }

    // What people see who lack one kind of cone: G. Machado et al., "A physiologically-based model for simulation of color vision
    // deficiency", 2009, severity 1.
    [Theory]
    [InlineData(0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998)]
    [InlineData(0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881)]
    public void Signs_are_told_apart_without_red_or_green(
        double rr, double rg, double rb, double gr, double gg, double gb, double br, double bg, double bb)
    {
        var seen = Enumerable.Range(0, DivergingColors.Count).Select(i => Linear(Rgb(i)))
            .Select(c => Lab(
                ((rr * c.R) + (rg * c.G) + (rb * c.B), (gr * c.R) + (gg * c.G) + (gb * c.B), (br * c.R) + (bg * c.G) + (bb * c.B))))
                .ToArray();
        for (var i = 0; i < DivergingColors.Count / 2; i++)
        {
            var away = (DivergingColors.Count / 2) - i;
            Assert.True(seen[i].B < -1.5 * away && seen[^(i + 1)].B > 1.5 * away, $"{i}: {seen[i]} and {seen[^(i + 1)]}");
        }
    }

    [Theory]
    [InlineData(0, 10)]
    [InlineData(5, 20)]
    [InlineData(-5, 0)]
    [InlineData(-7, 0)]
    [InlineData(0.2, 10)]
    [InlineData(0.3, 11)]
    public void Values_take_the_color_next_to_them(double value, int index) => Assert.Equal(index, DivergingColors.IndexOf(value, 5));

    // Relative luminance of sRGB, by the definition of the WCAG.
    private static double Luminance((int R, int G, int B) c) => (0.2126 * Linear(c.R)) + (0.7152 * Linear(c.G)) + (0.0722 * Linear(c.B));

    private static (double R, double G, double B) Linear((int R, int G, int B) c) => (Linear(c.R), Linear(c.G), Linear(c.B));

    // CIE 1976, white of sRGB.
    private static (double L, double A, double B) Lab((double R, double G, double B) c)
    {
        var x = F(((0.4124 * c.R) + (0.3576 * c.G) + (0.1805 * c.B)) / 0.9505);
        var y = F((0.2126 * c.R) + (0.7152 * c.G) + (0.0722 * c.B));
        var z = F(((0.0193 * c.R) + (0.1192 * c.G) + (0.9505 * c.B)) / 1.089);
        return ((116 * y) - 16, 500 * (x - y), 200 * (y - z));

        static double F(double t) => t > 216.0 / 24389 ? Math.Cbrt(t) : ((24389.0 / 27 * t) + 16) / 116;
    }

    private static double Linear(int value) =>
        value / 255.0 <= 0.04045 ? value / 255.0 / 12.92 : Math.Pow(((value / 255.0) + 0.055) / 1.055, 2.4);

    private static (int R, int G, int B) Rgb(int index)
    {
        var hex = int.Parse(DivergingColors.Hex(index).AsSpan(1), NumberStyles.HexNumber, CultureInfo.InvariantCulture);
        return (hex >> 16, (hex >> 8) & 255, hex & 255);
    }
}
