using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using Avalonia.Media;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The fonts that the station brings along, those installed on the computer, and fonts from streams. For what the station's own
/// have, they come first: so it looks the same on every computer, also on one that has no fonts. Others show what they lack, such as
/// rare characters in names.</summary>
internal sealed class StationFonts : IFontManagerImpl
{
    private const int Sample = '誤';
    private const string Usual = "DejaVu Sans";
    private readonly FontFace[] _faces;
    private readonly string[] _families;
    private readonly Dictionary<string, FontMemory> _files = [];
    private readonly Lock _lock = new();

    /// <summary>Looks for fonts.</summary>
    /// <param name="own">Where the station's own are; see <see cref="FontFolders.Own"/>.</param>
    /// <param name="folders">Where installed ones are; see <see cref="FontFolders.Usual"/>.</param>
    /// <exception cref="FileNotFoundException">The station's own fonts are not where they belong.</exception>
    public StationFonts(string own, IReadOnlyList<string> folders)
    {
        FontFace[] faces = [.. FontFolders.Files([own]).SelectMany(FacesOf).Select(f => f with { IsOwn = true })];
        if (!faces.Any(f => f.Has(Sample)) || !faces.Any(f => f.IsMono))
        {
            throw new FileNotFoundException(
                $"Fonts that belong to the station are missing in {own}: one with Chinese, or one for programs. "
                    + "Install the station again.");
        }

        _faces = [.. faces, .. FontFolders.Files(folders).SelectMany(FacesOf)];
        _families = [
            .. _faces
                .SelectMany(f => f.Families)
                .Distinct(StringComparer.OrdinalIgnoreCase)
                .Order(StringComparer.OrdinalIgnoreCase),
        ];
    }

    /// <summary>The families for Han characters, by name: the station's own, then the best of the installed ones, in the forms of Taiwan
    /// where there is such a font. For a family that Avalonia knows, it requests each weight separately; for a family that it got for a
    /// single character, it uses the first weight that it encountered for all others.</summary>
    public IReadOnlyList<FontFallback> HanFallbacks => [
        .. _faces
            .GroupBy(f => f.IsOwn)
            .Select(g => Best(g, Sample, FontStyle.Normal, FontWeight.Normal, FontStretch.Normal))
            .OfType<FontFace>()
            .Select(f => new FontFallback
            {
                FontFamily = new(f.Family),
                UnicodeRange = new([new(0x2E80, 0x9FFF), new(0xF900, 0xFAFF), new(0xFE30, 0xFE4F), new(0xFF00, 0xFFEF)])
            })];

    public string GetDefaultFontFamilyName() => Usual;

    public string[] GetInstalledFontFamilyNames(bool checkForUpdates = false) => [.. _families];

    public bool TryMatchCharacter(int codepoint, FontStyle fontStyle, FontWeight fontWeight, FontStretch fontStretch, string? familyName,
        CultureInfo? culture, [NotNullWhen(true)] out IPlatformTypeface? platformTypeface)
    {
        var face = (familyName is null ? null : Best(Named(familyName), codepoint, fontStyle, fontWeight, fontStretch))
            ?? Best(_faces, codepoint, fontStyle, fontWeight, fontStretch);
        platformTypeface = face is null ? null : Open(face, fontStyle, fontWeight);
        return platformTypeface is not null;
    }

    public bool TryCreateGlyphTypeface(string familyName, FontStyle style, FontWeight weight, FontStretch stretch,
        [NotNullWhen(true)] out IPlatformTypeface? platformTypeface)
    {
        // The closest face of the family, and of no other: Avalonia then tries the next name.
        var face = Named(familyName).OrderBy(f => f.IsOwn ? 0 : 1).ThenBy(f => Distance(f, style, weight, stretch)).FirstOrDefault();
        platformTypeface = face is null ? null : Open(face, style, weight);
        return platformTypeface is not null;
    }

    public bool TryCreateGlyphTypeface(
        Stream stream, FontSimulations fontSimulations, [NotNullWhen(true)] out IPlatformTypeface? platformTypeface)
    {
        platformTypeface = new SkiaTypeface(FontMemory.Of(stream), 0, fontSimulations);
        return true;
    }

    public bool TryGetFamilyTypefaces(string familyName, [NotNullWhen(true)] out IReadOnlyList<Typeface>? familyTypefaces)
    {
        familyTypefaces = null;
        return false;
    }

    // A file that is no font, or cannot be read, is left out.
    private static IReadOnlyList<FontFace> FacesOf(string path)
    {
        try
        {
            using var file = new FontFile(path);
            return file.Faces();
        }
        catch (Exception e) when (e is InvalidDataException or IOException or UnauthorizedAccessException)
        {
            return [];
        }
    }

    private IEnumerable<FontFace> Named(string family) => _faces.Where(f => f.Families.Contains(family));

    private static bool IsHan(int character) =>
        character is (>= 0x2E80 and <= 0x9FFF) or (>= 0xF900 and <= 0xFFEF) or (>= 0x20000 and <= 0x3FFFF);

    // The characters of a face are read only if it comes first by everything else.
    private static FontFace? Best(IEnumerable<FontFace> faces, int character, FontStyle style, FontWeight weight, FontStretch stretch)
    {
        foreach (var face in faces
            .OrderBy(f => f.IsOwn ? 0 : 1)
            .ThenBy(f => (
                IsHan(character) ? f.FarFromTaiwan : f.Families.Contains(Usual) ? 0 : 1, f.IsSans ? 0 : 1, f.IsMono ? 1 : 0))
            .ThenBy(f => f.Family, StringComparer.Ordinal)
            .ThenBy(f => Distance(f, style, weight, stretch)))
        {
            try
            {
                if (face.Has(character))
                {
                    return face;
                }
            }
            catch (Exception e) when (e is InvalidDataException or IOException or UnauthorizedAccessException)
            {
                // Removed or replaced since the start: the next one will do.
            }
        }

        return null;
    }

    // CSS Fonts 4, 5.2: width first, then style, then weight; from 400 to 500 what is in between, then lighter, then bolder.
    private static (int Width, int Style, int Weight) Distance(FontFace face, FontStyle style, FontWeight weight, FontStretch stretch)
    {
        const int otherwise = 1000;
        var (wanted, found) = ((int)weight, face.Weight);
        var apart = Math.Abs(found - wanted);
        var isFirst = wanted > 500 ? found >= wanted : wanted < 400 ? found <= wanted : found >= wanted && found <= 500;
        var isLast = wanted is >= 400 and <= 500 && found > 500;
        return (
            Math.Abs(face.Width - (int)stretch),
            style == face.Style ? 0 : style != FontStyle.Normal && face.Style != FontStyle.Normal ? 1 : 2,
            apart + (isFirst ? 0 : isLast ? 2 * otherwise : otherwise));
    }

    private SkiaTypeface Open(FontFace face, FontStyle style, FontWeight weight)
    {
        var simulate = FontSimulations.None;
        if ((int)weight >= 600 && face.Weight < 600)
        {
            simulate |= FontSimulations.Bold;
        }

        if (style != FontStyle.Normal && face.Style == FontStyle.Normal)
        {
            simulate |= FontSimulations.Oblique;
        }

        lock (_lock)
        {
            if (!_files.TryGetValue(face.File, out var memory))
            {
                using var stream = File.OpenRead(face.File);
                _files[face.File] = memory = FontMemory.Of(stream);
            }

            // The requested weight and style, with simulations: if they differed, Avalonia would open the file's first face and simulate
            // the rest itself.
            return new SkiaTypeface(memory, face.Index, simulate, face.Family, weight, style);
        }
    }
}
