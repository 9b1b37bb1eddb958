using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>How a block's words become motions.</content>
public sealed partial class NcInterpreter
{
    private void Move(MotionFlags flags)
    {
        if (_state.Cycle != NcMeaning.Unknown)
        {
            LoseCorner();
            Drill(flags);
            return;
        }

        flags |= _words.IsPolar ? MotionFlags.Transformed : MotionFlags.None;
        flags |= _state.Form == NcMeaning.ThreadCut ? MotionFlags.Cycle : MotionFlags.None;
        var kind = _probes ? MotionKind.Probe : _state.Mode;
        var (end, unknown) = Target();
        if (kind is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise)
        {
            Turn(kind, flags, end, unknown);
        }
        else
        {
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

        if (_words.IsPolar)
        {
            return PolarWordsTarget(_state.Position, _state.Unknown);
        }

        var at = _state.Position;
        var (given, unknown) = (_words.Present, _state.Unknown);
        var incremental = ((_state.Incremental ? LinearAxes : 0) & ~_words.Absolute) | _words.Incremental;
        var end = (given & LinearAxes) == 0 ? at : new(Axis('X', at.X, given, incremental), Axis('Y', at.Y, given, incremental), Axis('Z', at.Z, given, incremental));
        unknown &= ~AxesOf(given & ~incremental);
        return (end, _hasUnknownCode ? AxisSet.All : unknown | UnknownWords());
    }

    // LinuxCNC's @ and ^ are the polar coordinates of the end in the plane XY, or how much they grow; what is not said stays.
    private (Point3 End, AxisSet Unknown) PolarWordsTarget(Point3 at, AxisSet unknown)
    {
        var from = new Vector2(at.X, at.Y);
        var (distance, degrees) = (from.Length, Math.Atan2(from.Y, from.X) * 180 / Math.PI);
        var (grown, turned) = (_words.PolarDistance * (_state.Inch ? MmPerInch : 1), _words.PolarAngle);
        distance = _state.Incremental ? distance + (grown ?? 0) : grown ?? distance;
        degrees = _state.Incremental ? degrees + (turned ?? 0) : turned ?? degrees;
        var flat = AxisSet.X | AxisSet.Y;
        var isUnknown = double.IsNaN(distance) || double.IsNaN(degrees) || ((_state.Incremental || grown is null || turned is null) && (unknown & flat) != AxisSet.None);
        var (sin, cos) = Math.SinCos(degrees * Math.PI / 180);
        var z = _words.Has('Z') ? (_state.Incremental ? Sum(at.Z, Length('Z')) : Length('Z')) : at.Z;
        var unknownZ = _words.Has('Z') && !_state.Incremental ? AxisSet.None : unknown & AxisSet.Z;
        return isUnknown ? (new(at.X, at.Y, z), flat | unknownZ | UnknownWords()) : (new(distance * cos, distance * sin, z), unknownZ | UnknownWords());
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
}
