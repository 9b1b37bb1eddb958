using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The contents of the web site that <c>deploy/site</c> makes of the pages.</summary>
public sealed partial class SiteTests
{
    [Theory]
    [InlineData("docs", "docs/station/")]
    [InlineData("docs/station/en")]
    [InlineData("docs/station/zh-Hant")]
    [InlineData("samples")]
    public void Each_page_is_in_its_contents_once(string folder, params string[] elsewhere)
    {
        string[] pages = [
            .. Directory.EnumerateFiles(Repository.PathTo(folder), "*.md", SearchOption.AllDirectories)
                .Select(f => Path.GetRelativePath(Repository.Root, f).Replace('\\', '/'))
                .Where(f => !Array.Exists(elsewhere, e => f.StartsWith(e, StringComparison.Ordinal)))];
        string[] listed = [
            .. Listed(folder).Where(p => p.StartsWith(folder + "/", StringComparison.Ordinal))];

        Assert.NotEmpty(pages);
        Assert.Equal(pages.Order(StringComparer.Ordinal), listed.Order(StringComparer.Ordinal));
    }

    [Theory]
    [InlineData("docs")]
    [InlineData("docs/station/en")]
    [InlineData("docs/station/zh-Hant")]
    [InlineData("samples")]
    public void Each_entry_has_the_title_of_its_page(string folder)
    {
        var contents = File.ReadAllText(Repository.PathTo(folder, "toc.yml"));
        foreach (Match entry in TitledEntry().Matches(contents))
        {
            var page = Path.Combine(Repository.PathTo(folder), entry.Groups["page"].Value);
            Assert.Equal("# " + entry.Groups["title"].Value, File.ReadLines(page).First());
        }
    }

    private static IEnumerable<string> Listed(string folder) =>
        Entry().Matches(File.ReadAllText(Repository.PathTo(folder, "toc.yml"))).Select(
            m => Path.GetRelativePath(Repository.Root, Path.GetFullPath(Path.Combine(Repository.PathTo(folder), m.Groups["page"].Value)))
                .Replace('\\', '/'));

    [GeneratedRegex(@"^ *href: (?<page>\S+)$", RegexOptions.Multiline | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Entry();

    // A title in quotes is that of the page; one without is shorter.
    [GeneratedRegex(
        "^ *- name: \"(?<title>[^\"]+)\"\n *href: (?<page>\\S+)$", RegexOptions.Multiline | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex TitledEntry();
}
