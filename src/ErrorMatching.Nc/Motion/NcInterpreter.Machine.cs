using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>
/// Places of the machine: machine = origin of the work offset + tool length + rotation of (work + shift). They are known as far as the program itself has set all of these.
/// </content>
public sealed partial class NcInterpreter
{
    // Places that the program has stored (G28.1, G30.1), by the code that goes there.
    private readonly Dictionary<int, (Point3 Place, AxisSet Unknown)> _references = [];
    private int _reference;
    private Vector3 _toolLength;
    private bool _isToolLengthInInches;

    // A length from the tool table is the machine's affair. So is one that was stated in other units: LinuxCNC 2.9 keeps its number (measured with rs274).
    private AxisSet UnknownLength =>
        (_state.LengthOffset ? AxisSet.Z : AxisSet.None) | (_isToolLengthInInches != _state.Inch ? AxesAlong(_toolLength) : AxisSet.None);

    // G43.1: the tip is elsewhere from here on, by what the block says. What came from the table before is not known.
    private void SetToolLength()
    {
        var given = GivenAxes();
        var length = Given(default(Point3) + _toolLength, incremental: false) - default(Point3);
        ChangeToolLength(length, (UnknownLength & (given | AxesAlong(_toolLength))) | UnknownWords());
        _state.LengthOffset &= (given & AxisSet.Z) == AxisSet.None;
    }

    // G43: the program counts on the tip, whatever the table says.
    private void TakeLengthOfTable()
    {
        ChangeToolLength(Vector3.Zero, AxesAlong(_toolLength));
        _state.LengthOffset = true;
    }

    private void EndToolLength()
    {
        ChangeToolLength(Vector3.Zero, UnknownLength & AxesAlong(_toolLength));
        _state.LengthOffset = false;
    }

    private void ChangeToolLength(Vector3 to, AxisSet unknown)
    {
        if (to == _toolLength && unknown == AxisSet.None)
        {
            return;
        }

        var by = _toolLength - to;
        (_toolLength, _isToolLengthInInches) = (to, _state.Inch);
        var degrees = OriginOf(_workOffset).Degrees;
        MoveWork(WorkOrigin.Turned(by, -(degrees ?? 0)), degrees is null && (by.X != 0 || by.Y != 0) ? unknown | AxisSet.X | AxisSet.Y : degrees == 0 ? unknown : WorkOrigin.Mixed(unknown));
        NextFrame();
    }

    private static MotionFlags Carries(AxisSet axes) => (MotionFlags)((int)axes * (int)MotionFlags.CarriesX);

    private static AxisSet AxesAlong(Vector3 v) =>
        (v.X != 0 ? AxisSet.X : AxisSet.None) | (v.Y != 0 ? AxisSet.Y : AxisSet.None) | (v.Z != 0 ? AxisSet.Z : AxisSet.None);

    private void StoreReference()
    {
        DependOnPlace();
        _references[_reference] = MachinePlace();
    }

    private (Point3 Place, AxisSet Unknown) MachinePlace()
    {
        var origin = OriginOf(_workOffset);
        var (work, unknown) = Work(_state.Position, _state.Unknown);
        var (turned, unknownTurned) = FromOrigin(origin, work, unknown);
        return (default(Point3) + turned + origin.Place + _toolLength, unknownTurned | origin.Unknown | UnknownLength);
    }

    // From the origin of the work offset, along the machine's axes.
    private (Vector3 Way, AxisSet Unknown) FromOrigin(WorkOrigin origin, Point3 work, AxisSet unknown)
    {
        unknown |= _unknownShift;
        return (WorkOrigin.Turned(work - default(Point3) + _shift, origin.Degrees ?? 0), origin.Degrees is { } d ? (d == 0 ? unknown : WorkOrigin.Mixed(unknown)) : unknown | AxisSet.X | AxisSet.Y);
    }

