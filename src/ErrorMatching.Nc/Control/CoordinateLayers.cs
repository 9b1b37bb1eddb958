using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Offsets and transformations as layers: machine = origin of the work offset + tool length + rotation of (work + shift); work =
/// transformations of programmed coordinates. Motions are in work coordinates. When a layer changes, the tool stays in place, and its
/// coordinates are recalculated as far as they are known.</summary>
/// <param name="control">The control whose coordinates they are.</param>
internal sealed class CoordinateLayers(NcControl control)
{
    private readonly List<NcFrame> _frames =
        [new(0, control.Dialect.FirstWorkOffset, 0, Vector3.Zero, AxisSet.All, null, Vector3.Zero, AxisSet.None, Vector3.Zero, false)];

    public WorkOffsets Offsets { get; } = new(control.Dialect);

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

    /// <summary>Stores the tool's current place (G28.1, G30.1).</summary>
    /// <param name="reference">The code that moves there.</param>
    public void StorePlace(int reference)
    {
        control.Result.DependOnPlace();
        Stored[reference] = MachinePlace();
    }

    /// <summary>The programmed end that brings the named axes to a machine position; the others stay.</summary>
    public (Point3 End, AxisSet Unknown) ToMachine(AxisSet named, Point3 machine, AxisSet unknownMachine)
    {
        var origin = Offsets.Origin;
        var (work, unknown) = Tool();
        var (way, unknownWay) = FromOrigin(origin, work, unknown);
        var wanted = machine - default(Point3) - origin.Place - Length.Vector;
        way += named.PartOf(wanted - way);
        unknownWay = (unknownWay & ~named) | ((unknownMachine | origin.Unknown | Length.UnknownIn(control.State)) & named);
        var moved = origin.Degrees != 0 && (named & (AxisSet.X | AxisSet.Y)) != AxisSet.None ? WorkOrigin.Mixed(named) : named;
        var target = work + moved.PartOf(WorkOrigin.Turned(way, -(origin.Degrees ?? 0)) - Shift.Vector - (work - default(Point3)));
        unknownWay |= Shift.Unknown | (origin.Degrees is null ? AxisSet.X | AxisSet.Y : AxisSet.None);
        var unknownEnd = (unknown & ~moved) | ((origin.Degrees == 0 ? unknownWay : WorkOrigin.Mixed(unknownWay)) & moved);
        return (Known(Programmed(target), unknownEnd), unknownEnd);
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
            control.Result.Problem("zero-scale", "A factor of zero makes all places one.", MotionFlags.None);
            work.Unknown = AxisSet.All;
        }

        SetTool(work.Place, work.Unknown);
        NextFrame();
    }

    /// <summary>A layer changed: later motions get another frame.</summary>
    public void NextFrame()
    {
        control.Run.ForgetMachine();
        control.State.Frame++;
        var (offset, origin, isTransformed) = (Offsets.Chosen, Offsets.Origin, Transforms.AreMoreThanShift);
        var programShift = isTransformed ? Vector3.Zero : Transforms.Frame?.ShiftOnly ?? Vector3.Zero;
        _frames.Add(new(control.Result.Block, offset.Code, offset.Number, origin.Place, origin.Unknown, origin.Degrees, Shift.Vector,
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
        control.Result.DependOnPlace();
    }

    private (Point3 Place, AxisSet Unknown) MachinePlace()
    {
        var origin = Offsets.Origin;
        var (work, unknown) = Tool();
        var (turned, unknownTurned) = FromOrigin(origin, work, unknown);
        return (default(Point3) + turned + origin.Place + Length.Vector,
            unknownTurned | origin.Unknown | Length.UnknownIn(control.State));
    }

    // From the origin of the work offset, along the machine's axes.
    private (Vector3 Way, AxisSet Unknown) FromOrigin(WorkOrigin origin, Point3 work, AxisSet unknown)
    {
        unknown |= Shift.Unknown;
        return (WorkOrigin.Turned(work - default(Point3) + Shift.Vector, origin.Degrees ?? 0),
            origin.Degrees is { } d ? (d == 0 ? unknown : WorkOrigin.Mixed(unknown)) : unknown | AxisSet.X | AxisSet.Y);
    }

    // Unknown coordinates keep their last value.
    private Point3 Known(Point3 end, AxisSet unknown)
    {
        var at = control.State.Position;
        return new((unknown & AxisSet.X) == AxisSet.None ? end.X : at.X, (unknown & AxisSet.Y) == AxisSet.None ? end.Y : at.Y,
            (unknown & AxisSet.Z) == AxisSet.None ? end.Z : at.Z);
    }
}
