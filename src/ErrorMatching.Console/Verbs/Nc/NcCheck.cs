using System.CommandLine;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary><c>errormatch nc check</c>.</summary>
internal sealed class NcCheck : NcVerb
{
    private readonly Option<bool> _strict = new("--strict")
    {
        Description = "End with exit 2 unless everything is understood and followed.",
    };

    public NcCheck()
        : base(
            "check",
            "Counts blocks, words and motions, and says what the dialect does not know.",
            "errormatch nc check samples/complex-mating/counterpart.nc --dialect delta-nc300")
    {
        Options.Add(_strict);
    }

    protected override bool ShowsWhatIsWrong => true;

    protected override VerbResult Run(string file, NcPath path, ParseResult arguments, CancellationToken cancellation) =>
        new NcCheckAnswer(file, path, NcCensus.Of(path.Program), arguments.GetValue(_strict));
}
