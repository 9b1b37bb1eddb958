using System.CommandLine;
using System.Reflection;
using ErrorMatching.Jobs;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

public class ContractTests
{
    private static readonly IReadOnlyList<Verb> Verbs = [.. Tree(CommandTree.Build()).OfType<Verb>()];

    public static TheoryData<string> VerbNames => [.. Verbs.Select(WordsOf)];

    // Those of a cell need people, a process that runs it, or each other: CellExampleTests runs them.
    public static TheoryData<string> AloneVerbNames => [.. Verbs.Where(v => v is not CellVerb).Select(WordsOf)];

    public static TheoryData<string> DemandingVerbNames =>
        [.. Verbs.Where(v => v.Arguments.Any(a => a.Arity.MinimumNumberOfValues > 0)).Select(WordsOf)];

    [Fact]
    public void A_command_line_s_first_word_makes_the_command_of_that_name_and_no_other()
    {
        Assert.Equal(CommandTree.FirstWords, CommandTree.Build().Subcommands.Select(c => c.Name));
        Assert.All(CommandTree.FirstWords, w => Assert.Equal(w, Assert.Single(CommandTree.Build(w).Subcommands).Name));
        Assert.Equal(CommandTree.FirstWords, CommandTree.Build("matches").Subcommands.Select(c => c.Name));
    }

    [Fact]
    public void Version_prints_the_version_alone() => Assert.Equal((0, "0.2.0\n", ""), Shell.Run("--version"));

    [Theory]
    [MemberData(nameof(VerbNames))]
    public void Each_verb_shows_its_example_in_its_help(string words)
    {
        var verb = Find(words);
        var (exit, output, error) = Shell.Run([.. words.Split(' '), "--help"]);
        Assert.Equal((0, ""), (exit, error));
        Assert.EndsWith($"Example:\n  {verb.Example}\n", output, StringComparison.Ordinal);
    }

    [Fact]
    public void The_program_s_help_shows_what_it_is_for()
    {
        var (exit, output, error) = Shell.Run("--help");
        Assert.Equal((0, ""), (exit, error));
        Assert.Contains("Example:\n  errormatch match samples/complex-mating/job.json --out out\n", output, StringComparison.Ordinal);
        Assert.EndsWith("Manual:\n  docs/first-match.md, and the tasks listed in docs/README.md\n", output, StringComparison.Ordinal);
        Assert.True(File.Exists(Repository.PathTo("docs/first-match.md")));
    }

    [Theory]
    [InlineData("mtach job.json", "Unrecognized command or argument 'mtach'. Did you mean match? See errormatch --help.")]
    [InlineData("nc chek a.nc", "Unrecognized command or argument 'chek'. Did you mean check? See errormatch nc --help.")]
    [InlineData("--verson", "Unrecognized command or argument '--verson'. Did you mean --version? See errormatch --help.")]
    [InlineData("match --otu a.json", "Unrecognized command or argument '--otu'. Did you mean --out? See errormatch match --help.")]
    [InlineData("match a.json --otu b", "Unrecognized command or argument '--otu'. Did you mean --out? See errormatch match --help.")]
    [InlineData("nc check --jsn", "Unrecognized command or argument '--jsn'. Did you mean --json? See errormatch nc check --help.")]
    [InlineData("weld", "Unrecognized command or argument 'weld'. See errormatch --help.")]
    public void A_misspelled_word_is_answered_with_the_one_that_was_meant(string line, string expected) =>
        Assert.Equal($"errormatch: {expected}\n", Shell.Run(line.Split(' ')).Error);

    // After "--", names of files may look like options; so may the values of options.
    [Fact]
    public void A_file_may_be_named_like_an_option()
    {
        var error = Shell.Run("nc", "check", "--dialect", "fanuc", "--", "--otu").Error;
        Assert.Contains("--otu", error, StringComparison.Ordinal);
        Assert.DoesNotContain("Unrecognized", error, StringComparison.Ordinal);
    }

