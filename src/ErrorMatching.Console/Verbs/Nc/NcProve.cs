using System.CommandLine;
using ErrorMatching.Jobs;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary><c>errormatch nc prove</c>.</summary>
internal sealed class NcProve : Verb
{
    private readonly Argument<string> _before = new("BEFORE") { Description = "The program that was displaced." };
    private readonly Argument<string> _after = new("AFTER") { Description = "The result." };
    private readonly Option<string> _wish = new("--wish")
    {
        Description = "What was asked, as match and nc displace write it.",
        HelpName = "FILE",
        Required = true
    };

    private readonly Option<string> _dialect = new("--dialect")
    {
        Description = "The file of the dialect that the wish names, where that is one of your own.",
        HelpName = "FILE.json",
    };

    public NcProve()
        : base(
            "prove",
            "Proves again, from the files alone, that a result is what was asked and nothing else.",
            "errormatch nc prove samples/complex-mating/counterpart.nc samples/proof/displaced.nc --wish samples/proof/wish.json")
    {
        Arguments.Add(_before);
        Arguments.Add(_after);
        Options.Add(_wish);
        Options.Add(_dialect);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        var (before, after, file) = (
            arguments.GetRequiredValue(_before), arguments.GetRequiredValue(_after), arguments.GetRequiredValue(_wish));
        var wish = InputFile.Wish(file);
        cancellation.ThrowIfCancellationRequested();
        var dialect = arguments.GetValue(_dialect) ?? wish.Dialect;
        var was = NcVerb.Interpret(before, dialect, wish.BlockSkip, wish.ToolRadii, cancellation);
        if (was.Dialect.Name != wish.Dialect)
        {
            return FailureOf.OtherDialect(file, dialect, wish.Dialect);
        }

        if (!wish.IsAbout(was, file))
        {
            return FailureOf.OtherProgram(file, before, wish.BeforeSha256);
        }

        if (was.Refusal is { } refusal)
        {
            return FailureOf.Refused(before, refusal);
        }

        var now = NcVerb.Interpret(after, dialect, wish.BlockSkip, wish.ToolRadii, cancellation);
        cancellation.ThrowIfCancellationRequested();
        var proof = Prover.Check(was, now.Program, wish.Wish, wish.LeastIncrementMm, wish.Marker);
        return proof.Holds
            ? new NcProveAnswer(before, after, file, wish, proof, MotionComparison.Of(was, now))
            : FailureOf.NotProved(before, after, proof);
    }
}
