using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>How a block's words become motions.</content>
public sealed partial class NcInterpreter
{
    private void Move(MotionFlags flags, bool machineCoordinates)
    {
        if (_state.Cycle != NcMeaning.Unknown && !machineCoordinates)
        {
            LoseCorner();
            Drill(flags);
            return;
        }

        var kind = machineCoordinates ? MotionKind.Reference : _probes ? MotionKind.Probe : _state.Mode;
        var (end, unknown) = machineCoordinates ? MachineTarget() : Target();
        if (kind is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise)
        {
            Turn(kind, flags, end, unknown);
        }
        else
        {
            flags |= machineCoordinates ? MotionFlags.MachineMove : MotionFlags.None;
            flags |= SwitchCompensation(_state.Plane.Project(_state.Position) != _state.Plane.Project(end));
            Corner(kind, flags, end, unknown, null);
            Append(kind, flags, end, unknown);
        }

        KeepCorner(kind);
        if (kind == MotionKind.Probe)
        {
            _state.Unknown |= GivenAxes();
        }
    }

    // The first motion in the plane behind G41, G42 or G40 is the entry or the exit.
    private MotionFlags SwitchCompensation(bool movesInPlane)
    {
        if (!_state.CompensationSwitched || !movesInPlane)
        {
            return MotionFlags.None;
        }

        _state.CompensationSwitched = false;
        return MotionFlags.CompensationSwitches;
    }

    private (Point3 End, AxisSet Unknown) Target()
    {
        if ((_transforms & Transforms.Polar) != Transforms.None)
        {
            return PolarTarget();
        }

        var at = _state.Position;
        var (given, unknown) = (_words.Present, _state.Unknown);
        var incremental = ((_state.Incremental ? LinearAxes : 0) & ~_words.Absolute) | _words.Incremental;
        var end = (given & LinearAxes) == 0 ? at : new(Axis('X', at.X, given, incremental), Axis('Y', at.Y, given, incremental), Axis('Z', at.Z, given, incremental));
        unknown &= ~AxesOf(given & ~incremental);
        return (end, _hasUnknownCode ? AxisSet.All : unknown | UnknownWords());
    }

    private double Axis(char letter, double at, uint given, uint incremental)
    {
        var bit = BlockWords.Bit(letter);
        return (given & bit) == 0 ? at : (incremental & bit) != 0 ? Sum(at, Length(letter)) : Length(letter);
    }

    // The first axis of the plane is a radius about the origin, the second an angle.
    private (Point3 End, AxisSet Unknown) PolarTarget()
    {
        var plane = _state.Plane;
        var (first, second, third) = plane switch { CoordinatePlane.ZX => ('Z', 'X', 'Y'), CoordinatePlane.YZ => ('Y', 'Z', 'X'), _ => ('X', 'Y', 'Z') };
        var (at, height) = (plane.Project(_state.Position), plane.Height(_state.Position));
        var inPlane = _words.Has(first) || _words.Has(second);
        var radius = _words.Has(first) ? Length(first) : at.DistanceTo(Point2.Origin);
        var angle = _words.Has(second) ? Angle.FromDegrees(Degrees(second)) : (at - Point2.Origin).Direction;
        var end = inPlane ? Point2.Origin + (Vector2.FromDirection(angle) * radius) : at;
        var newHeight = _words.Has(third) ? (_state.Incremental ? Sum(height, Length(third)) : Length(third)) : height;
        var missing = inPlane && !(_words.Has(first) && _words.Has(second)) ? _state.Unknown & plane.Axes() : AxisSet.None;
        var unknown = (inPlane ? (missing != AxisSet.None || _state.Incremental ? plane.Axes() : AxisSet.None) : _state.Unknown & plane.Axes())
            | (_words.Has(third) && !_state.Incremental ? AxisSet.None : _state.Unknown & ~plane.Axes());
        return (plane.Lift(end, newHeight), unknown | UnknownWords());
    }

    // Machine coordinates say a place of the work only as far as the program itself has set the work offset.
    private (Point3 End, AxisSet Unknown) MachineTarget()
    {
        var (origin, unknownOrigin) = OriginOf(_workOffset);
        var (work, unknown) = Work(_state.Position, _state.Unknown);
        var given = GivenAxes();
        var shift = Shift;
        var machine = Given(work + origin + shift.Vector, incremental: false);
        var target = work + Only(given, machine - (work + origin + shift.Vector));

        // The length of the tool is the machine's; increments are none of machine coordinates.
        var notSaid = unknownOrigin | shift.Unknown | (_state.LengthOffset ? AxisSet.All & ~_state.Plane.Axes() : AxisSet.None) | (_state.Incremental ? AxisSet.All : AxisSet.None);
        var targetUnknown = (unknown & ~given) | (notSaid & given) | UnknownWords();
        var end = _inverse?.Apply(target) ?? target;
        return (Known(end, targetUnknown), targetUnknown);
    }

    // Coordinates that are not known keep what was last said.
    private Point3 Known(Point3 end, AxisSet unknown)
    {
        var at = _state.Position;
        return new((unknown & AxisSet.X) == AxisSet.None ? end.X : at.X, (unknown & AxisSet.Y) == AxisSet.None ? end.Y : at.Y, (unknown & AxisSet.Z) == AxisSet.None ? end.Z : at.Z);
    }

    // Over the point that the block names to a place that only the machine knows.
    private void ReturnToReference(MotionFlags flags)
    {
        LoseCorner();
        var named = GivenAxes();
        var (over, unknown) = Target();
        flags |= MotionFlags.MachineMove;
        if (_code == NcMeaning.ReferenceReturn && named != AxisSet.None && (over != _state.Position || unknown != _state.Unknown))
        {
            Append(MotionKind.Rapid, flags, over, unknown);
        }

        Append(MotionKind.Reference, flags, _state.Position, _state.Unknown | (named == AxisSet.None ? AxisSet.All : named));
    }
}
