using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

public sealed partial class FreeformCodeTests
{
    [Fact]
    public void Each_code_of_the_free_form_library_is_in_the_documentation()
    {
        var pages = string.Concat(Directory.GetFiles(Repository.PathTo("docs"), "*.md").Select(File.ReadAllText));
        var codes = CodesOfTheLibrary();

        Assert.True(codes.Length > 60, string.Join(' ', codes));
        Assert.All(codes, c => Assert.Contains($"`{c}`", pages, StringComparison.Ordinal));
    }

    // Not that each place is tried, but that no kind of refusal is without a test that names it.
    [Fact]
    public void Each_code_of_the_free_form_library_is_in_a_test()
    {
        var tests = string.Concat(
            new[]
            {
                "ErrorMatching.Freeform.Tests",
                "ErrorMatching.Console.Tests"
            }.SelectMany(p => Directory.GetFiles(
                Repository.PathTo("tests", p), "*.cs", SearchOption.AllDirectories)).Select(File.ReadAllText));
        Assert.All(CodesOfTheLibrary(), c => Assert.Contains($"\"{c}\"", tests, StringComparison.Ordinal));
    }

    private static string[] CodesOfTheLibrary() =>
        [.. Directory.GetFiles(Repository.PathTo("src", "ErrorMatching.Freeform"), "*.cs", SearchOption.AllDirectories)
        .SelectMany(f => Codes().Matches(File.ReadAllText(f)))
        .Select(m => m.Groups["code"].Value)
        .Distinct()];

    [GeneratedRegex(
        "((InputException|At|Refusal|Refused|Refuse|Broken|new)\\(\\s*\"(?<code>[a-z]+(-[a-z]+)+)\"|"
            + "[Ff]ail\\(\"(?<code>[a-z]+(-[a-z]+)*)\")",
        RegexOptions.ExplicitCapture,
        10_000)]
    private static partial Regex Codes();
}
