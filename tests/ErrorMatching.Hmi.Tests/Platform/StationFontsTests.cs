using System.Globalization;
using Avalonia.Media;
using ErrorMatching.Hmi.Platform;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The fonts that the station brings along, on a computer that has no others.</summary>
public sealed class StationFontsTests : IDisposable
{
    private const string Chinese = "Station Sans TC";
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public Task Every_character_of_the_texts_is_in_the_fonts() => Drawing.Needed().RunAsync(() =>
    {
        var fonts = new StationFonts(FontFolders.Own, [_folder.Path]);
        var texts = new[] { "en", "zh-Hant" }
            .SelectMany(l => File.ReadAllText(Path.Combine(Repository.Root, "src/ErrorMatching.Hmi/Texts", l + ".json")))
            .Where(c => c > ' ')
            .Distinct();
        foreach (var weight in new[] { FontWeight.Normal, FontWeight.Bold })
        {
            var latin = new GlyphTypeface(
                FontManager.Current.TryGetGlyphTypeface(new Typeface(FontFamily.Default, FontStyle.Normal, weight), out var inter)
                    ? inter.PlatformTypeface
                    : throw new InvalidOperationException("There is no Inter."));
            Assert.True(fonts.TryCreateGlyphTypeface(Chinese, FontStyle.Normal, weight, FontStretch.Normal, out var found));
            var chinese = new GlyphTypeface(found);
            Assert.Equal((int)weight, (int)found.Weight);
            Assert.Equal(FontSimulations.None, found.FontSimulations);
            foreach (var c in texts)
            {
                Assert.True(
                    chinese.CharacterToGlyphMap.ContainsGlyph(c) || latin.CharacterToGlyphMap.ContainsGlyph(c),
                    $"No font of the station has {c} (U+{(int)c:X4}), weight {weight}. Make them again: tools/fonts.py");
            }
        }
    });

    [Fact]
    public void Common_characters_and_symbols_need_no_installed_font()
    {
        // All of Big5's level 1, which is in rows A4 to C6; the last is at C67E.
        System.Text.Encoding.RegisterProvider(System.Text.CodePagesEncodingProvider.Instance);
        var big5 = System.Text.Encoding.GetEncoding(
            950, System.Text.EncoderFallback.ExceptionFallback, System.Text.DecoderFallback.ExceptionFallback);
        var common = Enumerable.Range(0xA440, 0xC67E - 0xA440 + 1)
            .Where(i => (i & 0xFF) is (>= 0x40 and <= 0x7E) or (>= 0xA1 and <= 0xFE))
            .Select(i => big5.GetString([(byte)(i >> 8), (byte)i])[0])
            .ToArray();
        Assert.Equal(5401, common.Length);
        var fonts = new StationFonts(FontFolders.Own, [_folder.Path]);
        var missing = string.Concat(common.Concat("Øµ±°²³×−–—…→←↑↓≤≥⌀◆○●✓✗σ").Where(c => !fonts.TryMatchCharacter(
            c, FontStyle.Normal, FontWeight.Normal, FontStretch.Normal, null, CultureInfo.InvariantCulture, out _)));
        Assert.True(missing.Length == 0, $"No font of the station has {missing}. Make them again: tools/fonts.py");
    }

    [Fact]
    public void Own_fonts_come_first_and_installed_ones_have_the_rest()
    {
        const int rare = '龘';
        const string all = "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc";
        Assert.SkipUnless(File.Exists(all), $"{all} is not installed.");
        File.Copy(all, Path.Combine(_folder.Path, "all.ttc"));
        var fonts = new StationFonts(FontFolders.Own, [_folder.Path]);
        string? FamilyOf(int c) => fonts.TryMatchCharacter(
            c, FontStyle.Normal, FontWeight.Normal, FontStretch.Normal, null, CultureInfo.InvariantCulture, out var found)
            ? found.FamilyName : null;
        Assert.Equal((Chinese, "Noto Sans CJK TC"), (FamilyOf('誤'), FamilyOf(rare)));
        Assert.Equal([Chinese, "Noto Sans CJK TC"], fonts.HanFallbacks.Select(f => f.FontFamily.Name));
        Assert.Equal([Chinese], new StationFonts(FontFolders.Own, []).HanFallbacks.Select(f => f.FontFamily.Name));
    }

    [Fact]
    public void A_station_without_its_fonts_says_so() => Assert.Equal(
        $"Fonts that belong to the station are missing in {_folder.Path}: one with Chinese, or one for programs. "
            + "Install the station again.",
        Assert.Throws<FileNotFoundException>(() => new StationFonts(_folder.Path, FontFolders.Usual)).Message);

    [Fact]
    public void The_license_of_each_font_is_beside_it() => Assert.Equal(
        ["DejaVuSansMono", "StationSansTC"],
        Directory.GetFiles(Path.Combine(AppContext.BaseDirectory, "licenses/fonts")).Select(Path.GetFileNameWithoutExtension).Order());
}
