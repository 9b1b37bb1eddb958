using ErrorMatching.Mating;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>The package's README: its example is the code between the markers below.</summary>
public sealed class ReadmeTests
{
    [Fact]
    public void The_example_of_the_readme_runs_and_means_what_it_says()
    {
        using var temporary = new TemporaryFolder();
        var (job, folder) = (Repository.PathTo("samples", "complex-mating", "job.json"), temporary.Path);
        var bytes = File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "part.csv"));

        // The example is a program's, which needs no token.
#pragma warning disable xUnit1051
        // example
        var files = new JobFiles(job); // the path of a mating job
        var outcome = MatingRun.Run(files, new() { Part = new("part-4711.csv", bytes) });
        foreach (var refusal in outcome.Refusals)
        {
            Console.WriteLine($"{refusal.Code}: {refusal.Message}"); // why there is no program
        }

        if (outcome.Result is { } matched)
        {
            // Both reports, and the program if the verdict says to cut it: all of them appear, or none. No file that was read is replaced.
            OutputFile.WriteAll(matched.FilesIn(folder), files.Opened);
            Console.WriteLine(VerdictWords.Of(matched.Report.Verdict)); // "16 of 16 points will be within ..."
        }

        // example
#pragma warning restore xUnit1051
        Assert.Equal(
            ["counterpart.nc", "report.html", "report.json"],
            Directory.GetFiles(folder).Select(Path.GetFileName).Order(StringComparer.Ordinal));
        Assert.Contains("part-4711.csv", File.ReadAllText(temporary["report.json"]), StringComparison.Ordinal);
    }

    [Fact]
    public void The_example_of_the_readme_is_the_one_that_runs()
    {
        var source = File.ReadAllLines(Repository.PathTo("tests", "ErrorMatching.Jobs.Tests", "ReadmeTests.cs"));
        var inside = source.SkipWhile(l => l.Trim() != "// example").Skip(1).TakeWhile(l => l.Trim() != "// example").ToArray();

        Assert.Contains(
            "```csharp\n" + string.Join('\n', inside.Select(l => l.Length > 8 ? l[8..] : l)).TrimEnd() + "\n```",
            File.ReadAllText(Repository.PathTo("src", "ErrorMatching.Jobs", "README.md")),
            StringComparison.Ordinal);
    }
}
