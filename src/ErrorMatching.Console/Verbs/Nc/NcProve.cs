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

    private readonly CertificateOption _certificate = new();
    private readonly Option<string[]> _libraries = NcVerb.LibraryOption();

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
        Options.Add(_certificate);
        Options.Add(_libraries);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        using var progress = new LateProgress(ProgressTo);
        progress.Report("proving the result");
        var (givenBefore, givenAfter, file) = (
            GivenProgram(arguments.GetRequiredValue(_before)),
            GivenProgram(arguments.GetRequiredValue(_after)),
            arguments.GetRequiredValue(_wish));
        var (before, after) = (givenBefore.File, givenAfter.File);
        var wish = InputFile.Wish(file);
        cancellation.ThrowIfCancellationRequested();
        var dialect = arguments.GetValue(_dialect) ?? wish.Dialect;
        var libraries = arguments.GetValue(_libraries);
        var was = NcVerb.Interpret(givenBefore, dialect, wish.BlockSkip, wish.Assumed, wish.ToolRadii, libraries, cancellation);
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

        var now = NcVerb.Interpret(givenAfter, dialect, wish.BlockSkip, wish.Assumed, wish.ToolRadii, libraries, cancellation);
        cancellation.ThrowIfCancellationRequested();
        var proof = Prover.Check(was, now.Program, wish.Wish, wish.LeastIncrementMm, wish.Marker);
        if (!proof.Holds)
        {
            return FailureOf.NotProved(before, after, proof);
        }

        string[] inputs = [before, after, file, .. was.Dialect.Files.Select(f => f.File)];
        var outputs = _certificate.Before([], () => Certificate.Of(was, now.Program, wish.Wish, wish.LeastIncrementMm, proof), arguments);
        if (outputs.Count > 0)
        {
            OutputFile.WriteAll(outputs, inputs, () => true, cancellation);
        }

        return new NcProveAnswer(before, after, file, wish, proof, MotionComparison.Of(was, now));
    }
}
