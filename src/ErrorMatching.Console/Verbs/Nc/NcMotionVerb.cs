using System.CommandLine;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary><c>errormatch nc motion</c>.</summary>
internal sealed class NcMotionVerb : NcVerb
{
    private readonly Option<bool> _compensated = new("--compensated")
    {
        Description = "Prints the path of the tool's center, with cutter compensation (G41, G42, RL, RR) applied.",
    };

    public NcMotionVerb()
        : base(
            "motion",
            "Prints the programmed path, motion by motion, as CSV in absolute millimeters.",
            "errormatch nc motion samples/complex-mating/counterpart.nc --dialect delta-nc300")
    {
        Options.Add(_compensated);
    }

    protected override VerbResult Run(string file, NcPath path, ParseResult arguments, CancellationToken cancellation)
    {
        if (!arguments.GetValue(_compensated))
        {
            return new NcMotionAnswer(file, path);
        }

        var center = CompensatedPath.Of(path, cancellation);
        return center.Refusal is { } refusal ? FailureOf.Refused(file, refusal) : new NcCenterAnswer(file, center);
    }
}
