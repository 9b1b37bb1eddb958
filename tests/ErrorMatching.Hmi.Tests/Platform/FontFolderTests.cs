using ErrorMatching.Hmi.Platform;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

public sealed class FontFolderTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Font_files_are_found_in_folders_and_links_are_not_followed()
    {
        var (fonts, outside) = (Path.Combine(_folder.Path, "fonts"), Path.Combine(_folder.Path, "outside"));
        Directory.CreateDirectory(Path.Combine(fonts, "deep", "deeper"));
        Directory.CreateDirectory(outside);
        foreach (var file in new[] { "fonts/b.TTF", "fonts/deep/deeper/a.otc", "fonts/readme.txt", "fonts/.hidden.ttf", "outside/c.ttf" })
        {
            File.WriteAllText(Path.Combine(_folder.Path, file), "x");
        }

        File.WriteAllText(Path.Combine(fonts, "empty.ttf"), "");
        using (var huge = File.Create(Path.Combine(fonts, "huge.ttf")))
        {
            huge.SetLength(FontFolders.MostBytes + 1L);
        }

        File.CreateSymbolicLink(Path.Combine(fonts, "link.ttf"), Path.Combine(outside, "c.ttf"));
        Directory.CreateSymbolicLink(Path.Combine(fonts, "linked"), outside);
        Assert.Equal(
            [Path.Combine(fonts, "b.TTF"), Path.Combine(fonts, "deep/deeper/a.otc")],
            FontFolders.Files([fonts, fonts, Path.Combine(_folder.Path, "not there")]));
    }
}
