using System.Buffers.Binary;
using Avalonia.Media;
using Avalonia.Media.Fonts;
using Avalonia.Media.TextFormatting;

namespace ErrorMatching.Hmi.Tests;

public sealed class FontTests
{
    [Theory]
    [InlineData("0.05x0.05")]
    [InlineData("N10->N20")]
    [InlineData("G1 X-5 <= 3 != 4 --> (a) :=")]
    public Task Each_sign_of_data_is_shown_as_it_is(string text) => Seat.AtAsync(_ =>
    {
        var typeface = new Typeface(FontFamily.Default);
        Assert.Equal(text.SelectMany(c => Glyphs(c.ToString())), Glyphs(text));

        IEnumerable<ushort> Glyphs(string t) => new TextLayout(t, typeface, 16, Brushes.Black).TextLines[0].TextRuns
            .OfType<ShapedTextRun>()
            .SelectMany(r => Enumerable.Range(0, r.ShapedBuffer.Length).Select(i => r.ShapedBuffer[i].GlyphIndex));
    });

    [Fact]
    public Task Chinese_is_written_in_the_forms_of_Taiwan_and_as_bold_as_the_rest() => Seat.AtAsync(_ =>
    {
        foreach (var (wanted, found) in new[]
        {
            (FontWeight.Normal, 400),
            (FontWeight.SemiBold, 700),
            (FontWeight.Bold, 700),
            (FontWeight.Normal, 400)
        })
        {
            Assert.All(["誤", "，", "（"], c =>
            {
                var run = new TextLayout(
                    "a" + c,
                    new Typeface(FontFamily.Default, FontStyle.Normal, wanted),
                    16,
                    Brushes.Black).TextLines[0].TextRuns.OfType<ShapedTextRun>().Last();
                var face = run.ShapedBuffer.GlyphTypeface;
                Assert.True(face.PlatformTypeface.TryGetTable(OpenTypeTag.Parse("OS/2"), out var table));

                // usWeightClass, behind a version and a width of two bytes each.
                Assert.Equal(
                    ("Station Sans TC", found, FontSimulations.None),
                    (face.FamilyName, BinaryPrimitives.ReadUInt16BigEndian(table.Span[4..]), face.PlatformTypeface.FontSimulations));
            });
        }
    });
}
