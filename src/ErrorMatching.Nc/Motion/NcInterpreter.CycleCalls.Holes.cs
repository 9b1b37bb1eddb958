using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>
/// Siemens CYCLE81 to CYCLE89 and CYCLE840 as motions: rapid to the safety distance over the reference plane, to depth at feed (CYCLE83 in strokes), out as each cycle does, rapid to
/// the return plane.
/// </content>
public sealed partial class NcInterpreter
{
    /// <summary>Heights of one hole, mm along the tool axis.</summary>
    private readonly record struct CalledHole(double Return, double Reference, double Start, double Depth);

    // Null where it is not followed: heights that nobody stated, or arguments that change what the others mean.
    private CalledHole? HoleOf(CycleCall call)
    {
        if (IsFollowed(call) && call[0] * Unit is { } top && call[1] * Unit is { } reference && DepthOf(call) * Unit is { } depth)
        {
            var safety = Math.Abs(call[2] ?? 0) * Unit;
            return double.IsFinite(top + reference + depth + safety) ? new(top, reference, Sum(reference, depth < reference ? safety : -safety), depth) : null;
        }

        return null;
    }

    // Which arguments say no more than depth, feed, waits and spindle. Those behind are of later versions: geometry mode (of what the depth is), display mode (the plane), alternative mode (how arguments are read).
    private bool IsFollowed(CycleCall call) => call.Number switch
    {
        81 or 82 => HasUsualModes(call, 6),
        83 => IsToolAxis(call[12]) && call[11] is null or 0 or 1 && IsStated(call, 10, 14, 16) && IsAbsent(call, 17, int.MaxValue),
        84 => IsToolAxis(call[12]) && IsAbsent(call, 13, int.MaxValue),
        840 => IsToolAxis(call[11]) && IsAbsent(call, 12, int.MaxValue),
        85 => IsStated(call, 6, 7) && HasUsualModes(call, 8),
        86 => HasUsualModes(call, 11),
        87 => IsAbsent(call, 6, int.MaxValue),
        88 => IsAbsent(call, 7, int.MaxValue),
        89 => HasUsualModes(call, 6),
        _ => false,
    };

    // The third axis is the tool's, in whichever plane.
    private static bool IsToolAxis(double? axis) => axis is null or 0 or 3;

    private static bool IsStated(CycleCall call, params ReadOnlySpan<int> indexes)
    {
        foreach (var i in indexes)
        {
            if (call[i] is { } value && !double.IsFinite(value))
            {
                return false;
            }
        }

        return true;
    }

    private static bool IsAbsent(CycleCall call, int from, int to)
    {
        for (var i = from; i < Math.Min(to + 1L, call.Arguments.Count); i++)
        {
            if (call[i] is not (null or 0))
            {
                return false;
            }
        }

        return true;
    }

    // The alternative mode says which of both depths counts (ones: 1 below the reference plane, 2 the place) and what waits are counted in (tens).
    private bool HasUsualModes(CycleCall call, int geometry)
    {
        var plane = _state.Plane switch { CoordinatePlane.ZX => 2, CoordinatePlane.YZ => 3, _ => 1 };
        var alternative = call[geometry + 2] ?? 0;
        var counts = (alternative % 10) switch { 0 => true, 1 => call[4] is not null, 2 => call[3] is not null, _ => false };
        return counts && alternative is >= 0 and < 30 && call[geometry] is null or 0
            && (call[geometry + 1] is null or 0 || call[geometry + 1] == plane) && IsAbsent(call, geometry + 3, int.MaxValue);
    }

    // The depth is given as a place or below the reference plane; what two values mean that disagree hangs on the version of the cycle.
    private static double? DepthOf(CycleCall call) => DepthOf(call, 3);

    private static double? DepthOf(CycleCall call, int index)
    {
        var (place, reference, below) = (call[index], call[1], call[index + 1]);
        if (below is null or 0)
        {
            // Nothing below the reference plane is no hole: the place counts.
            return place;
        }

        // Without a place it lies where tools go: down.
        var depth = reference - Math.Abs(below.Value);
        return place is not { } stated || Math.Abs(stated - depth ?? 0) < 1e-9 ? depth : null;
    }

    private void RunHole(CycleCall call, CalledHole hole, IReadOnlyList<double> strokes)
    {
        var feed = _state.Feed;
        ToKnownHeight(MotionKind.Rapid, hole.Start);
        if (call.Number == 83)
        {
            DrillDeep(call, hole, strokes);
        }
        else
        {
            _state.Feed = FeedOr(call.Number == 85 ? call[6] : null, feed);
            ToKnownHeight(MotionKind.Line, hole.Depth);
        }

        if (call.Number is 84 or 840 or 85 or 89)
        {
            _state.Feed = FeedOr(call.Number == 85 ? call[7] : null, feed);
            ToKnownHeight(MotionKind.Line, hole.Start);
        }

        _state.Feed = feed;
        if (call.Number == 86)
        {
            LiftOff(call, hole);
        }

        ToKnownHeight(MotionKind.Rapid, hole.Return);
    }

    // A feed that only the machine knows is none that can be shown.
    private double FeedOr(double? stated, double feed) => stated is { } f && f > 0 ? f * (_state.InchFeed ? MmPerInch : 1) : feed;

    // CYCLE86: along up to three axes off the wall, up to the start, then back over the hole on the way to the return plane.
    private void LiftOff(CycleCall call, CalledHole hole)
    {
        var lift = new Vector2(call[7] ?? 0, call[8] ?? 0) * Unit;
        var up = (call[9] ?? 0) * Unit;
        if (lift == Vector2.Zero && up == 0)
        {
            return;
        }

        var plane = _state.Plane;
        var (over, unknown) = (plane.Project(_state.Position), _state.Unknown);
        var isUnknown = !double.IsFinite(lift.X + lift.Y + up);
        var (away, height) = isUnknown ? (over, hole.Depth) : (over + lift, Sum(hole.Depth, up));
        Append(MotionKind.Rapid, MotionFlags.Cycle, plane.Lift(away, height), isUnknown ? AxisSet.All : unknown);
        Append(MotionKind.Rapid, MotionFlags.Cycle, plane.Lift(away, hole.Start), isUnknown ? plane.Axes() : unknown);
        Append(MotionKind.Rapid, MotionFlags.Cycle, plane.Lift(over, hole.Return), unknown);
    }
}
