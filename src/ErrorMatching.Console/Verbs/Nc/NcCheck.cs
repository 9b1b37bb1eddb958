using System.CommandLine;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary><c>errormatch nc check</c>.</summary>
internal sealed class NcCheck : NcVerb
{
    public NcCheck()
        : base(
            "check",
            "Counts blocks, words and motions, and says what the dialect does not know.",
            "errormatch nc check samples/complex-mating/counterpart.nc --dialect delta-nc300")
    {
    }

    protected override bool ShowsWhatIsWrong => true;

    protected override VerbResult Run(string file, NcPath path, ParseResult arguments, CancellationToken cancellation) =>
        new NcCheckAnswer(file, path, NcCensus.Of(path.Program));
}
