using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Moves to machine positions (G53, G28, G30): machine = origin of the work offset + tool length + rotation of (work + shift).
/// They are known as far as the program itself has set all of these.</summary>
internal sealed class MachineMoves(
    ControlState control,
    BlockValues values,
    CoordinateLayers layers,
    RunResult result,
    MotionWriter writer,
    BlockIntent intent,
    EndPoints ends,
    Corners corners)
{
    /// <summary>Stores the tool's current place (G28.1, G30.1).</summary>
    public void Store()
    {
        result.DependOnPlace();
        layers.Stored[intent.Reference] = MachinePlace();
    }

    /// <summary>G53. Increments are not machine positions. A cut stays a cut. A rapid to a place that only the machine knows has its own
    /// kind.</summary>
    public void Move(MotionFlags flags)
    {
        var named = values.GivenAxes();
        var (end, unknown) =
            ToMachine(named, values.Given(default, incremental: false), control.State.Incremental ? AxisSet.All
                : values.UnknownWords() | BlockWords.AxesOf(values.Words.Incremental));
        var kind = control.State.Mode == MotionKind.Line && values.Dialect.Syntax != NcSyntax.Iso ? MotionKind.Line
            : (unknown & named) == AxisSet.None ? MotionKind.Rapid
            : MotionKind.Reference;
        flags |= MotionFlags.MachineMove
            | control.SwitchCompensation(control.State.Plane.Project(control.State.Position) != control.State.Plane.Project(end));
        var isTurned = layers.Offsets.Origin.Degrees is not (null or 0) && (named & (AxisSet.X | AxisSet.Y)) != AxisSet.None;
        flags |= Carries(AxisSet.All & ~named) | (isTurned ? MotionFlags.Transformed : MotionFlags.None);
        corners.Cut(kind, flags, end, unknown, null);
        writer.Append(kind, flags, end, unknown);
        corners.Keep(kind);
    }

    /// <summary>G28, G30: through the point that the block names to the stored place, which only the machine knows unless the program
    /// itself stored it.</summary>
    public void Return(MotionFlags flags)
    {
        corners.Lose();
        var named = values.GivenAxes();
        var (over, unknown) = ends.Target();
        flags |= MotionFlags.MachineMove;
        if (intent.Code == NcMeaning.ReferenceReturn
            && (values.ListsIdleMoves || (named != AxisSet.None && (over != control.State.Position || unknown != control.State.Unknown))))
        {
            var incremental = ((control.State.Incremental ? BlockWords.LinearAxes : 0) & ~values.Words.Absolute) | values.Words.Incremental;
            writer.Append(MotionKind.Rapid, flags | Carries((AxisSet.All & ~named) | BlockWords.AxesOf(incremental)), over, unknown);
        }

        named = named == AxisSet.None ? AxisSet.All : named;
        flags |= Carries(AxisSet.All & ~named);
        if (!layers.Stored.TryGetValue(intent.Reference, out var stored))
        {
            writer.Append(MotionKind.Reference, flags, control.State.Position, control.State.Unknown | named);
            return;
        }

        // The named axes are work axes, even if the offset is rotated.
        var (there, unknownThere) = ToMachine(AxisSet.All, stored.Place, stored.Unknown);
        var end = control.State.Position + named.PartOf(there - control.State.Position);
        writer.Append((unknownThere & named) == AxisSet.None ? MotionKind.Rapid : MotionKind.Reference, flags, end,
            (control.State.Unknown & ~named) | (unknownThere & named));
    }

    /// <summary>Retracts along the tool axis to a place that is not known.</summary>
    public void Retract()
    {
        corners.Lose();
        var plane = control.State.Plane.Axes();
        writer.Append(MotionKind.Reference, MotionFlags.MachineMove | Carries(plane), control.State.Position,
            control.State.Unknown | (AxisSet.All & ~plane));
    }

    private static MotionFlags Carries(AxisSet axes) => (MotionFlags)((int)axes * (int)MotionFlags.CarriesX);

    private (Point3 Place, AxisSet Unknown) MachinePlace()
    {
        var origin = layers.Offsets.Origin;
        var (work, unknown) = layers.Tool();
        var (turned, unknownTurned) = FromOrigin(origin, work, unknown);
        return (default(Point3) + turned + origin.Place + layers.Length.Vector,
            unknownTurned | origin.Unknown | layers.Length.UnknownIn(control.State));
    }

    // From the origin of the work offset, along the machine's axes.
    private (Vector3 Way, AxisSet Unknown) FromOrigin(WorkOrigin origin, Point3 work, AxisSet unknown)
    {
        unknown |= layers.Shift.Unknown;
        return (WorkOrigin.Turned(work - default(Point3) + layers.Shift.Vector, origin.Degrees ?? 0),
            origin.Degrees is { } d ? (d == 0 ? unknown : WorkOrigin.Mixed(unknown)) : unknown | AxisSet.X | AxisSet.Y);
    }

    // The programmed end that brings the named axes to a machine position; the others stay.
    private (Point3 End, AxisSet Unknown) ToMachine(AxisSet named, Point3 machine, AxisSet unknownMachine)
    {
        var origin = layers.Offsets.Origin;
        var (work, unknown) = layers.Tool();
        var (way, unknownWay) = FromOrigin(origin, work, unknown);
        var wanted = machine - default(Point3) - origin.Place - layers.Length.Vector;
        way += named.PartOf(wanted - way);
        unknownWay = (unknownWay & ~named) | ((unknownMachine | origin.Unknown | layers.Length.UnknownIn(control.State)) & named);
        var moved = origin.Degrees != 0 && (named & (AxisSet.X | AxisSet.Y)) != AxisSet.None ? WorkOrigin.Mixed(named) : named;
        var target = work + moved.PartOf(WorkOrigin.Turned(way, -(origin.Degrees ?? 0)) - layers.Shift.Vector - (work - default(Point3)));
        unknownWay |= layers.Shift.Unknown | (origin.Degrees is null ? AxisSet.X | AxisSet.Y : AxisSet.None);
        var unknownEnd = (unknown & ~moved) | ((origin.Degrees == 0 ? unknownWay : WorkOrigin.Mixed(unknownWay)) & moved);
        return (Known(layers.Programmed(target), unknownEnd), unknownEnd);
    }

    // Unknown coordinates keep their last value.
    private Point3 Known(Point3 end, AxisSet unknown)
    {
        var at = control.State.Position;
        return new((unknown & AxisSet.X) == AxisSet.None ? end.X : at.X, (unknown & AxisSet.Y) == AxisSet.None ? end.Y : at.Y,
            (unknown & AxisSet.Z) == AxisSet.None ? end.Z : at.Z);
    }
}