    [Fact]
    public void Completion_offers_the_words_that_may_follow()
    {
        Assert.Equal(["check"], Offered("errormatch nc ch"));
        Assert.Contains("--dialect", Offered("errormatch nc check --"));
        Assert.Contains("match", Offered("errormatch "));

        static string[] Offered(string line) =>
            Shell.Run($"[suggest:{line.Length}]", line).Output.Split(
                '\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
    }

    [Theory]
    [MemberData(nameof(AloneVerbNames))]
    public void Each_example_runs_on_the_samples(string words)
    {
        using var folder = new TemporaryFolder();
        var example = Find(words).Example;
        Assert.StartsWith("errormatch " + words, example, StringComparison.Ordinal);
        var args = example.Split(' ')[1..].Select(Placed).ToArray();
        Assert.Empty(CommandTree.Parse(args).Errors);
        Assert.Equal((0, ""), Shell.Run(args) is var r ? (r.Exit, r.Error) : default);

        string Placed(string word) => word.StartsWith("samples/", StringComparison.Ordinal) ? Repository.PathTo(word)
            : word == "out" || word.StartsWith("out/", StringComparison.Ordinal) ? folder[word]
            : word;
    }

    [Theory]
    [MemberData(nameof(DemandingVerbNames))]
    public void Each_verb_without_arguments_is_a_wrong_command_line(string words)
    {
        var errors = Shell.Json(1, "errormatch/error/1", words.Split(' ')).GetProperty("errors");
        Assert.NotEqual(0, errors.GetArrayLength());
        Assert.All(errors.EnumerateArray(), error =>
        {
            Assert.Equal("command-line", error.Text("code"));
            Assert.EndsWith($"See errormatch {words} --help.", error.Text("message"), StringComparison.Ordinal);
        });
    }

    [Theory]
    [InlineData("")]
    [InlineData("fit")]
    [InlineData("nope")]
    [InlineData("fit line a b")]
    [InlineData("fit line a --wrong")]
    [InlineData("fit line a --method foo")]
    [InlineData("fit line @file b")]
    [InlineData("fit polynomial a")]
    [InlineData("fit polynomial a --degree -1")]
    [InlineData("fit polynomial a --degree 1.5")]
    [InlineData("fit polynomial a --degree")]
    [InlineData("fit polynomial a --degree 2 --ridge NaN")]
    [InlineData("fit polynomial a --degree 2 --ridge 1,5")]
    [InlineData("fit polynomial a --degree 2 --uncertainty 0")]
    [InlineData("fit polynomial a --degree 2 --at 1,,5")]
    [InlineData("fit polynomial a --degree 2 --at 1,Infinity")]
    public void A_wrong_command_line_is_exit_1_in_both_forms(string line)
    {
        var args = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        var document = Shell.Json(1, "errormatch/error/1", args);
        Assert.All(document.GetProperty("errors").EnumerateArray(), e => Assert.Equal("command-line", e.Text("code")));
        var (exit, output, error) = Shell.Run(args);
        Assert.Equal((1, ""), (exit, output));
        Assert.StartsWith("errormatch: ", error, StringComparison.Ordinal);
        Assert.DoesNotContain('\t', error);
    }

    [Fact]
    public void Bad_data_is_named_by_file_line_and_column_in_both_forms()
    {
        using var folder = new TemporaryFolder();
        var file = folder.File("p.csv", "x,y\n1,2\n3,oops\n");
        var error = Shell.Error(1, "fit", "line", file);
        Assert.Equal(
            ("text-for-number", file, 3, 2),
            (error.Text("code"), error.Text("file"), error.GetProperty("line").GetInt32(), error.GetProperty("column").GetInt32()));
        Assert.Equal(
            $"{file}, line 3, column 2: found \"oops\" in column y; expected a number such as 12.345 or -5e-3.", error.Text("message"));
        Assert.Equal(
            (1, "", $"{file}:3:2: found \"oops\" in column y; expected a number such as 12.345 or -5e-3.\n"),
            Shell.Run("fit", "line", file));
    }

    [Fact]
    public void A_missing_input_is_exit_1()
    {
        var error = Shell.Error(1, "fit", "line", "none.csv");
        Assert.Equal(("file-unreadable", "none.csv"), (error.Text("code"), error.Text("file")));
        Assert.False(error.TryGetProperty("line", out _));
    }

    [Fact]
    public void A_file_named_like_a_response_file_is_a_file() =>
        Assert.Equal("@none.csv", Shell.Error(1, "fit", "line", "@none.csv").Text("file"));

    [Fact]
    public void Json_may_stand_anywhere() =>
        Assert.Equal(Shell.Run("--json", "fit", "line", "none.csv"), Shell.Run("fit", "line", "none.csv", "--json"));

    [Fact]
    public void A_cancelled_run_is_exit_130_and_prints_no_document()
    {
        using var output = new StringWriter();
        using var error = new StringWriter();
        var exit = Application.Run(
            ["fit", "line", Repository.PathTo("samples", "fits", "line.csv"), "--json"],
            new Terminal(output, error, false),
            new CancellationToken(canceled: true));
        Assert.Equal((130, ""), (exit, output.ToString()));
        Assert.Contains("Cancelled", error.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void An_output_that_cannot_be_written_is_exit_3()
    {
        using var error = new StringWriter();
        using var output = new FullDisk();
        Assert.Equal(3, Application.Run(["--version"], new Terminal(output, error, false), TestContext.Current.CancellationToken));
        Assert.Contains("no room", error.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void A_defect_is_exit_3_and_asks_for_a_report() =>
        Assert.Equal(
            (ExitCode.Outside, "internal-error"),
            FailureOf.Defect(new InvalidOperationException()) is var f ? (f.Exit, f.Errors[0].Code) : default);

    [Fact]
    public void Each_code_of_an_error_is_in_the_reference()
    {
        var reference = File.ReadAllText(Repository.PathTo("docs", "reference-console.md"));
        var codes = ConstantsOf(typeof(Measurement.MeasurementError))
            .Concat(Enum.GetValues<Geometry.GeometryError>().Select(e => FailureOf.Geometry(new(e, ""), "").Errors[0].Code))
            .Concat([
                Nc.NcRefusalCodes.NumberTooLong])
            .Concat(ConstantsOf(typeof(Nc.NcInputCodes)))
            .Concat(ConstantsOf(typeof(OutputException)));
        Assert.All(
            codes.Concat(["command-line", "wrong-piece", "internal-error"]),
            c => Assert.Contains($"| `{c}` |", reference, StringComparison.Ordinal));
    }

    [Fact]
    public void Each_code_of_a_refusal_is_explained()
    {
        var page = File.ReadAllText(Repository.PathTo("docs", "refusals.md"));
        var mating = typeof(Mating.Matcher).Assembly.GetTypes()
            .Where(t => t.Name is "FeatureMapper" or "BoundarySearch" or "AlignedMeasurement" or "Marker" or "OriginCheck")
            .SelectMany(ConstantsOf)
            .Where(c => c.Contains('-', StringComparison.Ordinal))
            .Concat(Mating.RefusalForms.All.Select(f => f.Name));
        var codes = ConstantsOf(typeof(Nc.NcRefusalCodes)).Concat(mating).ToArray();
        Assert.True(codes.Length > 25);
        Assert.All(codes, c => Assert.Contains($"`{c}`", page, StringComparison.Ordinal));
    }

    private static IEnumerable<string> ConstantsOf(Type type) =>
        type.GetFields(BindingFlags.Public | BindingFlags.Static)
            .Where(f => f.IsLiteral && f.FieldType == typeof(string))
            .Select(f => (string)f.GetRawConstantValue()!);

    private static Verb Find(string words) => Verbs.Single(v => WordsOf(v) == words);

    private static IEnumerable<Command> Tree(Command command) => command.Subcommands.SelectMany(Tree).Prepend(command);

    private static string WordsOf(Command command) =>
        command.Parents.First() is Command parent and not RootCommand ? WordsOf(parent) + " " + command.Name : command.Name;

    private sealed class FullDisk : StringWriter
    {
        public override void Flush() => throw new IOException("no room");
    }
}
