using System.Globalization;
using System.Text;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform.Tests;

public sealed class ColorScaleTests
{
    // 25 um need bands of 2 um, the round number above 1.25: the last one is about 24 or 26.
    [Theory]
    [InlineData(0, 25, 2, 0, 13, 20, 40)]
    [InlineData(9, 25, 2, 0, 13, 20, 40)]
    [InlineData(-25, -3, 2, -13, 0, 0, 20)]
    [InlineData(-5, 20, 1, -5, 20, 15, 40)]
    [InlineData(-20, 5, 1, -20, 5, 0, 25)]
    [InlineData(0, 0, 0.0025, 0, 0, 20, 20)]
    public void Errors_use_the_colors_from_zero_to_the_strongest(
        double low, double high, double step, int first, int last, int lowest, int highest)
    {
        var scale = ColorScale.OfErrors([low, high]);
        Assert.Equal((first, last), (scale.First, scale.Last));
        Assert.Equal((lowest, highest), (scale.ColorOf(first), scale.ColorOf(last)));
        Assert.Equal(20, scale.ColorOf(0));
        if (high != low)
        {
            Assert.Equal(step, scale.Middle(1), 12);
            Assert.Equal(step / 2, scale.LowerEnd(1), 12);
        }
    }

    [Fact]
    public void Sizes_use_the_colors_of_one_side_from_the_lowest_to_the_highest()
    {
        var scale = ColorScale.OfSizes([0.46, 0.94]);
        Assert.Equal((0.45, 0.95), (scale.Middle(scale.First), scale.Middle(scale.Last)), Close);
        Assert.Equal((20, 40), (scale.ColorOf(scale.First), scale.ColorOf(scale.Last)));
        Assert.Equal("0.95", scale.Label(scale.Last));
        Assert.Equal("+4", ColorScale.OfErrors([-10, 25]).Label(2));
        Assert.Equal("-4", ColorScale.OfErrors([-10, 25]).Label(-2));
        var flat = ColorScale.OfSizes([3, 3]);
        Assert.Equal((flat.First, 20), (flat.Last, flat.ColorOf(flat.First)));
    }

    [Fact]
    public void Every_color_has_one_for_a_dark_page_in_the_style_sheet()
    {
        var page = Encoding.UTF8.GetString(ReportPage.Write("t", null, [new("s", "S", _ => { })]));
        var dark = page[page.LastIndexOf("@media screen and (prefers-color-scheme: dark)", StringComparison.Ordinal)..];
        for (var color = 0; color <= 2 * ColorScale.MostBands; color++)
        {
            var share = ((double)color / ColorScale.MostBands) - 1;
            Assert.Contains(
                string.Create(CultureInfo.InvariantCulture, $".h{color} {{ fill: {DivergingColors.DarkHexAt(share)}; }}"),
                dark,
                StringComparison.Ordinal);
        }

        // No white block: zero is dark there.
        Assert.True(Convert.ToInt32(DivergingColors.DarkHexAt(0)[1..3], 16) < 64);
        Assert.Equal(DivergingColors.Hex(0), ColorScale.Hex(0));
        Assert.Equal(DivergingColors.Hex(DivergingColors.Count - 1), ColorScale.Hex(2 * ColorScale.MostBands));
    }

    private static bool Close((double, double) a, (double, double) b) =>
        Math.Abs(a.Item1 - b.Item1) < 1e-9 && Math.Abs(a.Item2 - b.Item2) < 1e-9;
}
