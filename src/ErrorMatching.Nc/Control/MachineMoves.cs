using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Moves to machine positions (G53, G28, G30): machine = origin of the work offset + tool length + rotation of (work + shift).
/// They are known as far as the program itself has set all of these.</summary>
internal sealed class MachineMoves(NcControl control, Corners corners)
{
    /// <summary>G53. Increments are not machine positions. A cut stays a cut. A rapid to a place that only the machine knows has its own
    /// kind.</summary>
    public void Move(MotionFlags flags)
    {
        var named = control.Values.GivenAxes();
        var (end, unknown) =
            control.Layers.ToMachine(named, control.Values.Given(default, incremental: false), control.State.Incremental ? AxisSet.All
                : control.Values.UnknownWords() | BlockWords.AxesOf(control.Words.Incremental));
        var kind = control.State.Mode == MotionKind.Line && control.Dialect.Ways.CutsToMachinePlaces ? MotionKind.Line
            : (unknown & named) == AxisSet.None ? MotionKind.Rapid
            : MotionKind.Reference;
        flags |= MotionFlags.MachineMove
            | control.TakeSwitch(control.State.Plane.Project(control.State.Position) != control.State.Plane.Project(end));
        var isTurned = control.Layers.Offsets.Origin.Degrees is not (null or 0) && (named & (AxisSet.X | AxisSet.Y)) != AxisSet.None;
        flags |= Carries(AxisSet.All & ~named) | (isTurned ? MotionFlags.Transformed : MotionFlags.None);
        corners.Cut(kind, flags, end, unknown, null);
        control.Moves.Append(kind, flags, end, unknown);
        corners.Keep(kind);
    }

    /// <summary>G28, G30: through the point that the block names to the stored place, which only the machine knows unless the program
    /// itself stored it.</summary>
    public void Return(MotionFlags flags)
    {
        corners.Lose();
        var named = control.Values.GivenAxes();
        var (over, unknown) = control.Moves.Target();
        flags |= MotionFlags.MachineMove;
        var isElsewhere = over != control.State.Position || unknown != control.State.Unknown;
        if (control.Intent.Code == NcMeaning.ReferenceReturn
            && (control.Values.ListsIdleMoves || (named != AxisSet.None && isElsewhere)))
        {
            var incremental = BlockWords.AxesOf(control.Values.IncrementalLetters());
            control.Moves.Append(MotionKind.Rapid, flags | Carries((AxisSet.All & ~named) | incremental), over, unknown);
        }

        named = named == AxisSet.None ? AxisSet.All : named;
        flags |= Carries(AxisSet.All & ~named);
        if (!control.Layers.Stored.TryGetValue(control.Intent.Reference, out var stored))
        {
            control.Moves.Append(MotionKind.Reference, flags, control.State.Position, control.State.Unknown | named);
            return;
        }

        // The named axes are work axes, even if the offset is rotated.
        var (there, unknownThere) = control.Layers.ToMachine(AxisSet.All, stored.Place, stored.Unknown);
        var end = control.State.Position + named.PartOf(there - control.State.Position);
        control.Moves.Append((unknownThere & named) == AxisSet.None ? MotionKind.Rapid : MotionKind.Reference, flags, end,
            (control.State.Unknown & ~named) | (unknownThere & named));
    }

    /// <summary>Retracts along the tool axis to a place that is not known.</summary>
    public void Retract()
    {
        corners.Lose();
        var plane = control.State.Plane.Axes();
        control.Moves.Append(MotionKind.Reference, MotionFlags.MachineMove | Carries(plane), control.State.Position,
            control.State.Unknown | (AxisSet.All & ~plane));
    }

    private static MotionFlags Carries(AxisSet axes) => (MotionFlags)((int)axes * (int)MotionFlags.CarriesX);
}
