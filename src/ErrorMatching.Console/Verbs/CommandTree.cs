using System.CommandLine;
using System.CommandLine.Help;

namespace ErrorMatching.Console;

/// <summary>All verbs, in the order in which the help lists them.</summary>
internal static class CommandTree
{
    private static readonly ParserConfiguration Configuration = new()
    {
        // An argument is what it says: a file named @points.csv is no list of further arguments, and -1 no bundle of letters.
        ResponseFileTokenReplacer = null,
        EnablePosixBundling = false,
    };

    /// <summary>Parses a command line.</summary>
    public static ParseResult Parse(IReadOnlyList<string> args) => Build().Parse(args, Configuration);

    /// <summary>The root command.</summary>
    public static RootCommand Build()
    {
        var root = new RootCommand("Measures a machined piece and rewrites the NC program of its counterpart so that the two fit.")
        {
            new MatchVerb(),
            new VerifyVerb(),
            new Command("job", "Writes and checks jobs.") { new JobCheck(), new JobNew(), new JobSchema() },
            new Command("nc", "Looks at NC programs, displaces blocks, compares and proves programs.") { new NcCheck(), new NcMotionVerb(), new NcLocate(), new NcDisplace(), new NcDiff(), new NcProve(), new NcDialectsVerb() },
            new SurfaceVerb(),
            new Command("cell", "Runs beside gauges and machines.")
            {
                new CellCheckVerb(), new CellRun(), new CellStatusVerb(), new CellApprove(), new CellReject(), new CellRelease(), new CellRevert(), new CellHistory(), new CellShow(), new CellBackup(), new CellRestore(), new CellSecret(),
            },
            new Command("user", "Says who may do what at a cell.") { new UserAdd(), new UserList(), new UserDisable(), new UserEnable(), new UserRole(), new UserPassword() },
            new Command("audit", "Proves and hands out what was done at a cell, and by whom.") { new AuditVerify(), new AuditExport() },
            new Command("fit", "Fits curves to measured points.") { new FitLine(), new FitPolynomial(), new FitCircle() },
        };
        root.Directives.Clear();
        root.Options.Add(new Option<bool>("--json") { Description = "Print one JSON document and nothing else.", Recursive = true, Arity = ArgumentArity.Zero });
        var help = root.Options.OfType<HelpOption>().Single();
        help.Action = new HelpWithExample((HelpAction)help.Action!);
        root.Options.OfType<VersionOption>().Single().Action = new PrintVersion();
        return root;
    }
}
