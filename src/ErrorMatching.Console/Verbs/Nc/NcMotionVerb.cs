using System.CommandLine;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary><c>errormatch nc motion</c>.</summary>
internal sealed class NcMotionVerb : NcVerb
{
    public NcMotionVerb()
        : base(
            "motion",
            "Prints the programmed path, motion by motion, as CSV in absolute millimeters.",
            "errormatch nc motion samples/complex-mating/counterpart.nc --dialect delta-nc300")
    {
    }

    protected override VerbResult Run(string file, NcPath path, ParseResult arguments, CancellationToken cancellation) =>
        new NcMotionAnswer(file, path);
}
