using System.CommandLine;
using ErrorMatching.Freeform;

namespace ErrorMatching.Console;

/// <summary>Options shared by several verbs of <c>errormatch surface</c>.</summary>
internal static class SurfaceOptions
{
    /// <summary>Files of measured points; at least one.</summary>
    public static Option<string[]> Measured(string description) =>
        new("--measured")
        {
            Description = description,
            HelpName = "FILE",
            Required = true,
            AllowMultipleArgumentsPerToken = true,
            Arity = ArgumentArity.OneOrMore
        };

    /// <summary>The program that cut the measured piece.</summary>
    public static Option<string> CutBy() => new("--cut-by")
    {
        Description = "The program that cut the measured piece, instead of the job's measuring.cutBy. One that follows a measurement "
            + "already is refused.",
        HelpName = "NC",
    };

    /// <summary>The report of the program that cut the measured piece.</summary>
    public static Option<string> Previous() => new("--previous")
    {
        Description = "The report.json of the compensation whose program cut the measured piece: its corrections go on, and all pieces "
            + "measured so far count.",
        HelpName = "REPORT",
    };

    /// <summary>Measurements of earlier pieces.</summary>
    public static Option<string[]> Earlier() => new("--earlier")
    {
        Description = "Measurements of earlier pieces that the same program cut, one file for each, oldest first. All pieces compensate "
            + "together.",
        HelpName = "FILE",
        AllowMultipleArgumentsPerToken = true,
        Arity = ArgumentArity.OneOrMore
    };

    /// <summary>The verdicts that are accepted although they say not to cut.</summary>
    public static AcceptOption Accept() => new(ProfileWords.Acceptable);

    /// <summary>The folder to write to.</summary>
    public static Option<string> Out(string description) => new("--out") { Description = description, HelpName = "DIR" };
}
