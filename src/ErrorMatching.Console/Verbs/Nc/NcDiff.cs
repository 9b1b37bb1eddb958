using System.CommandLine;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary><c>errormatch nc diff</c>.</summary>
internal sealed class NcDiff : Verb
{
    private readonly Argument<string> _before = new("BEFORE") { Description = "The first program." };
    private readonly Argument<string> _after = new("AFTER") { Description = "The second program." };
    private readonly Option<string> _html = FileOption("--html", "The file to write the comparison to as a page.");
    private readonly Option<string> _dialect = NcVerb.DialectOption();
    private readonly Option<string> _blockSkip = NcVerb.BlockSkipOption();
    private readonly AssumeOption _assume = new();
    private readonly Option<string[]> _libraries = NcVerb.LibraryOption();

    public NcDiff()
        : base(
            "diff",
            "Compares what two programs do, motion by motion.",
            "errormatch nc diff samples/figure-nine/original.nc samples/figure-nine/modified.nc --dialect delta-nc300")
    {
        Arguments.Add(_before);
        Arguments.Add(_after);
        Options.Add(_dialect);
        Options.Add(_blockSkip);
        Options.Add(_libraries);
        Options.Add(_assume.Option);
        Options.Add(_html);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        using var progress = new LateProgress(ProgressTo);
        progress.Report("comparing the programs");
        var (givenBefore, givenAfter) = (
            GivenProgram(arguments.GetRequiredValue(_before)), GivenProgram(arguments.GetRequiredValue(_after)));
        var (before, after, dialect) = (givenBefore.File, givenAfter.File, arguments.GetRequiredValue(_dialect));
        var blockSkip = BlockSkips.Of(arguments.GetValue(_blockSkip));
        var libraries = arguments.GetValue(_libraries);
        var was = NcVerb.Interpret(givenBefore, dialect, blockSkip, _assume.Of(arguments), ToolRadii.None, libraries, cancellation);
        var now = NcVerb.Interpret(givenAfter, dialect, blockSkip, _assume.Of(arguments), ToolRadii.None, libraries, cancellation);
        cancellation.ThrowIfCancellationRequested();
        if ((was.Refusal ?? now.Refusal) is { } refusal)
        {
            return FailureOf.Refused(was.Refusal is null ? after : before, refusal);
        }

        var comparison = MotionComparison.Of(was, now);
        if (arguments.GetValue(_html) is { } html)
        {
            OutputFile.Write(html, ProgramDifferenceHtml.Write(comparison, before, after), [before, after], cancellation);
        }

        return new NcDiffAnswer(before, after, comparison);
    }
}
