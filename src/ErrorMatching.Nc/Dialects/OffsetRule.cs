using System.Text.RegularExpressions;

namespace ErrorMatching.Nc;

/// <summary>How a program changes the offsets of a control, as its dialect states it: lines with names in braces, for which values are
/// put.</summary>
internal sealed partial class OffsetRule
{
    /// <summary>The codes of the work offsets that can be changed, times ten, the one with number 1 first.</summary>
    public IReadOnlyList<int> Codes { get; set; } = [];

    /// <summary>The program around its sections; empty if none is written for the control.</summary>
    public IReadOnlyList<string> Program { get; set; } = [];

    /// <summary>The section that corrects the radius of a tool; empty if there is none.</summary>
    public IReadOnlyList<string> Radius { get; set; } = [];

    /// <summary>The section that moves a work offset; empty if there is none.</summary>
    public IReadOnlyList<string> Work { get; set; } = [];

    /// <summary>Number of variables that a program keeps values in.</summary>
    public const int Variables = 10;

    /// <summary>Names of values in the program around the sections.</summary>
    public static readonly IReadOnlyList<string> InProgram = ["program", "body"];

    /// <summary>Names of values in every section.</summary>
    private static readonly IReadOnlyList<string> InSections =
        ["number", "step", "stepDegrees", .. Enumerable.Range(0, Variables).Select(i => $"m{i}")];

    /// <summary>Names of values in the section of a radius.</summary>
    public static readonly IReadOnlyList<string> InRadius = [.. InSections, "tool", "radius"];

    /// <summary>Names of values in the section of a work offset.</summary>
    public static readonly IReadOnlyList<string> InWork = [.. InSections, "x", "y", "rotation"];

    /// <summary>Names of the correction before of a radius.</summary>
    public static readonly IReadOnlyList<string> BeforeRadius = ["radiusBefore"];

    /// <summary>Names of the correction before of a work offset.</summary>
    public static readonly IReadOnlyList<string> BeforeWork = ["xBefore", "yBefore", "rotationBefore"];

    /// <summary>A name in braces.</summary>
    [GeneratedRegex(@"\{(?<name>[A-Za-z0-9]{1,32})\}", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    public static partial Regex Name();
}
