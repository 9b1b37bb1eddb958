using System.CommandLine;
using ErrorMatching.Jobs;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>A verb for one program.</summary>
internal abstract class NcVerb : Verb
{
    private readonly Argument<string> _program = new("PROGRAM") { Description = "The NC program, or - for standard input." };
    private readonly Option<string> _dialect = DialectOption();
    private readonly Option<string> _blockSkip = BlockSkipOption();
    private readonly Option<string[]> _libraries = LibraryOption();
    private readonly AssumeOption _assume = new();
    private readonly ToolRadiiOption _radii = new();

    protected NcVerb(string name, string description, string example)
        : base(name, description, example)
    {
        Arguments.Add(_program);
        Options.Add(_dialect);
        Options.Add(_blockSkip);
        Options.Add(_libraries);
        Options.Add(_assume.Option);
        Options.Add(_radii.One);
        Options.Add(_radii.Several);
        Demand(_radii.One, ToolRadiiOption.IsRadius, "a radius in mm such as 3 or 4.975");
        Demand(_radii.Several, ToolRadiiOption.AreRadii, "numbers with a radius in mm each, such as D1=3,D2=4.975");
    }

    /// <summary>The option that names a control.</summary>
    public static Option<string> DialectOption()
    {
        var option = new Option<string>("--dialect")
        {
            Description = "The control that the program is written for: a dialect that errormatch nc dialects lists, or a file of your own "
                + "that ends in .json.",
            HelpName = "NAME|FILE.json",
            DefaultValueFactory = _ => NcDialects.Names[0],
        };
        option.CompletionSources.Add([.. NcDialects.Names]);
        return option;
    }

    /// <summary>The option for the state of the block skip switch.</summary>
    public static Option<string> BlockSkipOption()
    {
        var option = new Option<string>("--block-skip")
        {
            Description = "How the machine's switches for block skip are set: off, blocks behind a slash are executed; "
                + "on, they are passed over. A program that depends on it is refused without.",
            HelpName = string.Join('|', BlockSkips.Words),
        };
        option.AcceptOnlyFromAmong([.. BlockSkips.Words]);
        return option;
    }

    /// <summary>The option for folders with called programs.</summary>
    public static Option<string[]> LibraryOption() => new("--library")
    {
        Description = "A folder with subprograms and macros, which is searched behind the program's own; several are searched in order.",
        HelpName = "DIR",
    };

    /// <summary>Reads and interprets a program.</summary>
    /// <param name="program">The program, with its content if it comes from standard input.</param>
    /// <param name="dialect">The control's dialect.</param>
    /// <param name="blockSkip">The switches for block skip.</param>
    /// <param name="assumed">Values of variables that only the machine knows.</param>
    /// <param name="radii">The tools' radii.</param>
    /// <param name="libraries">Folders with called programs, searched behind the program's own, or, for standard input, the working
    /// folder.</param>
    /// <param name="cancellation">Set by Ctrl+C.</param>
    /// <exception cref="InputException">A file cannot be opened. The dialect is unknown, or the program is too large. The dialect's
    /// file cannot be used.</exception>
    /// <exception cref="OperationCanceledException">Ctrl+C was pressed.</exception>
    public static NcPath Interpret(
        GivenFile program, string dialect, BlockSkip blockSkip, AssumedValues assumed, ToolRadii radii, string[]? libraries,
        CancellationToken cancellation)
    {
        var known = InputFile.Dialect(dialect).With(blockSkip).With(assumed).With(radii);
        var read = NcProgram.Read(program.Bytes is { } bytes ? InputFile.Checked(program.File, bytes) : InputFile.Program(program.File));
        return NcInterpreter.Run(read, known, new ProgramFolder(program.File, libraries ?? []).Find, cancellation);
    }

    public sealed override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        using var progress = new LateProgress(ProgressTo);
        progress.Report("working through the program");
        var given = GivenProgram(arguments.GetRequiredValue(_program));
        var file = given.File;
        var path = Interpret(
            given,
            arguments.GetRequiredValue(_dialect),
            BlockSkips.Of(arguments.GetValue(_blockSkip)),
            _assume.Of(arguments),
            _radii.Of(arguments),
            arguments.GetValue(_libraries),
            cancellation);
        cancellation.ThrowIfCancellationRequested();
        return path.Refusal is { } refusal && !ShowsWhatIsWrong
            ? FailureOf.Refused(file, Refusals(path, refusal))
            : Run(file, path, arguments, cancellation) switch
            {
                Failure { Exit: ExitCode.Refused } failure => FailureOf.Refused(file, Refusals(path, [.. failure.Errors])),
                var result => result,
            };
    }

    /// <summary>Reasons for a refusal, behind the one that explains them all if the program is in another dialect.</summary>
    public static Refusal[] Refusals(NcPath path, params Refusal[] reasons) =>
        DialectFit.Refusal(path.Program, path.Dialect) is { } other ? [other, .. reasons] : reasons;

    /// <summary>True if the verb reports the errors of a program that cannot be followed to its end; other verbs refuse it.</summary>
    protected virtual bool ShowsWhatIsWrong => false;

    /// <summary>Does the work.</summary>
    /// <param name="file">The program as the user named it.</param>
    /// <param name="path">The interpreted program.</param>
    /// <param name="arguments">What the user typed.</param>
    /// <param name="cancellation">Set by Ctrl+C.</param>
    protected abstract VerbResult Run(string file, NcPath path, ParseResult arguments, CancellationToken cancellation);
}
