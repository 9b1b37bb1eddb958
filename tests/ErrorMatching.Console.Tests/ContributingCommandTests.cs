using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>Every command that CONTRIBUTING.md names can be typed: the verbs, options, scripts, variables and files are there.</summary>
public sealed partial class ContributingCommandTests
{
    private static readonly string Page = File.ReadAllText(Repository.PathTo("CONTRIBUTING.md"));
    private static readonly string[] DotnetVerbs = ["build", "test", "run"];

    // Of dotnet's own tools, and of the tool that runs benchmarks.
    private static readonly string[] DotnetOptions = ["-c", "--filter", "--project", "--job"];
    private static readonly string[] Settings = ["RunAnalyzers", "GenerateDocumentationFile", "UseSharedCompilation"];

    private static readonly Dictionary<string, string> Sources =
        new[] { "src", "tests", "benchmarks", "deploy", "tools", ".ci", ".config" }
            .SelectMany(f => Directory.EnumerateFiles(Repository.PathTo(f), "*", SearchOption.AllDirectories))
            .Where(f => Path.GetExtension(f) is ".cs" or ".sh" or ".py" or ".csproj" or ".props" or ".targets" or ".json" or ""
                && Path.GetFileName(f) != nameof(ContributingCommandTests) + ".cs" && Path.GetFileName(f) != "packages.lock.json")
            .ToDictionary(f => f, File.ReadAllText, StringComparer.Ordinal);

    /// <summary>The lines of the page's code blocks, with their comments.</summary>
    public static TheoryData<string> Lines =>
        [.. Fenced().Matches(Page).SelectMany(b => b.Groups["lines"].Value.Split('\n', StringSplitOptions.RemoveEmptyEntries))];

    /// <summary>What is in code marks.</summary>
    public static TheoryData<string> Marks =>
        [.. Marked().Matches(Fenced().Replace(Page, "")).Select(m => m.Groups["code"].Value).Distinct(StringComparer.Ordinal)];

    [Fact]
    public void The_page_has_commands_of_all_kinds()
    {
        string[] commands = [.. Lines.Select(l => l.Data), .. Marks.Select(m => m.Data)];
        foreach (var begin in (string[])["dotnet build", "dotnet test", "dotnet run", "errormatch nc ", "match ", "cell run ",
            "tests/fire ", "tests/score ", "python3 tools/", "deploy/", ".ci/run", "UPDATE_MANUAL=1 dotnet "])
        {
            Assert.Contains(commands, c => c.StartsWith(begin, StringComparison.Ordinal));
        }
    }

    [Theory]
    [MemberData(nameof(Lines))]
    public void A_line_of_a_code_block_can_be_typed(string line)
    {
        var parts = line.Split('#', 2, StringSplitOptions.TrimEntries);
        Assert.True(IsCommand(parts[0]), line);
        if (parts.Length == 1) return;

        // What the comment says of the same script, and other files that it names.
        var script = parts[0].Split(' ')[0];
        foreach (Match named in Option().Matches(parts[1]))
            Knows(script, named.Value);
        foreach (var verb in Further().Match(parts[1]) is { Success: true } also ? also.Groups["verbs"].Value.Split(", ") : [])
            Knows(script, verb);
        foreach (Match file in FileName().Matches(parts[1]))
            Assert.True(Path.Exists(Repository.PathTo(file.Value)), $"{file.Value} is not there.");
    }

    [Theory]
    [MemberData(nameof(Marks))]
    public void What_is_in_code_marks_can_be_typed_or_exists(string code)
    {
        // Types and members of the code: ContributingTests.
        if (!IsCommand(code) && (!char.IsUpper(code[0]) || char.IsUpper(code[^1])) && !Path.Exists(Repository.PathTo(code)))
            Occurs(code);
    }

    // False if it is no command. Throws if it is one that does not work.
    private static bool IsCommand(string line)
    {
        var words = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        while (words.Length > 0 && Variable().Match(words[0]) is { Success: true } variable)
        {
            Occurs(variable.Groups["name"].Value);
            words = words[1..];
            if (words.Length == 0) return true;
        }

        switch (words[0])
        {
            case "errormatch":
                IsVerb(words[1..]);
                return true;
            case "dotnet":
                IsDotnet(words[1..]);
                return true;
            case "python3" when words.Length > 1:
                IsScript(words[1..]);
                return true;
            case var first when CommandTree.FirstWords.Contains(first):
                IsVerb(words);
                return true;
            case var first when File.Exists(Repository.PathTo(first)) && (words.Length > 1 || Path.GetExtension(first).Length == 0):
                IsScript(words);
                return true;
            case var first when first.StartsWith("-p:", StringComparison.Ordinal):
                IsDotnet(["build", .. words]);
                return true;
            default:
                Assert.True(words.Length == 1, $"`{line}` is no command.");
                return false;
        }
    }

