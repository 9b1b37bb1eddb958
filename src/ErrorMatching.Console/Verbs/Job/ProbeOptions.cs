using System.CommandLine;

namespace ErrorMatching.Console;

/// <summary>Options shared by the plan and the probing program of a mating job.</summary>
internal static class ProbeOptions
{
    /// <summary>The diameter of the ball.</summary>
    public static Option<double?> Stylus() => Positive(
        "--stylus-diameter",
        "Diameter of the stylus ball. Without it: gauge.stylusDiameterMm of the job, or else 6 mm, which is told.",
        "MM");

    /// <summary>A number above 0.</summary>
    public static Option<double?> Positive(string name, string description, string help)
    {
        var option = new Option<double?>(name) { Description = description, HelpName = help };
        option.Validators.Add(result =>
        {
            if (result.GetValueOrDefault<double?>() is { } value && !(value is > 0 and <= 10_000))
            {
                result.AddError(FormattableString.Invariant($"{name} is {value}; expected a number above 0 and up to 10000."));
            }
        });
        return option;
    }

    /// <summary>A height.</summary>
    public static Option<double?> Height(string name, string description)
    {
        var option = new Option<double?>(name) { Description = description, HelpName = "Z" };
        option.Validators.Add(result =>
        {
            if (result.GetValueOrDefault<double?>() is { } value && !(Math.Abs(value) <= 10_000))
            {
                result.AddError(FormattableString.Invariant($"{name} is {value}; expected a height within 10000 mm of Z0."));
            }
        });
        return option;
    }
}
