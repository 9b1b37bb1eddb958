using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Applies the words of a block that concern cutter compensation, and records them for the path of the tool's center.</summary>
internal sealed class CompensationWords(ControlState control, BlockValues values, RunResult result)
{
    private bool IsOn => control.State.Compensation != MotionFlags.None;

    /// <summary>Reads the D word, which selects the tool's radius or gives its diameter.</summary>
    public void ReadOffset()
    {
        var isUnknown = (values.Words.Unknown & BlockWords.Bit('D')) != 0;
        if (!isUnknown && !values.Words.Has('D'))
        {
            // On LinuxCNC, D is for its own block only; without it, the tool in the spindle is meant.
            control.Offset = values.Dialect.Syntax == NcSyntax.LinuxCnc ? null : control.Offset;
            return;
        }

        control.Offset = isUnknown ? double.NaN : values.Words.Value('D');
        if (IsOn && !SwitchesOn())
        {
            Record(NcMeaning.Harmless, "D");
        }
    }

    /// <summary>Records a G code, in tenths, at which the control stops while compensation is on.</summary>
    public void StopAt(int tenths)
    {
        if (IsOn && values.Dialect.Compensation.StopCodes.Contains(tenths))
        {
            Record(NcMeaning.Unknown, string.Create(CultureInfo.InvariantCulture, $"G{tenths / 10m:0.#}"));
        }
    }

    /// <summary>Records an M function at which the control stops while compensation is on.</summary>
    public void StopAtFunction(int function)
    {
        if (IsOn && values.Dialect.Compensation.StopFunctions.Contains(function))
        {
            Record(NcMeaning.Unknown, string.Create(CultureInfo.InvariantCulture, $"M{function}"));
        }
    }

    /// <summary>Selects a plane. No control changes it while compensation is on.</summary>
    public void Plane(CoordinatePlane plane)
    {
        if (IsOn && control.State.Plane != plane)
        {
            Record(NcMeaning.Unknown, plane switch { CoordinatePlane.XY => "G17", CoordinatePlane.ZX => "G18", _ => "G19" });
        }

        control.Plane(plane);
    }

    /// <summary>Switches compensation, or how it goes around corners or begins.</summary>
    public void Apply(NcMeaning meaning)
    {
        Record(meaning, SideOf(meaning) switch
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
        foreach (var tenths in values.Words.Codes)
        {
            if (SideOf(values.Dialect.MeaningOf(tenths)) is not (null or MotionFlags.None))
            {
                return true;
            }
        }

        return false;
    }

    private void Record(NcMeaning meaning, string word) => result.SwitchCompensation(meaning, word, control.Offset, control.Unit);
}
