using System.Globalization;

namespace ErrorMatching.Nc;

/// <summary>What the program itself says of the radius of the tool that it called: a definition, and the oversize of the call.</summary>
internal sealed class CalledTool(ControlState control, BlockValues values)
{
    private readonly Dictionary<double, double> _defined = [];

    /// <summary>The radius that the program defines for the tool, mm; null if it does not, NaN if only the machine knows it.</summary>
    public double? Radius { get; private set; }

    /// <summary>What the call adds to the tool's radius, mm; NaN if only the machine knows it.</summary>
    public double Oversize { get; private set; }

    /// <summary>Stores the radius of a definition, which is one keyword with all that follows it.</summary>
    /// <param name="definition">The keyword: TOOL DEF 5 L+10 R+5.</param>
    public void Define(string definition)
    {
        var words = definition.ToUpperInvariant().Split(' ', StringSplitOptions.RemoveEmptyEntries);
        if (words.Length > 2 && Array.FindIndex(words, 3, w => w[0] == 'R') is > 0 and var at && Number(words[2]) is { } number)
        {
            _defined[number] = (Number(words[at][1..]) ?? double.NaN) * control.Unit;
        }
    }

    /// <summary>Calls the block's tool, or changes the oversize of the one that is there.</summary>
    /// <param name="oversize">What the block adds to the radius, as programmed; null if it does not say.</param>
    /// <returns>False if the radius stays as it was.</returns>
    public bool Call(double? oversize)
    {
        var isOther = ((values.Words.Present | values.Words.Computed) & values.ToolCalls) != 0;
        if (isOther)
        {
            var isKnown = values.Words.Has('T') && (values.Words.Unknown & BlockWords.Bit('T')) == 0;
            control.Offset = isKnown ? values.Words.Value('T') : double.NaN;
            Radius = _defined.TryGetValue(control.Offset.Value, out var radius) ? radius : null;
            (Oversize, oversize) = (0, oversize ?? 0);
        }

        // Whether a call for another speed keeps an oversize is not known.
        if (oversize is null && Oversize == 0)
        {
            return false;
        }

        Oversize = (oversize ?? double.NaN) * control.Unit;
        return true;
    }

    private static double? Number(string text) =>
        double.TryParse(text, NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint,
            CultureInfo.InvariantCulture, out var number) ? number : null;
}
