using System.CommandLine;

namespace ErrorMatching.Console;

/// <summary><c>errormatch surface</c>: the verbs for free-form surfaces, in help order.</summary>
internal sealed class SurfaceVerb : Command
{
    public SurfaceVerb()
        : base("surface", "Plans, measures, compensates and evaluates free-form surfaces.")
    {
        Subcommands.Add(new SurfacePlanVerb());
        Subcommands.Add(new SurfaceProbe());
        Subcommands.Add(new SurfaceCompensate());
        Subcommands.Add(new SurfaceToolpath());
        Subcommands.Add(new SurfaceDisplace());
        Subcommands.Add(new SurfaceEvaluate());
        Subcommands.Add(new SurfaceFit());
    }
}
