namespace ErrorMatching.Nc;

/// <summary>How a program changes the offsets of a control, as its dialect states it: lines with names in braces, for which values are
/// put.</summary>
internal sealed class OffsetRule
{
    /// <summary>The codes of the work offsets that can be changed, times ten, the one with number 1 first.</summary>
    public IReadOnlyList<int> Codes { get; set; } = [];

    /// <summary>The program around its sections; empty if none is written for the control.</summary>
    public IReadOnlyList<string> Program { get; set; } = [];

    /// <summary>The block by which another program calls it; empty if it cannot be called.</summary>
    public string Call { get; set; } = "";

    /// <summary>The name that its file must have for that; empty if the name does not matter.</summary>
    public string File { get; set; } = "";

    /// <summary>The section that corrects the radius of a tool; empty if there is none.</summary>
    public IReadOnlyList<string> Radius { get; set; } = [];

    /// <summary>The section that moves a work offset; empty if there is none.</summary>
    public IReadOnlyList<string> Work { get; set; } = [];

    /// <summary>Number of variables that a program keeps values in.</summary>
    public const int Variables = 10;

    /// <summary>Names of values in the name of the program's file.</summary>
    public static readonly IReadOnlyList<string> InFile = ["name", "NAME"];

    /// <summary>Names of values in the block that calls the program.</summary>
    public static readonly IReadOnlyList<string> InCall = ["program", .. InFile];

    /// <summary>Names of values in the program around the sections.</summary>
    public static readonly IReadOnlyList<string> InProgram = ["program", "body", .. InFile];

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

    /// <summary>The names of letters and digits in braces in a line. Without regular expressions, because every start reads a
    /// dialect.</summary>
    public static List<string> NamesIn(string line)
    {
        var names = new List<string>();
        for (var open = line.IndexOf('{'); open >= 0; open = line.IndexOf('{', open + 1))
        {
            var end = open + 1;
            while (end < line.Length && char.IsAsciiLetterOrDigit(line[end]))
            {
                end++;
            }

            if (end < line.Length && line[end] == '}' && end - open > 1)
            {
                names.Add(line[(open + 1)..end]);
            }
        }

        return names;
    }
}
