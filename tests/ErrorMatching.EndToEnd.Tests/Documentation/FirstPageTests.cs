using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The first page: short, and with the picture that the program draws. <c>UPDATE_MANUAL=1</c> renews the picture.</summary>
public sealed partial class FirstPageTests
{
    [Fact]
    public void The_first_page_is_short() => Assert.InRange(File.ReadAllLines(Repository.PathTo("README.md")).Length, 50, 80);

    // The two drawings of the sample's report side by side, with the report's own style.
    [Fact]
    public async Task Its_picture_is_the_assembly_of_the_sample_s_report()
    {
        using var shop = new Workshop();
        var run = await shop.Run("match samples/complex-mating/job.json --out out");
        Assert.Equal(0, run.Exit);
        var page = (await File.ReadAllTextAsync(shop["out", "report.html"], TestContext.Current.CancellationToken))
            .Replace("\r\n", "\n", StringComparison.Ordinal);
        var drawings = Drawing().Matches(page);
        // Without and with compensation, and the pair at its seat.
        Assert.Equal(3, drawings.Count);
        var picture =
            $"""
            <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 608" width="640" height="608">
            {Style().Match(page).Value}
            {Placed(drawings[0].Value, 0)}
            {Placed(drawings[1].Value, 340)}
            </svg>

            """.Replace("\r\n", "\n", StringComparison.Ordinal);
        var file = Repository.PathTo("docs/pictures/assembly.svg");
        if (Environment.GetEnvironmentVariable("UPDATE_MANUAL") == "1")
        {
            await File.WriteAllTextAsync(file, picture, TestContext.Current.CancellationToken);
        }

        Assert.Equal(picture, await File.ReadAllTextAsync(file, TestContext.Current.CancellationToken));
        Assert.Contains("docs/pictures/assembly.svg", await File.ReadAllTextAsync(
            Repository.PathTo("README.md"), TestContext.Current.CancellationToken), StringComparison.Ordinal);

        static string Placed(string drawing, int x) =>
            drawing.Replace(" class=\"assembly\"", $" x=\"{x}\" y=\"0\" width=\"300\" height=\"608\"", StringComparison.Ordinal);
    }

    [GeneratedRegex("""<svg [^>]*class="assembly">.*?</svg>""", RegexOptions.Singleline | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Drawing();

    [GeneratedRegex("<style>.*?</style>", RegexOptions.Singleline | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Style();
}
