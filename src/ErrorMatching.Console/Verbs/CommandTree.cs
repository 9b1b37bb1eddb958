using System.CommandLine;
using System.CommandLine.Help;

namespace ErrorMatching.Console;

/// <summary>All verbs, in help order.</summary>
internal static class CommandTree
{
    private static readonly ParserConfiguration Configuration = new()
    {
        // Arguments are taken literally: a file named @points.csv is not a list of more arguments, and -1 is not a bundle of letters.
        ResponseFileTokenReplacer = null,
        EnablePosixBundling = false,
    };

    /// <summary>The command line that shows what the program is for; it works in the root of the checkout.</summary>
    internal const string Example = "errormatch match samples/complex-mating/job.json --out out";

    /// <summary>The possible first words of a command line, in help order.</summary>
    internal static IReadOnlyList<string> FirstWords { get; } =
        ["match", "verify", "job", "nc", "surface", "cell", "user", "audit", "fit", "completion", HelpVerb.Word];

    /// <summary>Parses a command line.</summary>
    public static ParseResult Parse(IReadOnlyList<string> args) =>
        Build(args.Count > 0 ? args[0] : null, args.Count > 1 ? args[1] : null).Parse(args, Configuration);

    /// <summary>The help of a command, or of all if none is named.</summary>
    /// <param name="words">The command's words; the first one that is no command ends them.</param>
    /// <param name="output">Where it is written.</param>
    public static void WriteHelp(IReadOnlyList<string> words, TextWriter output)
    {
        Command at = Build(words.Count > 0 ? words[0] : null, words.Count > 1 ? words[1] : null);
        List<string> line = [];
        foreach (var word in words)
        {
            if (at.Subcommands.FirstOrDefault(c => c.Name == word) is not { } next)
            {
                break;
            }

            at = next;
            line.Add(word);
        }

        _ = Parse([.. line, "--help"]).Invoke(new InvocationConfiguration { Output = output, Error = output });
    }

    /// <summary>The root command.</summary>
    /// <param name="first">The first word of the command line. If it is a command, only that one is built. Null builds all.</param>
    /// <param name="second">The second word, likewise for the commands of a group.</param>
    public static RootCommand Build(string? first = null, string? second = null)
    {
        var root = new RootCommand("Measures a machined piece and rewrites the NC program of its counterpart so that the two fit.");
        foreach (var word in first is not null && FirstWords.Contains(first) ? [first] : FirstWords)
        {
            root.Add(Make(word, second));
        }

        if (first?.StartsWith("[suggest", StringComparison.Ordinal) != true)
        {
            // A file may be named like a directive; only the scripts of "completion" use one.
            root.Directives.Clear();
        }

        root.Options.Add(
            new Option<bool>("--json")
            {
                Description = "Print one JSON document and nothing else.",
                Recursive = true,
                Arity = ArgumentArity.Zero
            });
        var help = root.Options.OfType<HelpOption>().Single();
        help.Action = new HelpWithExample((HelpAction)help.Action!);
        root.Options.OfType<VersionOption>().Single().Action = new PrintVersion();
        return root;
    }

    private static Command Make(string word, string? second) => word switch
    {
        "match" => new MatchVerb(),
        "verify" => new VerifyVerb(),
        "job" => Group(word, "Writes and checks jobs, finds their blocks, and plans where to touch.", second,
            ("check", () => new JobCheckVerb()), ("blocks", () => new JobBlocks()), ("new", () => new JobNew()),
            ("plan", () => new JobPlan()), ("probe", () => new JobProbe()), ("schema", () => new JobSchema())),
        "nc" => Group(word, "Looks at NC programs, displaces blocks, compares and proves programs.", second,
            ("check", () => new NcCheck()), ("motion", () => new NcMotionVerb()), ("locate", () => new NcLocate()),
            ("displace", () => new NcDisplace()), ("diff", () => new NcDiff()), ("prove", () => new NcProve()),
            ("dialects", () => new NcDialectsVerb())),
        "surface" => new SurfaceVerb(),
        "cell" => new Command(word, "Runs beside gauges and machines.")
        {
            new CellCheckVerb(), new CellRun(), new CellStatusVerb(), new CellAlarms(), new CellApprove(), new CellReject(),
            new CellRecalculate(), new CellRelease(), new CellRevert(), new CellHistory(), new CellShow(), new CellBackup(),
            new CellRestore(), new CellThin(), new CellSecret(),
        },
        "user" => new Command(word, "Says who may do what at a cell.")
        {
            new UserAdd(),
            new UserList(),
            new UserDisable(),
            new UserEnable(),
            new UserRole(),
            new UserPassword(),
            new UserPin(),
            new UserBadge()
        },
        "audit" => new Command(word, "Proves and hands out what was done at a cell, and by whom.")
        {
            new AuditVerify(),
            new AuditExport(),
            new AuditTakeOver()
        },
        "fit" => new Command(word, "Fits curves to measured points.") { new FitLine(), new FitPolynomial(), new FitCircle() },
        "completion" => new CompletionVerb(),
        HelpVerb.Word => new HelpVerb(),
        _ => throw new ArgumentOutOfRangeException(nameof(word), word, "No command begins so."),
    };

    // Making a verb costs a millisecond of a start, so only the one that is named is made.
    private static Command Group(string word, string description, string? second, params (string Name, Func<Command> Make)[] verbs)
    {
        var group = new Command(word, description);
        var named = Array.FindIndex(verbs, v => v.Name == second);
        foreach (var verb in named < 0 ? verbs : verbs[named..(named + 1)])
        {
            group.Add(verb.Make());
        }

        return group;
    }
}