    // What is programmed to bring the named axes to a place of the machine; the others stay.
    private (Point3 End, AxisSet Unknown) ToMachine(AxisSet named, Point3 machine, AxisSet unknownMachine)
    {
        var origin = OriginOf(_workOffset);
        var (work, unknown) = Work(_state.Position, _state.Unknown);
        var (way, unknownWay) = FromOrigin(origin, work, unknown);
        var wanted = machine - default(Point3) - origin.Place - _toolLength;
        way += Only(named, wanted - way);
        unknownWay = (unknownWay & ~named) | ((unknownMachine | origin.Unknown | UnknownLength) & named);
        var moved = origin.Degrees != 0 && (named & (AxisSet.X | AxisSet.Y)) != AxisSet.None ? WorkOrigin.Mixed(named) : named;
        var target = work + Only(moved, WorkOrigin.Turned(way, -(origin.Degrees ?? 0)) - _shift - (work - default(Point3)));
        unknownWay |= _unknownShift | (origin.Degrees is null ? AxisSet.X | AxisSet.Y : AxisSet.None);
        var unknownEnd = (unknown & ~moved) | ((origin.Degrees == 0 ? unknownWay : WorkOrigin.Mixed(unknownWay)) & moved);
        return (Known(_inverse?.Apply(target) ?? target, unknownEnd), unknownEnd);
    }

    // Coordinates that are not known keep what was last said.
    private Point3 Known(Point3 end, AxisSet unknown)
    {
        var at = _state.Position;
        return new((unknown & AxisSet.X) == AxisSet.None ? end.X : at.X, (unknown & AxisSet.Y) == AxisSet.None ? end.Y : at.Y, (unknown & AxisSet.Z) == AxisSet.None ? end.Z : at.Z);
    }

    // Increments are no places of the machine. A cut stays a cut. A rapid to a place that only the machine knows is a move of its own kind.
    private void MoveInMachine(MotionFlags flags)
    {
        var named = GivenAxes();
        var (end, unknown) = ToMachine(named, Given(default, incremental: false), _state.Incremental ? AxisSet.All : UnknownWords());
        var kind = _state.Mode == MotionKind.Line && _dialect.Syntax != NcSyntax.Iso ? MotionKind.Line
            : (unknown & named) == AxisSet.None ? MotionKind.Rapid
            : MotionKind.Reference;
        flags |= MotionFlags.MachineMove | SwitchCompensation(_state.Plane.Project(_state.Position) != _state.Plane.Project(end));
        var isTurned = OriginOf(_workOffset).Degrees is not (null or 0) && (named & (AxisSet.X | AxisSet.Y)) != AxisSet.None;
        flags |= Carries(AxisSet.All & ~named) | (isTurned ? MotionFlags.Transformed : MotionFlags.None);
        Corner(kind, flags, end, unknown, null);
        Append(kind, flags, end, unknown);
        KeepCorner(kind);
    }

    // Over the point that the block names to the stored place, which only the machine knows unless the program itself has stored it.
    private void ReturnToReference(MotionFlags flags)
    {
        LoseCorner();
        var named = GivenAxes();
        var (over, unknown) = Target();
        flags |= MotionFlags.MachineMove;
        if (_code == NcMeaning.ReferenceReturn && (ListsIdleMoves || (named != AxisSet.None && (over != _state.Position || unknown != _state.Unknown))))
        {
            var incremental = ((_state.Incremental ? LinearAxes : 0) & ~_words.Absolute) | _words.Incremental;
            Append(MotionKind.Rapid, flags | Carries((AxisSet.All & ~named) | AxesOf(incremental)), over, unknown);
        }

        named = named == AxisSet.None ? AxisSet.All : named;
        flags |= Carries(AxisSet.All & ~named);
        if (!_references.TryGetValue(_reference, out var stored))
        {
            Append(MotionKind.Reference, flags, _state.Position, _state.Unknown | named);
            return;
        }

        // The axes that are named are those of the work, however its offset is turned.
        var (there, unknownThere) = ToMachine(AxisSet.All, stored.Place, stored.Unknown);
        var end = _state.Position + Only(named, there - _state.Position);
        Append((unknownThere & named) == AxisSet.None ? MotionKind.Rapid : MotionKind.Reference, flags, end, (_state.Unknown & ~named) | (unknownThere & named));
    }
}
