using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The operator's manual says what the screen says. <c>UPDATE_MANUAL=1</c> renews the pictures that are there.</summary>
public sealed partial class ManualTests
{
    private static readonly (Language Language, string Folder, string Code)[] Manuals = [
        (Language.English, "en", "en"), (Language.TraditionalChinese, "zh-Hant", "zh")];

    [Fact]
    public void Both_languages_have_the_same_pages() =>
        Assert.Equal(Pages("en").Select(Path.GetFileName), Pages("zh-Hant").Select(Path.GetFileName));

    [Fact]
    public void Every_page_is_found_from_the_first_one() => Assert.All(Manuals, m =>
    {
        var first = File.ReadAllText(Path.Combine(Folder(m.Folder), "README.md"));
        Assert.All(
            Pages(m.Folder).Select(p => Path.GetFileName(p)!).Where(p => p != "README.md"),
            p => Assert.Contains($"({p})", first, StringComparison.Ordinal));
    });

    [Fact]
    public void What_a_page_leads_to_is_there() => Assert.All(Manuals.SelectMany(m => Pages(m.Folder)), p => Assert.All(
        Link().Matches(File.ReadAllText(p)).Select(l => l.Groups["to"].Value),
        to => Assert.True(File.Exists(Path.Combine(Path.GetDirectoryName(p)!, to)), $"{p} leads to {to}.")));

    [Fact]
    public void Pictures_are_in_the_language_of_their_page() => Assert.All(Manuals, m => Assert.All(
        Pages(m.Folder).SelectMany(
            p => Link().Matches(File.ReadAllText(p)).Select(l => l.Groups["to"].Value))
            .Where(to => to.EndsWith(".png", StringComparison.Ordinal)),
        to => Assert.EndsWith($"-{m.Code}.png", to, StringComparison.Ordinal)));

    [Fact]
    public void Words_in_bold_stand_on_the_screen_as_they_stand_in_the_manual() => Assert.All(Manuals, m =>
    {
        var texts = Texts.Of(m.Language).Values.ToHashSet(StringComparer.Ordinal);
        Assert.All(
            Pages(m.Folder).SelectMany(p => Bold().Matches(File.ReadAllText(p)).Select(b => (Page: p, Words: b.Groups["words"].Value)))
                .Where(
                    b => !b.Words.EndsWith('.')
                        && !b.Words.EndsWith('。')
                        && !Path.GetFileName(b.Page).StartsWith("README", StringComparison.Ordinal)),
            b => Assert.True(
                texts.Contains(b.Words), $"{Path.GetFileName(b.Page)} ({m.Code}) names \"{b.Words}\", which no screen shows."));
    });

    [Fact]
    public void Words_in_quotation_marks_stand_on_a_screen_too()
    {
        var texts = Manuals.SelectMany(m => Texts.Of(m.Language).Values).ToHashSet(StringComparer.Ordinal);
        var quoted = Manuals.SelectMany(m => Pages(m.Folder))
            .SelectMany(p => Quoted().Matches(File.ReadAllText(p)).Select(q => (Page: p, Words: q.Groups["words"].Value)))
            .ToArray();
        Assert.NotEmpty(quoted);
        Assert.All(quoted, q => Assert.True(texts.Contains(q.Words), $"{q.Page} quotes \"{q.Words}\", which no screen shows."));
    }

    private static string Folder(string language) => Repository.PathTo("docs", "station", language);

    private static IEnumerable<string> Pages(string language) =>
        Directory.EnumerateFiles(Folder(language), "*.md").Order(StringComparer.Ordinal);

    [GeneratedRegex(@"\]\((?<to>[^)#:]+)(#[^)]*)?\)", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Link();

    [GeneratedRegex("[“「](?<words>[^”」\\n]+)[”」]", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Quoted();

    [GeneratedRegex(@"\*\*(?<words>[^*\n]+)\*\*", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Bold();
}
