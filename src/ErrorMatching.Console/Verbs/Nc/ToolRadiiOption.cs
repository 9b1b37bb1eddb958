using System.CommandLine;
using System.Globalization;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>The options for the radii that a control uses for cutter compensation.</summary>
internal sealed class ToolRadiiOption
{
    private const double MostMm = 1000;

    private readonly Option<string> _radius = new("--tool-radius")
    {
        Description = "The tool's radius in mm, as the control has it for cutter compensation (G41, G42, RL, RR).",
        HelpName = "R"
    };

    private readonly Option<string> _radii = new("--tool-radii")
    {
        Description = "The radii in mm by the numbers that D or TOOL CALL names, if there are several.",
        HelpName = "D1=R1,D2=R2"
    };

    /// <summary>The radius of one tool, to demand something of it.</summary>
    public Option<string> One => _radius;

    /// <summary>The radii of several tools.</summary>
    public Option<string> Several => _radii;

    /// <summary>True for a radius in mm.</summary>
    public static bool IsRadius(string text) => Radius(text) is not null;

    /// <summary>True for numbers with a radius each.</summary>
    public static bool AreRadii(string text) => Radii(text) is not null;

    /// <summary>What the user stated.</summary>
    public ToolRadii Of(ParseResult arguments) => ToolRadii.OfTable(
        arguments.GetValue(_radii) is { } radii ? Radii(radii)! : new Dictionary<int, double>(),
        arguments.GetValue(_radius) is { } radius ? Radius(radius) : null);

    private static Dictionary<int, double>? Radii(string text)
    {
        var radii = new Dictionary<int, double>();
        foreach (var part in text.Split(','))
        {
            var sides = part.Split('=');
            if (sides is not [var number, var radius]
                || !int.TryParse(number.TrimStart('D', 'd'), NumberStyles.None, CultureInfo.InvariantCulture, out var d)
                || Radius(radius) is not { } mm
                || !radii.TryAdd(d, mm))
            {
                return null;
            }
        }

        return radii;
    }

    private static double? Radius(string text) =>
        double.TryParse(text, NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out var radius)
            && Math.Abs(radius) <= MostMm
            ? radius
            : null;
}
