using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

public sealed partial class FreeformCodeTests
{
    [Fact]
    public void Each_code_of_the_free_form_library_is_in_the_documentation()
    {
        var pages = string.Concat(Directory.GetFiles(Repository.PathTo("docs"), "*.md").Select(File.ReadAllText));
        var codes = Directory.GetFiles(Repository.PathTo("src", "ErrorMatching.Freeform"), "*.cs", SearchOption.AllDirectories)
            .SelectMany(f => Codes().Matches(File.ReadAllText(f)))
            .Select(m => m.Groups["code"].Value)
            .Distinct()
            .ToArray();

        Assert.True(codes.Length > 25, string.Join(' ', codes));
        Assert.All(codes, c => Assert.Contains($"`{c}`", pages, StringComparison.Ordinal));
    }

    [GeneratedRegex("(FreeformException|FreeformRefusal|Refused|Refuse|Broken|new)\\(\\s*\"(?<code>[a-z]+(-[a-z]+)+)\"", RegexOptions.ExplicitCapture, 10_000)]
    private static partial Regex Codes();
}
