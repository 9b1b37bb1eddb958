using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>How a block's words become a motion.</content>
public sealed partial class NcInterpreter
{
    private void AddMotion(NcBlock block, MotionFlags flags, bool machineCoordinates)
    {
        var kind = machineCoordinates ? MotionKind.Reference : state.CycleActive ? MotionKind.Cycle : state.Mode;
        var start = state.Position;
        var (x, unknownX) = Coordinate('X', start.X, AxisSet.X, machineCoordinates);
        var (y, unknownY) = Coordinate('Y', start.Y, AxisSet.Y, machineCoordinates);
        var (z, unknownZ) = Coordinate('Z', start.Z, AxisSet.Z, machineCoordinates);
        var end = new Point3(x, y, z);
        var unknown = unknownX | unknownY | unknownZ | (kind == MotionKind.Cycle ? AxisSet.Z : AxisSet.None);
        flags |= ModeFlags();
        var (center, turns) = (default(Point2), 0);
        if (kind is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise)
        {
            (center, turns, var arcFlags) = Arc(block, kind, state.Plane.Project(start), state.Plane.Project(end));
            flags |= arcFlags;
        }

        if (state.CompensationSwitched && state.Plane.Project(start) != state.Plane.Project(end))
        {
            flags |= MotionFlags.CompensationSwitches;
            state.CompensationSwitched = false;
        }

        Append(new(block.Index, kind, state.Plane, flags, start, end, center, turns, state.Feed, state.Frame, state.Unknown, unknown));
        if (kind == MotionKind.Probe)
        {
            state.Unknown |= GivenAxes();
        }
    }

    private (double Value, AxisSet Unknown) Coordinate(char letter, double start, AxisSet axis, bool machineCoordinates)
    {
        if ((words.Computed & BlockWords.Bit(letter)) != 0 || (machineCoordinates && words.Has(letter)))
        {
            return (start, axis);
        }

        if (!words.Has(letter))
        {
            return (start, state.Unknown & axis);
        }

        return state.Incremental ? (Sum(start, Scaled(letter)), state.Unknown & axis) : (Scaled(letter), AxisSet.None);
    }

    private MotionFlags ModeFlags()
    {
        return (state.Inch ? MotionFlags.Inch : MotionFlags.None)
            | (state.Incremental ? MotionFlags.Incremental : MotionFlags.None)
            | (state.AbsoluteCenters ? MotionFlags.AbsoluteCenter : MotionFlags.None)
            | state.Compensation
            | (state.Transforms != 0 ? MotionFlags.Transformed : MotionFlags.None)
            | (state.Unsure != Unsure.None ? MotionFlags.UnsureMode : MotionFlags.None);
    }

    private (Point2 Center, int Turns, MotionFlags Flags) Arc(NcBlock block, MotionKind kind, Point2 start, Point2 end)
    {
        var turns = dialect.TurnsLetter != 0 && words.Has((char)dialect.TurnsLetter) ? (int)Math.Clamp(words.Number((char)dialect.TurnsLetter).Value - 1, 0, 100_000) : 0;
        var (first, second) = state.Plane switch { CoordinatePlane.ZX => ('K', 'I'), CoordinatePlane.YZ => ('J', 'K'), _ => ('I', 'J') };
        var known = (state.Unknown & state.Plane.Axes()) == AxisSet.None;
        if (words.Has('R'))
        {
            var counterClockwise = kind == MotionKind.ArcCounterClockwise;
            return ArcCenter.ByRadius(start, end, Scaled('R'), counterClockwise, dialect.ArcMismatchMm) is { } center
                ? (center, turns, MotionFlags.ByRadius)
                : (start.Lerp(end, 0.5), turns, MotionFlags.ByRadius | (!known ? MotionFlags.None : BadArc(block, "no circle of this radius reaches from the start to the end")));
        }

        if (!words.Has(first) && !words.Has(second))
        {
            var computed = (words.Computed & (BlockWords.Bit(first) | BlockWords.Bit(second) | BlockWords.Bit('R'))) != 0;
            return (start.Lerp(end, 0.5), turns, computed ? MotionFlags.BadArc : BadArc(block, $"the arc has neither R nor {first} and {second}"));
        }

        var toCenter = new Vector2(words.Has(first) ? Scaled(first) : 0, words.Has(second) ? Scaled(second) : 0);
        var middle = state.AbsoluteCenters ? Point2.Origin + toCenter : start + toCenter;
        var radius = start.DistanceTo(middle);
        var tolerance = Math.Max(dialect.ArcMismatchMm, dialect.ArcMismatchOfRadius * radius);
        var mismatch = ArcCenter.Mismatch(start, end, middle);
        var bad = known && !(mismatch <= tolerance && radius > 0);
        return (middle, turns, bad ? BadArc(block, System.FormattableString.Invariant($"the radii at start and end differ by {mismatch:0.####} mm")) : MotionFlags.None);
    }

    private MotionFlags BadArc(NcBlock block, string why)
    {
        problems.Add(new("bad-arc", block.Index, $"Not an arc: {why}."));
        return MotionFlags.BadArc;
    }
}