    // A verb without its arguments is a name; with arguments, it is typed so.
    private static void IsVerb(string[] words)
    {
        var parsed = CommandTree.Parse(words);
        var path = new List<string>();
        for (var at = parsed.CommandResult; at.Parent is System.CommandLine.Parsing.CommandResult parent; at = parent)
            path.Insert(0, at.Command.Name);
        Assert.Empty(parsed.CommandResult.Command.Subcommands);
        if (!path.SequenceEqual(words))
            Assert.True(parsed.Errors.Count == 0, $"{string.Join(' ', words)}: {string.Join(' ', parsed.Errors.Select(e => e.Message))}");
        FilesAreThere(words);
    }

    private static void IsDotnet(string[] words)
    {
        Assert.Contains(words[0], DotnetVerbs);
        var end = Array.IndexOf(words, "--") is >= 0 and var at ? at : words.Length;
        FilesAreThere(words[..end]);
        Assert.All(words[..end].Where(w => w.StartsWith('-')), w => Assert.True(
            w.StartsWith("-p:", StringComparison.Ordinal) ? Settings.Contains(w[3..w.IndexOf('=')]) : DotnetOptions.Contains(w),
            $"dotnet {words[0]} has no {w}."));
        Assert.Equal(words[0] == "run", words.Contains("--project"));
        if (Array.IndexOf(words, "-c") is >= 0 and var c)
            Assert.Equal("Release", words[c + 1]);
        if (Array.IndexOf(words[..end], "--filter") is >= 0 and var filter)
        {
            Assert.StartsWith("FullyQualifiedName~", words[filter + 1], StringComparison.Ordinal);
            var name = words[filter + 1][(words[filter + 1].IndexOf('~') + 1)..];
            var project = words.Single(w => w.StartsWith("tests/", StringComparison.Ordinal));
            Assert.Contains(Sources, s => s.Key.StartsWith(Repository.PathTo(project), StringComparison.Ordinal)
                && s.Value.Contains(name, StringComparison.Ordinal));
        }

        if (end == words.Length) return;
        if (words[0] == "test")
        {
            Assert.Equal(["xUnit.Explicit=on"], words[(end + 1)..]);
            return;
        }

        var own = words.Single(w => w.StartsWith("benchmarks/", StringComparison.Ordinal));
        Assert.All(words[(end + 1)..].Where(w => w[0] is '-' or (>= 'a' and <= 'z')), w => Assert.True(
            DotnetOptions.Contains(w) || w == "short" || Sources.Any(s => s.Key.StartsWith(Repository.PathTo(own), StringComparison.Ordinal)
                && s.Value.Contains($"\"{w}\"", StringComparison.Ordinal)), $"{own} does not know {w}."));
    }

    // A script knows its options and words. Numbers, and what is written in capitals, are the reader's.
    private static void IsScript(string[] words)
    {
        Assert.True(File.Exists(Repository.PathTo(words[0])), $"{words[0]} is not there.");
        FilesAreThere(words);
        foreach (var word in words[1..].Where(w => !w.Contains('/') && !Free().IsMatch(w)))
        {
            if (word.EndsWith(".cs", StringComparison.Ordinal))
                Assert.Contains(Sources, s => Path.GetFileName(s.Key) == word);
            else
                Knows(words[0], word);
        }
    }

    // Its options are in quotes or before a bracket's end in the usage, its words are cases.
    private static void Knows(string script, string word)
    {
        var text = File.ReadAllText(Repository.PathTo(script));
        Assert.True(
            word[0] == '-' && text.Contains($"\"{word}\"", StringComparison.Ordinal)
                || text.Contains($"\n{word})", StringComparison.Ordinal) || text.Contains($"\n    {word})", StringComparison.Ordinal),
            $"{script} does not know {word}.");
    }

    private static void FilesAreThere(string[] words) => Assert.All(
        words.Where(w => InRepository().IsMatch(w)), w => Assert.True(Path.Exists(Repository.PathTo(w)), $"{w} is not there."));

    private static void Occurs(string word)
    {
        var whole = new Regex($@"(?<![\w-]){Regex.Escape(word)}(?![\w-])", RegexOptions.None, TimeSpan.FromSeconds(10));
        Assert.True(
            Sources.Any(s => s.Value.Contains(word, StringComparison.Ordinal) && whole.IsMatch(s.Value)), $"Nothing knows {word}.");
    }

    [GeneratedRegex("```\\w*\n(?<lines>.*?)```", RegexOptions.ExplicitCapture | RegexOptions.Singleline, 1000)]
    private static partial Regex Fenced();

    [GeneratedRegex("`(?<code>[^`\n]+)`", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Marked();

    [GeneratedRegex(@"\A(?<name>[A-Z][A-Z_]+)=\w+\z", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Variable();

    [GeneratedRegex(@"(?<![\w-])--[a-z][a-z-]*", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Option();

    [GeneratedRegex(@"; also (?<verbs>[a-z]+(, [a-z]+)*)\b", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Further();

    [GeneratedRegex(@"\b([\w-]+/)*[\w-]+\.(md|slnf)\b", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex FileName();

    [GeneratedRegex(@"\A([0-9]+|[A-Z]+|'\*')\z", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Free();

    [GeneratedRegex(@"\A((src|tests|benchmarks|deploy|tools|docs|examples|samples)/.+|\w+\.slnf)\z", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex InRepository();
}
