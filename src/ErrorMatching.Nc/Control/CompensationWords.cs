using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Applies the words of a block that concern cutter compensation, and records them for the path of the tool's center.</summary>
internal sealed class CompensationWords(NcControl control)
{
    private readonly CalledTool _tool = new(control);

    private bool IsOn => control.State.Compensation != MotionFlags.None;

    /// <summary>Reads the D word, which selects the tool's radius or gives its diameter.</summary>
    public void ReadOffset()
    {
        var isUnknown = (control.Words.Unknown & BlockWords.Bit('D')) != 0;
        if (!isUnknown && !control.Words.Has('D'))
        {
            // Where D is for its own block only, the tool in the spindle is meant without it.
            control.Offset = control.Dialect.Ways.OffsetsForOneBlock ? null : control.Offset;
            return;
        }

        control.Offset = isUnknown ? double.NaN : control.Words.Value('D');
        if (IsOn && !SwitchesOn())
        {
            Record(SwitchKind.OtherRadius, NcMeaning.Unknown, "D");
        }
    }

    /// <summary>Records a G code, in tenths, at which the control stops while compensation is on.</summary>
    public void StopAt(int tenths)
    {
        if (IsOn && control.Dialect.Compensation.StopCodes.Contains(tenths))
        {
            Record(SwitchKind.Stop, NcMeaning.Unknown, string.Create(CultureInfo.InvariantCulture, $"G{tenths / 10m:0.#}"));
        }
    }

    /// <summary>Records an M function at which the control stops while compensation is on.</summary>
    public void StopAtFunction(int function)
    {
        if (IsOn && control.Dialect.Compensation.StopFunctions.Contains(function))
        {
            Record(SwitchKind.Stop, NcMeaning.Unknown, string.Create(CultureInfo.InvariantCulture, $"M{function}"));
        }
    }

    /// <summary>Selects a plane. No control changes it while compensation is on.</summary>
    public void Plane(CoordinatePlane plane)
    {
        if (IsOn && control.State.Plane != plane)
        {
            Record(
                SwitchKind.Stop,
                NcMeaning.Unknown,
                plane switch { CoordinatePlane.XY => "G17", CoordinatePlane.ZX => "G18", _ => "G19" });
        }

        control.Plane(plane);
    }

    /// <summary>Switches compensation, or how it goes around corners or begins.</summary>
    /// <param name="meaning">What the word does.</param>
    /// <param name="word">The word; null for a G code.</param>
    public void Apply(NcMeaning meaning, string? word)
    {
        Record(SwitchKind.Switch, meaning, word ?? SideOf(meaning) switch
        {
            MotionFlags.CompensationLeft => "G41",
            MotionFlags.CompensationRight => "G42",
            _ => "G40",
        });
        if (SideOf(meaning) is { } side)
        {
            control.Compensate(side);
        }
    }

    /// <summary>Records how the block leads to a contour, or away from it.</summary>
    /// <param name="meaning">How.</param>
    /// <param name="word">The word.</param>
    public void Lead(NcMeaning meaning, string word)
    {
        var isKnown = control.Words.Has('L') && (control.Words.Unknown & BlockWords.Bit('L')) == 0;
        control.Result.Add(new CompensationSwitch(0, 0, SwitchKind.Switch, meaning, word)
        {
            Length = isKnown ? control.Words.Value('L') * control.Unit : double.NaN,
        });
    }

    /// <summary>Stores the radius that the program defines for a tool.</summary>
    /// <param name="definition">The keyword with all that follows it: TOOL DEF 5 L+10 R+5.</param>
    public void DefineTool(string definition) => _tool.Define(definition);

    /// <summary>Calls the block's tool.</summary>
    /// <param name="oversize">What the block adds to its radius, as programmed; null if it does not say.</param>
    public void CallTool(double? oversize)
    {
        if (_tool.Call(oversize) && IsOn)
        {
            Record(SwitchKind.Switch, NcMeaning.CompensationUnfollowed, "TOOL CALL");
        }
    }

    /// <summary>Records that the run goes to another file.</summary>
    public void ChangeFile()
    {
        if (IsOn && control.Dialect.Compensation.EndsAtCalls)
        {
            Record(SwitchKind.Switch, NcMeaning.CompensationUnfollowed, "A call of another program");
        }
    }

    // Null for a word that does not switch compensation.
    private static MotionFlags? SideOf(NcMeaning meaning) => meaning switch
    {
        NcMeaning.CompensationOff => MotionFlags.None,
        NcMeaning.CompensationLeft or NcMeaning.CompensationLeftByDiameter => MotionFlags.CompensationLeft,
        NcMeaning.CompensationRight or NcMeaning.CompensationRightByDiameter => MotionFlags.CompensationRight,
        _ => null,
    };

    private bool SwitchesOn()
    {
        foreach (var tenths in control.Words.Codes)
        {
            if (SideOf(control.Dialect.MeaningOf(tenths)) is not (null or MotionFlags.None))
            {
                return true;
            }
        }

        return false;
    }

    private void Record(SwitchKind kind, NcMeaning meaning, string word) => control.Result.Add(
        new CompensationSwitch(0, 0, kind, meaning, word)
        {
            Offset = control.Offset,
            Unit = control.Unit,
            Radius = _tool.Radius,
            Oversize = _tool.Oversize,
        });
}

/// <summary>What the program itself says of the radius of the tool that it called: a definition, and the oversize of the call.</summary>
internal sealed class CalledTool(NcControl control)
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
        var isOther = ((control.Words.Present | control.Words.Computed) & control.Values.ToolCalls) != 0;
        if (isOther)
        {
            var isKnown = control.Words.Has('T') && (control.Words.Unknown & BlockWords.Bit('T')) == 0;
            control.Offset = isKnown ? control.Words.Value('T') : double.NaN;
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
