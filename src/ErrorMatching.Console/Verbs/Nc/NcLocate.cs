using System.CommandLine;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary><c>errormatch nc locate</c>.</summary>
internal sealed class NcLocate : NcVerb
{
    private readonly BlocksOption _blocks = new();

    public NcLocate()
        : base(
            "locate",
            "Shows the blocks that selectors name, and what they move.",
            "errormatch nc locate samples/complex-mating/counterpart.nc --blocks N120 N130..N160") =>
            Options.Add(_blocks);

    protected override VerbResult Run(string file, NcPath path, ParseResult arguments, CancellationToken cancellation)
    {
        var blocks = _blocks.Select(arguments, path.Program);
        return blocks.IsUsable ? new NcLocateAnswer(file, path, blocks.Result) : FailureOf.Refused(file, blocks.Refusal);
    }
}
