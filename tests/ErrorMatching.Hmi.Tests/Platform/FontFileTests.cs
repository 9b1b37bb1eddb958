using Avalonia.Media;
using ErrorMatching.Hmi.Platform;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Fonts as the system has them; HarfBuzz is the judge of which characters they have.</summary>
public sealed class FontFileTests : IDisposable
{
    private const string Mono = "/usr/share/fonts/truetype/dejavu/DejaVuSansMono-Bold.ttf";
    private const string Chinese = "/usr/share/fonts/opentype/noto/NotoSansCJK-Bold.ttc";
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Names_and_styles_of_a_face_are_read()
    {
        using var file = new FontFile(Needed(Mono));
        var face = Assert.Single(file.Faces());
        Assert.Equal(("DejaVu Sans Mono", 700, FontStyle.Normal, true), (face.Family, face.Weight, face.Style, face.IsMono));
    }

    [Fact]
    public void Faces_of_a_collection_differ_by_region()
    {
        using var file = new FontFile(Needed(Chinese));
        var far = file.Faces().ToDictionary(f => f.Family, f => f.FarFromTaiwan);
        Assert.Equal(
            (0, 2, 3, 3, 3),
            (
                far["Noto Sans CJK TC"],
                far["Noto Sans CJK HK"],
                far["Noto Sans CJK SC"],
                far["Noto Sans CJK JP"],
                far["Noto Sans CJK KR"]));
    }

    [Theory]
    [InlineData(Mono)]
    [InlineData(Chinese)]
    public void A_face_has_the_characters_that_HarfBuzz_finds_in_it(string path)
    {
        using var file = new FontFile(Needed(path));
        var face = file.Faces()[0];
        var map = new CharacterMap(file.CharactersOf(face));
        using var blob = HarfBuzzSharp.Blob.FromFile(path);
        using var opened = new HarfBuzzSharp.Face(blob, 0);
        using var font = new HarfBuzzSharp.Font(opened);
        font.SetFunctionsOpenType();
        Assert.All(
            Enumerable.Range(0, 0x3_0000 / 7).Select(i => 7 * i),
            c => Assert.Equal(font.TryGetNominalGlyph(c, out var glyph) && glyph != 0, map.Has(c)));
    }

    [Fact]
    public void A_torn_font_is_refused_and_nothing_else_happens()
    {
        var (bytes, random) = (File.ReadAllBytes(Needed(Mono)), new Random(5));
        var path = Path.Combine(_folder.Path, "torn.ttf");
        for (var i = 0; i < 300; i++)
        {
            var torn = bytes[..(i % 3 == 0 ? random.Next(bytes.Length) : bytes.Length)];
            for (var n = 0; n < 8 && torn.Length > 0; n++)
            {
                torn[random.Next(Math.Min(torn.Length, 600))] = (byte)random.Next(256);
            }

            File.WriteAllBytes(path, torn);
            using var file = new FontFile(path);
            try
            {
                foreach (var face in file.Faces())
                {
                    _ = new CharacterMap(file.CharactersOf(face)).Has('x');
                }
            }
            catch (Exception e) when (e is InvalidDataException or IOException)
            {
                // The refusal.
            }
        }

        // One that is left out leaves the others there.
        File.Copy(Mono, Path.Combine(_folder.Path, "whole.ttf"));
        File.WriteAllText(path, "no font");
        Assert.Equal(
            ["DejaVu Sans Mono", "Station Sans TC"],
            new StationFonts(FontFolders.Own, [_folder.Path]).GetInstalledFontFamilyNames());
    }

    private static string Needed(string path)
    {
        Assert.SkipUnless(File.Exists(path), $"{path} is not installed.");
        return path;
    }
}
