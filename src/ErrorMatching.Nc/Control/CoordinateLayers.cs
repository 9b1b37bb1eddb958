using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>
/// Offsets and transforms as layers: machine = origin of the work offset + tool length + rotation of (work + shift); work = transforms of
/// what is programmed.
/// Motions are in work coordinates. The tool stays where it is when a layer changes; what its coordinates are then follows as far as it is
/// known.
/// </summary>
/// <param name="control">Where the tool is, as programmed.</param>
/// <param name="result">Takes problems.</param>
/// <param name="run">Where variables are that a change of layers makes unknown.</param>
internal sealed class CoordinateLayers(ControlState control, RunResult result, ProgramRun run)
{
    private readonly List<NcFrame> _frames =
        [new(0, 540, 0, Vector3.Zero, AxisSet.All, null, Vector3.Zero, AxisSet.None, Vector3.Zero, false)];

    public WorkOffsets Offsets { get; } = new(turn: run.Dialect.Syntax == NcSyntax.LinuxCnc);

    public OriginShift Shift { get; } = new();

    public ToolLength Length { get; } = new();

    public ProgramTransforms Transforms { get; } = new();

    /// <summary>Places that the program has stored (G28.1, G30.1), by the code that goes there.</summary>
    public Dictionary<int, (Point3 Place, AxisSet Unknown)> Stored { get; } = [];

    /// <summary>The layers from each of their changes on.</summary>
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

    /// <summary>Where the tool is, in work coordinates.</summary>
    public (Point3 Place, AxisSet Unknown) Tool() => Work(control.State.Position, control.State.Unknown);

    /// <summary>What is programmed to reach a place of the work.</summary>
    public Point3 Programmed(Point3 work) => Transforms.Inverse?.Apply(work) ?? work;

    /// <summary>States where the tool is, in work coordinates.</summary>
    public void SetTool(Point3 work, AxisSet unknown)
    {
        control.State.Position = Programmed(work);
        control.State.Unknown = unknown == AxisSet.None || Transforms.Frame is not { KeepsAxes: false } ? unknown : AxisSet.All;
    }

    /// <summary>The coordinates of the place where the tool stands change by this much.</summary>
    public void MoveWork(Vector3 by, AxisSet unknown)
    {
        var (place, was) = Tool();
        SetTool(place + by, was | unknown);
    }

    /// <summary>The tool is seen from another origin.</summary>
    public void SeeFrom(WorkOrigin was, WorkOrigin now, AxisSet unknownDifference, Vector3 shift)
    {
        var (place, unknown) = Tool();
        (place, unknown) = WorkOrigin.Reseen(place, unknown, was, now, unknownDifference, shift, Shift.Unknown);
        SetTool(place, unknown);
    }

    /// <summary>Transforms have changed; the tool is where it was.</summary>
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

    /// <summary>A layer has changed: motions from here on name another frame.</summary>
    public void NextFrame()
    {
        run.ForgetMachine();
        control.State.Frame++;
        var (offset, origin, isTransformed) = (Offsets.Chosen, Offsets.Origin, Transforms.AreMoreThanShift);
        var programShift = isTransformed ? Vector3.Zero : Transforms.Frame?.ShiftOnly ?? Vector3.Zero;
        _frames.Add(new(result.Block, offset.Code, offset.Number, origin.Place, origin.Unknown, origin.Degrees, Shift.Vector,
            Shift.Unknown, programShift, isTransformed));
    }

    /// <summary>After a call or an unknown statement nothing is certain until it is stated again.</summary>
    public void Forget()
    {
        control.Forget();
        ForgetOrigins();
    }

    /// <summary>Whatever ran unseen could have written offsets and stored places, and chosen another offset.</summary>
    public void ForgetOrigins()
    {
        Offsets.Forget();
        Stored.Clear();
        Shift.Forget();
    }

    /// <summary>Offsets of the control could be anything from here on.</summary>
    public void LoseOrigin()
    {
        ForgetOrigins();
        NextFrame();
        control.State.Unknown = AxisSet.All;
        result.DependOnPlace();
    }
}
