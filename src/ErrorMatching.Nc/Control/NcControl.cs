using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>A control that executes a program: its modes and coordinates, the block that it executes, where it is in the program, and what
/// it has found so far. All classes that do a part of its work share this object.</summary>
internal sealed class NcControl
{
    public const double MmPerInch = 25.4;

    /// <summary>Modes and the tool's place: all that plain cuts depend on, so that two runs can be compared by it.</summary>
    public ModalState State;

    /// <summary>A control before the first block of a program.</summary>
    /// <param name="program">The program.</param>
    /// <param name="dialect">How the control reads it.</param>
    /// <param name="motions">Receives the motions.</param>
    /// <param name="library">Returns a called program by its name; null if no other program is known.</param>
    /// <param name="cancellation">Stops a long run.</param>
    public NcControl(
        NcProgram program, NcDialect dialect, NcMotions motions, Func<string, NcProgram?>? library, CancellationToken cancellation)
    {
        Dialect = dialect;
        State = ModalState.Initial with
        {
            RetractsToR = dialect.Ways.RetractsToR,
            InForce = dialect.Refusals.AtStart,
        };
        Result = new(dialect, motions);
        Values = new(this);
        Run = new(this, program, library, cancellation);
        Layers = new(this);
        Moves = new(this);
    }

    public NcDialect Dialect { get; }

    /// <summary>The words of the current block.</summary>
    public BlockWords Words { get; } = new();

    /// <summary>Their values under the active modes.</summary>
    public BlockValues Values { get; }

    /// <summary>What the codes of the current block do with its axis words.</summary>
    public BlockIntent Intent { get; } = new();

    /// <summary>Where the control is in the program.</summary>
    public ProgramRun Run { get; }

    /// <summary>What it has found so far.</summary>
    public RunResult Result { get; }

    /// <summary>Offsets and transformations between programmed and machine coordinates.</summary>
    public CoordinateLayers Layers { get; }

    /// <summary>Moves the tool.</summary>
    public ToolMoves Moves { get; }

    /// <summary>Value of the D word in force; null if there was none, NaN if only the machine knows it.</summary>
    public double? Offset { get; set; }

    /// <summary>Millimeters per programmed unit of length.</summary>
    public double Unit => State.Inch ? MmPerInch : 1;

    /// <summary>Decimals of the least increment.</summary>
    public int LeastDecimals => State.Inch ? Dialect.InchDecimals : Dialect.MetricDecimals;

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
    public MotionFlags TakeSwitch(bool movesInPlane)
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
        State.Unsure = Dialect.BlocksNameMotions ? Unsure.Plane | Unsure.Compensation : Unsure.All;
        State.Unknown = AxisSet.All;
        State.Cycle = NcMeaning.Unknown;
        State.InForce = RefusalTable.Open;
    }
}
