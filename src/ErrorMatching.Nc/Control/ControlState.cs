using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The control's state from block to block, and how codes change it.</summary>
/// <param name="dialect">The control.</param>
internal sealed class ControlState(NcDialect dialect)
{
    public const double MmPerInch = 25.4;

    /// <summary>Modes and the tool's place: all that plain cuts depend on, so that two runs can be compared by it.</summary>
    public ModalState State = ModalState.Initial with
    {
        RetractsToR = dialect.Syntax == NcSyntax.LinuxCnc,
        InForce = dialect.Refusals.AtStart,
    };

    /// <summary>Value of the D word in force; null if there was none, NaN if only the machine knows it.</summary>
    public double? Offset { get; set; }

    /// <summary>Millimeters per programmed unit of length.</summary>
    public double Unit => State.Inch ? MmPerInch : 1;

    /// <summary>Decimals of the least increment.</summary>
    public int LeastDecimals => State.Inch ? dialect.InchDecimals : dialect.MetricDecimals;

    public void Units(bool inch, bool feedsToo)
    {
        State.Inch = inch;
        State.InchFeed = feedsToo ? inch : State.InchFeed;
    }

    public void Mode(MotionKind kind)
    {
        State.Mode = kind;
        State.Form = NcMeaning.Unknown;
        State.Cycle = NcMeaning.Unknown;
        State.Unsure &= ~Unsure.Mode;
    }

    public void Plane(CoordinatePlane plane)
    {
        State.Plane = plane;
        State.WorksInXY |= plane == CoordinatePlane.XY;
        State.IsPlaneNew = plane != CoordinatePlane.XY;
        State.Unsure &= ~Unsure.Plane;
    }

    public void Distance(bool incremental)
    {
        State.Incremental = incremental;
        State.Unsure &= ~Unsure.Distance;
    }

    public void Compensate(MotionFlags side)
    {
        State.CompensationSwitched |= State.Compensation != side;
        State.Compensation = side;
        State.Unsure &= ~Unsure.Compensation;
    }

    /// <summary>The first motion in the plane after G41, G42 or G40 is the entry or the exit.</summary>
    public MotionFlags SwitchCompensation(bool movesInPlane)
    {
        if (!State.CompensationSwitched || !movesInPlane)
        {
            return MotionFlags.None;
        }

        State.CompensationSwitched = false;
        return MotionFlags.CompensationSwitches;
    }

    /// <summary>Marks modes as unsure until the program states them again.</summary>
    public void Forget()
    {
        State.Unsure = dialect.BlocksNameMotions ? Unsure.Plane | Unsure.Compensation : Unsure.All;
        State.Unknown = AxisSet.All;
        State.Cycle = NcMeaning.Unknown;
        State.InForce = RefusalTable.Open;
    }
}
