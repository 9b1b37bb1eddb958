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

    private static double Linear(int value) => value / 255.0 <= 0.04045 ? value / 255.0 / 12.92 : Math.Pow(((value / 255.0) + 0.055) / 1.055, 2.4);

    private static (int R, int G, int B) Rgb(int index)
    {
        var hex = int.Parse(DivergingColors.Hex(index).AsSpan(1), NumberStyles.HexNumber, CultureInfo.InvariantCulture);
        return (hex >> 16, (hex >> 8) & 255, hex & 255);
    }
}
