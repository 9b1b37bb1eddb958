using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using System.Runtime.InteropServices;
using Avalonia.Media;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

/// <summary>System fonts through fontconfig; embedded fonts from a stream.</summary>
internal sealed unsafe class FontconfigFontManager : IFontManagerImpl
{
    private readonly nint _config = FontConfig.FcInitLoadConfigAndFonts();
    private readonly Dictionary<string, byte[]> _files = [];
    private readonly Lock _lock = new();
    private string[]? _families;

    /// <summary>Preferred regional Han forms for fallback.</summary>
    public string HanLanguage { get; init; } = "zh-tw";

    /// <summary>The family for Han characters, by name. For a family that Avalonia knows, it requests each weight separately; for a family
    /// that it got for a single character, it uses the first weight that it encountered for all others.</summary>
    public IReadOnlyList<FontFallback> HanFallbacks =>
        HanFamily() is { } family
            ? [
                new()
                {
                    FontFamily = new(family),
                    UnicodeRange = new([new(0x2E80, 0x9FFF), new(0xF900, 0xFAFF), new(0xFE30, 0xFE4F), new(0xFF00, 0xFFEF)])
                }]
            : [];

    public string GetDefaultFontFamilyName() => "DejaVu Sans";

    public string[] GetInstalledFontFamilyNames(bool checkForUpdates = false)
    {
        if (_families is not null) return _families;
        var names = new SortedSet<string>(StringComparer.OrdinalIgnoreCase);
        var set = FontConfig.FcConfigGetFonts(_config, 0);
        for (var i = 0; i < set->Count; i++)
            for (var n = 0; FontConfig.FcPatternGetString(set->Fonts[i], "family", n, out var name) == 0; n++)
                names.Add(Marshal.PtrToStringUTF8(name)!);
        return _families = [.. names];
    }

    public bool TryMatchCharacter(int codepoint, FontStyle fontStyle, FontWeight fontWeight, FontStretch fontStretch, string? familyName,
        CultureInfo? culture, [NotNullWhen(true)] out IPlatformTypeface? platformTypeface)
        => TryMatch(familyName, codepoint, fontStyle, fontWeight, out platformTypeface);

    public bool TryCreateGlyphTypeface(string familyName, FontStyle style, FontWeight weight, FontStretch stretch,
        [NotNullWhen(true)] out IPlatformTypeface? platformTypeface)
    {
        platformTypeface = null;
        // fontconfig always returns some font; a family that is not installed must fail, so that the next name is tried.
        return Array.BinarySearch(GetInstalledFontFamilyNames(), familyName, StringComparer.OrdinalIgnoreCase) >= 0
               && TryMatch(familyName, null, style, weight, out platformTypeface);
    }

    public bool TryCreateGlyphTypeface(
        Stream stream, FontSimulations fontSimulations, [NotNullWhen(true)] out IPlatformTypeface? platformTypeface)
    {
        platformTypeface = new NativeTypeface(NativeTypeface.Pin(stream), 0, fontSimulations);
        return true;
    }

    public bool TryGetFamilyTypefaces(string familyName, [NotNullWhen(true)] out IReadOnlyList<Typeface>? familyTypefaces)
    {
        familyTypefaces = null;
        return false;
    }

    // Only the name: this reads no file.
    private string? HanFamily()
    {
        const uint sample = '誤';
        var pattern = FontConfig.FcPatternCreate();
        nint match = 0;
        try
        {
            FontConfig.FcPatternAddString(pattern, "family", "sans-serif");
            FontConfig.FcPatternAddString(pattern, "lang", HanLanguage);
            _ = FontConfig.FcConfigSubstitute(_config, pattern, 0);
            FontConfig.FcDefaultSubstitute(pattern);
            match = FontConfig.FcFontMatch(_config, pattern, out _);
            return match != 0
                && FontConfig.FcPatternGetCharSet(match, "charset", 0, out var covered) == 0
                && FontConfig.FcCharSetHasChar(covered, sample) != 0
                && FontConfig.FcPatternGetString(match, "family", 0, out var name) == 0 ? Marshal.PtrToStringUTF8(name) : null;
        }
        finally
        {
            if (match != 0) FontConfig.FcPatternDestroy(match);
            FontConfig.FcPatternDestroy(pattern);
        }
    }

    private bool TryMatch(
        string? family, int? codepoint, FontStyle style, FontWeight weight, [NotNullWhen(true)] out IPlatformTypeface? typeface)
    {
        typeface = null;
        lock (_lock)
        {
            var pattern = FontConfig.FcPatternCreate();
            nint match = 0, chars = 0;
            try
            {
                if (!string.IsNullOrEmpty(family)) FontConfig.FcPatternAddString(pattern, "family", family);
                if (codepoint is not null)
                {
                    FontConfig.FcPatternAddString(pattern, "family", "sans-serif");
                    if (codepoint is >= 0x2E80 and <= 0x9FFF or >= 0xF900 and <= 0xFFEF or >= 0x20000 and <= 0x3FFFF)
                        FontConfig.FcPatternAddString(pattern, "lang", HanLanguage);
                    chars = FontConfig.FcCharSetCreate();
                    _ = FontConfig.FcCharSetAddChar(chars, (uint)codepoint.Value);
                    FontConfig.FcPatternAddCharSet(pattern, "charset", chars);
                }
                FontConfig.FcPatternAddInteger(pattern, "weight", FontConfig.FcWeightFromOpenType((int)weight));
                FontConfig.FcPatternAddInteger(
                    pattern, "slant", style switch { FontStyle.Italic => 100, FontStyle.Oblique => 110, _ => 0 });
                _ = FontConfig.FcConfigSubstitute(_config, pattern, 0);
                FontConfig.FcDefaultSubstitute(pattern);
                match = FontConfig.FcFontMatch(_config, pattern, out _);
                if (match == 0 || FontConfig.FcPatternGetString(match, "file", 0, out var fileName) != 0) return false;
                if (codepoint is not null && (FontConfig.FcPatternGetCharSet(match, "charset", 0, out var covered) != 0
                    || FontConfig.FcCharSetHasChar(covered, (uint)codepoint.Value) == 0)) return false;
                var file = Marshal.PtrToStringUTF8(fileName)!;
                _ = FontConfig.FcPatternGetInteger(match, "index", 0, out var index);
                _ = FontConfig.FcPatternGetInteger(match, "weight", 0, out var found);
                _ = FontConfig.FcPatternGetInteger(match, "slant", 0, out var slant);
                _ = FontConfig.FcPatternGetString(match, "family", 0, out var name);
                if (!_files.TryGetValue(file, out var data))
                {
                    using var stream = File.OpenRead(file);
                    _files[file] = data = NativeTypeface.Pin(stream);
                }
                var actual = (FontWeight)FontConfig.FcWeightToOpenType(found);
                var simulate = FontSimulations.None;
                if ((int)weight >= 600 && (int)actual < 600) simulate |= FontSimulations.Bold;
                if (style != FontStyle.Normal && slant == 0) simulate |= FontSimulations.Oblique;
                // The requested weight and style, with simulations: if they differed, Avalonia would open the file's first face and
                // simulate the rest itself.
                typeface = new NativeTypeface(data, index & 0xFFFF, simulate, Marshal.PtrToStringUTF8(name), weight, style);
                return true;
            }
            finally
            {
                if (match != 0) FontConfig.FcPatternDestroy(match);
                if (chars != 0) FontConfig.FcCharSetDestroy(chars);
                FontConfig.FcPatternDestroy(pattern);
            }
        }
    }
}
