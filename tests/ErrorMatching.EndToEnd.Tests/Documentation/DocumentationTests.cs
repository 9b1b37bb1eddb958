using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Every command of the documentation runs as it is written and prints what the page shows.</summary>
[Trait("Runs", "Console")]
public sealed partial class DocumentationTests
{
    private const string Quickstart = "dotnet run -c Release --project src/ErrorMatching.Console -- ";

    public static TheoryData<string> Pages =>
        [.. new[] { "README.md" }.Concat(InRepository("docs").Concat(InRepository("samples")).Order(StringComparer.Ordinal))];

    public static TheoryData<string> Verbs =>
    [
        "match", "verify", "job check", "job blocks", "job new", "job schema", "nc check", "nc motion", "nc locate", "nc displace",
        "nc diff", "nc prove", "nc dialects", "fit line", "fit polynomial", "fit circle",
        "surface plan", "surface probe", "surface compensate", "surface toolpath", "surface displace", "surface evaluate", "surface fit",
    ];

    [Theory]
    [MemberData(nameof(Pages))]
    public async Task The_commands_of_a_page_run_and_print_what_it_shows(string page)
    {
        using var shop = new Workshop();
        foreach (var command in DocumentedCommand.Of(
            await File.ReadAllTextAsync(Repository.PathTo(page), TestContext.Current.CancellationToken)))
        {
            var words = command.Line.Replace(
                Quickstart, "errormatch ", StringComparison.Ordinal).Split(' ', StringSplitOptions.RemoveEmptyEntries);
            switch (words[0])
            {
                case "errormatch":
                    var run = command.Typed.Count == 0
                        ? await shop.Run(words[1..])
                        : await ConsoleRun.Typed(shop.Folder, [.. words[1..], "--password-stdin"], command.Typed);
                    Assert.True(command.Exit == run.Exit, $"{page}: {command.Line} ended with {run.Exit}: {run.Output}{run.Error}");
                    var printed = (run.Output + run.Error).Split('\n')
                        .Select(l => Spaces().Replace(Calculating().Replace(l, "took 0.1 s"), " ").Trim())
                        .ToHashSet(StringComparer.Ordinal);
                    Assert.All(
                        command.Printed,
                        l => Assert.True(
                            printed.Contains(Spaces().Replace(Calculating().Replace(l, "took 0.1 s"), " ")),
                            $"{page}: {command.Line} does not print: {l}"));
                    break;
                case "cp":
                    Directory.CreateDirectory(shop[words[^1]]);
                    Assert.All(words[1..^1], f => File.Copy(shop[f], shop[words[^1], Path.GetFileName(f)]));
                    break;
                case "dotnet":
                    break;
                default:
                    Assert.Fail($"{page}: no reader can be sure to have {words[0]}.");
                    break;
            }
        }
    }

    [Fact]
    public void The_pages_for_users_have_commands() => Assert.All(
        new[]
        {
            "README.md",
            "docs/first-match.md",
            "docs/match-an-outline.md",
            "docs/write-a-job.md",
            "docs/read-the-report.md",
            "docs/feedback-from-a-counterpart.md",
            "docs/displace-blocks-by-hand.md",
            "docs/dialects.md",
            "docs/prove-a-program.md",
            "docs/refusals.md",
            "docs/compensate-a-surface.md",
            "docs/probe-a-surface.md",
            "docs/cut-a-surface.md",
            "docs/fit-a-surface.md",
            "docs/measure-with-a-gauge.md",
            "docs/configure-a-cell.md"
        },
        p => Assert.NotEmpty(DocumentedCommand.Of(File.ReadAllText(Repository.PathTo(p)))));

    [Theory]
    [MemberData(nameof(Verbs))]
    public async Task The_help_of_a_verb_shows_an_example_that_runs(string verb)
    {
        using var shop = new Workshop();
        var help = await shop.Run(verb + " --help");
        Assert.Equal((0, ""), (help.Exit, help.Error));
        var example = help.Output[(help.Output.LastIndexOf("Example:\n", StringComparison.Ordinal) + "Example:\n".Length)..].Trim();
        Assert.StartsWith($"errormatch {verb}", example, StringComparison.Ordinal);
        var run = await shop.Run(example["errormatch ".Length..]);
        Assert.Equal((0, ""), (run.Exit, run.Error));
    }

    [Fact]
    public void Links_between_pages_lead_somewhere()
    {
        foreach (var page in InRepository("docs").Concat(["README.md", "ARCHITECTURE.md"]))
        {
            foreach (Match link in Link().Matches(File.ReadAllText(Repository.PathTo(page))))
            {
                var target = Path.Combine(Path.GetDirectoryName(Repository.PathTo(page))!, link.Groups["target"].Value);
                Assert.True(Path.Exists(target), $"{page} leads to {link.Groups["target"].Value}, which is not there.");
            }
        }
    }

    private static IEnumerable<string> InRepository(string folder) =>
        Directory.EnumerateFiles(Repository.PathTo(folder), "*.md", SearchOption.AllDirectories).Select(
            f => Path.GetRelativePath(Repository.Root, f).Replace('\\', '/'));

    [GeneratedRegex(" +", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Spaces();

    [GeneratedRegex("took [0-9.]+ s", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Calculating();

    [GeneratedRegex(@"\]\((?!http)(?<target>[^)#]+)[^)]*\)", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Link();
}
