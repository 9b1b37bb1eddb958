using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Offsets and transformations as layers: machine = origin of the work offset + tool length + rotation of (work + shift); work =
/// transformations of programmed coordinates. Motions are in work coordinates. When a layer changes, the tool stays in place, and its
/// coordinates are recalculated as far as they are known.</summary>
/// <param name="control">Holds the tool's programmed place.</param>
/// <param name="result">Receives problems.</param>
/// <param name="run">Holds the variables that a change of layers makes unknown.</param>
internal sealed class CoordinateLayers(ControlState control, RunResult result, ProgramRun run)
{
    private readonly List<NcFrame> _frames =
        [new(0, run.Dialect.FirstWorkOffset, 0, Vector3.Zero, AxisSet.All, null, Vector3.Zero, AxisSet.None, Vector3.Zero, false)];

    public WorkOffsets Offsets { get; } = new(run.Dialect);

    public OriginShift Shift { get; } = new();

    public ToolLength Length { get; } = new();

    public ProgramTransforms Transforms { get; } = new();

    /// <summary>Places that the program stored (G28.1, G30.1), by the code that moves there.</summary>
    public Dictionary<int, (Point3 Place, AxisSet Unknown)> Stored { get; } = [];

    /// <summary>The layers after each of their changes.</summary>
    public IReadOnlyList<NcFrame> Frames => _frames;

    /// <summary>The work coordinates of a programmed place.</summary>
    public (Point3 Place, AxisSet Unknown) Work(Point3 programmed, AxisSet unknown)
    {
        var frame = Transforms.Frame;
        if (frame is null)
        {
            return (programmed, unknown);
        }

        return (frame.Apply(programmed), unknown == AxisSet.None || frame.KeepsAxes ? unknown : AxisSet.All);
    }

    /// <summary>The tool's place in work coordinates.</summary>
    public (Point3 Place, AxisSet Unknown) Tool() => Work(control.State.Position, control.State.Unknown);

    /// <summary>The programmed coordinates of a place in work coordinates.</summary>
    public Point3 Programmed(Point3 work) => Transforms.Inverse?.Apply(work) ?? work;

    /// <summary>Sets the tool's place in work coordinates.</summary>
    public void SetTool(Point3 work, AxisSet unknown)
    {
        control.State.Position = Programmed(work);
        control.State.Unknown = unknown == AxisSet.None || Transforms.Frame is not { KeepsAxes: false } ? unknown : AxisSet.All;
    }

    /// <summary>Adds a vector to the coordinates of the tool's current place.</summary>
    public void MoveWork(Vector3 by, AxisSet unknown)
    {
        var (place, was) = Tool();
        SetTool(place + by, was | unknown);
    }

    /// <summary>Recalculates the tool's coordinates for another origin.</summary>
    public void SeeFrom(WorkOrigin was, WorkOrigin now, AxisSet unknownDifference, Vector3 shift)
    {
        var (place, unknown) = Tool();
        (place, unknown) = WorkOrigin.Reseen(place, unknown, was, now, unknownDifference, shift, Shift.Unknown);
        SetTool(place, unknown);
    }

    /// <summary>Applies changed transformations; the tool stays in place.</summary>
    public void Recompose((Point3 Place, AxisSet Unknown) work)
    {
        if (!Transforms.Compose())
        {
            result.Problem("zero-scale", "A factor of zero makes all places one.", MotionFlags.None);
            work.Unknown = AxisSet.All;
        }

        SetTool(work.Place, work.Unknown);
        NextFrame();
    }

    /// <summary>A layer changed: later motions get another frame.</summary>
    public void NextFrame()
    {
        run.ForgetMachine();
        control.State.Frame++;
        var (offset, origin, isTransformed) = (Offsets.Chosen, Offsets.Origin, Transforms.AreMoreThanShift);
        var programShift = isTransformed ? Vector3.Zero : Transforms.Frame?.ShiftOnly ?? Vector3.Zero;
        _frames.Add(new(result.Block, offset.Code, offset.Number, origin.Place, origin.Unknown, origin.Degrees, Shift.Vector,
            Shift.Unknown, programShift, isTransformed));
    }

    /// <summary>After a call or an unknown statement, nothing is certain until the program states it again.</summary>
    public void Forget()
    {
        control.Forget();
        ForgetOrigins();
        (Length.IsUnsure, Transforms.AreUnsure) = (true, true);
    }

    /// <summary>Anything that ran unseen could have written offsets and stored places, and selected another offset.</summary>
    public void ForgetOrigins()
    {
        Offsets.Forget();
        Stored.Clear();
        Shift.Forget();
    }

    /// <summary>From here on, the control's offsets are unknown.</summary>
    public void LoseOrigin()
    {
        ForgetOrigins();
        NextFrame();
        control.State.Unknown = AxisSet.All;
        result.DependOnPlace();
    }
}
