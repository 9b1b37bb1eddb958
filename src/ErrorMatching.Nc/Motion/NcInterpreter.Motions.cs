using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>How a block's words become a motion.</content>
public sealed partial class NcInterpreter
{
    private void AddMotion(NcBlock block, MotionFlags flags, bool machineCoordinates)
    {
        var kind = machineCoordinates ? MotionKind.Reference : _state.CycleActive ? MotionKind.Cycle : _state.Mode;
        var start = _state.Position;
        var (x, unknownX) = Coordinate('X', start.X, AxisSet.X, machineCoordinates);
        var (y, unknownY) = Coordinate('Y', start.Y, AxisSet.Y, machineCoordinates);
        var (z, unknownZ) = Coordinate('Z', start.Z, AxisSet.Z, machineCoordinates);
        var end = new Point3(x, y, z);
        var unknown = unknownX | unknownY | unknownZ | (kind == MotionKind.Cycle ? AxisSet.Z : AxisSet.None);
        flags |= ModeFlags();
        var (center, turns) = (default(Point2), 0);
        if (kind is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise)
        {
            (center, turns, var arcFlags) = Arc(block, kind, _state.Plane.Project(start), _state.Plane.Project(end));
            flags |= arcFlags;
        }

        if (_state.CompensationSwitched && _state.Plane.Project(start) != _state.Plane.Project(end))
        {
            flags |= MotionFlags.CompensationSwitches;
            _state.CompensationSwitched = false;
        }

        Append(new(block.Index, kind, _state.Plane, flags, start, end, center, turns, _state.Feed, _state.Frame, _state.Unknown, unknown));
        if (kind == MotionKind.Probe)
        {
            _state.Unknown |= GivenAxes();
        }
    }

    private (double Value, AxisSet Unknown) Coordinate(char letter, double start, AxisSet axis, bool machineCoordinates)
    {
        if ((_words.Computed & BlockWords.Bit(letter)) != 0 || (machineCoordinates && _words.Has(letter)))
        {
            return (start, axis);
        }

        if (!_words.Has(letter))
        {
            return (start, _state.Unknown & axis);
        }

        return _state.Incremental ? (Sum(start, Scaled(letter)), _state.Unknown & axis) : (Scaled(letter), AxisSet.None);
    }

    private MotionFlags ModeFlags()
    {
        return (_state.Inch ? MotionFlags.Inch : MotionFlags.None)
            | (_state.Incremental ? MotionFlags.Incremental : MotionFlags.None)
            | (_state.AbsoluteCenters ? MotionFlags.AbsoluteCenter : MotionFlags.None)
            | _state.Compensation
            | (_state.Transforms != 0 ? MotionFlags.Transformed : MotionFlags.None)
            | (_state.Unsure != Unsure.None ? MotionFlags.UnsureMode : MotionFlags.None);
    }

    private (Point2 Center, int Turns, MotionFlags Flags) Arc(NcBlock block, MotionKind kind, Point2 start, Point2 end)
    {
        var turns = _dialect.TurnsLetter != 0 && _words.Has((char)_dialect.TurnsLetter) ? (int)Math.Clamp(_words.Number((char)_dialect.TurnsLetter).Value - 1, 0, 100_000) : 0;
        var (first, second) = _state.Plane switch { CoordinatePlane.ZX => ('K', 'I'), CoordinatePlane.YZ => ('J', 'K'), _ => ('I', 'J') };
        var known = (_state.Unknown & _state.Plane.Axes()) == AxisSet.None;
        if (_words.Has('R'))
        {
            var counterClockwise = kind == MotionKind.ArcCounterClockwise;
            return ArcCenter.ByRadius(start, end, Scaled('R'), counterClockwise, _dialect.ArcMismatchMm) is { } center
                ? (center, turns, MotionFlags.ByRadius)
                : (start.Lerp(end, 0.5), turns, MotionFlags.ByRadius | (!known ? MotionFlags.None : BadArc(block, "no circle of this radius reaches from the start to the end")));
        }

        if (!_words.Has(first) && !_words.Has(second))
        {
            var computed = (_words.Computed & (BlockWords.Bit(first) | BlockWords.Bit(second) | BlockWords.Bit('R'))) != 0;
            return (start.Lerp(end, 0.5), turns, computed ? MotionFlags.BadArc : BadArc(block, $"the arc has neither R nor {first} and {second}"));
        }

        var toCenter = new Vector2(_words.Has(first) ? Scaled(first) : 0, _words.Has(second) ? Scaled(second) : 0);
        var middle = _state.AbsoluteCenters ? Point2.Origin + toCenter : start + toCenter;
        var radius = start.DistanceTo(middle);
        var tolerance = Math.Max(_dialect.ArcMismatchMm, _dialect.ArcMismatchOfRadius * radius);
        var mismatch = ArcCenter.Mismatch(start, end, middle);
        var bad = known && !(mismatch <= tolerance && radius > 0);
        return (middle, turns, bad ? BadArc(block, System.FormattableString.Invariant($"the radii at start and end differ by {mismatch:0.####} mm")) : MotionFlags.None);
    }

    private MotionFlags BadArc(NcBlock block, string why)
    {
        _problems.Add(new("bad-arc", block.Index, $"Not an arc: {why}."));
        return MotionFlags.BadArc;
    }
}
