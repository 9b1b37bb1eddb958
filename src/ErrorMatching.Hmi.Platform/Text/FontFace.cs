using Avalonia.Media;

namespace ErrorMatching.Hmi.Platform;

/// <summary>A face of a font file.</summary>
/// <param name="File">Path of the file.</param>
/// <param name="Index">Number in the file.</param>
/// <param name="Offset">Where its table directory begins in the file.</param>
/// <param name="Families">Names of its family, in all languages.</param>
/// <param name="Weight">Weight, 100 to 900.</param>
/// <param name="Width">Width, 1 to 9; 5 is normal.</param>
/// <param name="Style">Upright or slanted.</param>
/// <param name="IsSans">True for a face without serifs.</param>
/// <param name="IsTraditional">True if the face states that it covers Traditional Chinese (Big5).</param>
/// <param name="IsOwn">True if the station brings it along.</param>
internal sealed record FontFace(
    string File,
    int Index,
    long Offset,
    IReadOnlySet<string> Families,
    int Weight,
    int Width,
    FontStyle Style,
    bool IsSans,
    bool IsTraditional,
    bool IsOwn = false)
{
    private CharacterMap? _characters;

    /// <summary>The family's first name.</summary>
    public string Family => Families.First();

    /// <summary>True for a face whose characters are all equally wide, by its name.</summary>
    public bool IsMono => Family.Contains("Mono", StringComparison.OrdinalIgnoreCase);

    /// <summary>How far the face is from the regional forms of Taiwan; 0 is best. Fonts for Hong Kong state Big5 as well.</summary>
    public int FarFromTaiwan => !IsTraditional ? 3 : Words("TC") || Words("TW") ? 0 : Words("HK") ? 2 : 1;

    /// <summary>True if the face has a glyph for a character.</summary>
    /// <exception cref="InvalidDataException">The file has changed, and is no font any more.</exception>
    public bool Has(int character)
    {
        if (_characters is null)
        {
            using var file = new FontFile(File);
            _characters = new CharacterMap(file.CharactersOf(this));
        }

        return _characters.Has(character);
    }

    private bool Words(string word) => Families.Any(f => f.Split(' ').Contains(word, StringComparer.Ordinal));
}
