using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Siemens CYCLE81 to CYCLE89 and CYCLE840 as motions: rapid to the safety distance above the reference plane, feed to depth
/// (CYCLE83 in strokes), retract as each cycle does, rapid to the return plane.</summary>
internal sealed class HoleCycles(NcControl control)
{
    /// <summary>The heights that a call states. Null if it is not followed: heights are missing, or arguments change the meaning of
    /// others.</summary>
    public CalledHole? HoleOf(CycleCall call)
    {
        if (IsFollowed(call) && call[0] * control.Unit is { } top && call[1] * control.Unit is { } reference
            && call.DepthOf(3) * control.Unit is { } depth)
        {
            var safety = Math.Abs(call[2] ?? 0) * control.Unit;
            return double.IsFinite(top + reference + depth + safety)
                ? new(top, reference, BlockValues.Sum(reference, depth < reference ? safety : -safety), depth) : null;
        }

        return null;
    }

    /// <summary>Depths below the reference plane at which the strokes end; null if no published source says what the cycle does.</summary>
    /// <remarks>
    /// CYCLE83: the first depth is FDEP or FDPR. Then each stroke is shorter by DAM until it is DAM. Strokes of DAM follow while more
    /// than twice DAM remains; two halves cover the rest. Without DAM, all strokes are as long as the first, and the last one ends at the
    /// depth (assumed). VARI=0 lifts at feed to break the chip; VARI=1 leaves the hole. Other cycles have one stroke.
    /// </remarks>
    public List<double>? StrokesOf(CycleCall call, CalledHole hole)
    {
        var total = Math.Abs(hole.Depth - hole.Reference);
        if (call.Number != 83)
        {
            return ++control.Run.Holes > ProgramRun.MostHoles ? null : [total];
        }

        var first = call.DepthOf(5) * control.Unit is { } depth ? (hole.Reference - depth) * (hole.Depth < hole.Reference ? 1 : -1)
            : double.NaN;
        var less = (call[7] ?? 0) * control.Unit;
        if (!(first > 0) || !(less >= 0) || (first < less && first < total))
        {
            return null;
        }

        var (strokes, at, stroke) = (new List<double>(), 0.0, first);
        while (control.Run.Holes++ < ProgramRun.MostHoles)
        {
            at = BlockValues.Sum(at, stroke);
            if (at >= total || stroke == 0)
            {
                // The rules do not cover a stroke longer than the remaining depth, except for the first stroke and if all are equal.
                return at == total || strokes.Count == 0 || less == 0 ? [.. strokes, total] : null;
            }

            strokes.Add(at);
            stroke = less == 0 ? stroke : Math.Max(BlockValues.Sum(stroke, -less), less);
            if (less > 0 && stroke == less && BlockValues.Sum(total, -at) <= BlockValues.Sum(less, less))
            {
                // The rule says that halves are always longer than half of the degression; it does not cover a shorter rest.
                return BlockValues.Sum(total, -at) > less ? [.. strokes, at + ((total - at) / 2), total] : null;
            }
        }

        return null;
    }

    /// <summary>Runs the call over the tool's current place.</summary>
    public void Run(CycleCall call, CalledHole hole, IReadOnlyList<double> strokes)
    {
        var feed = control.State.Feed;
        ToKnownHeight(MotionKind.Rapid, hole.Start);
        if (call.Number == 83)
        {
            DrillDeep(call, hole, strokes);
        }
        else
        {
            control.State.Feed = FeedOr(call.Number == 85 ? call[6] : null, feed);
            ToKnownHeight(MotionKind.Line, hole.Depth);
        }

        if (call.Number is 84 or 840 or 85 or 89)
        {
            control.State.Feed = FeedOr(call.Number == 85 ? call[7] : null, feed);
            ToKnownHeight(MotionKind.Line, hole.Start);
        }

        control.State.Feed = feed;
        if (call.Number == 86)
        {
            LiftOff(call, hole);
        }

        ToKnownHeight(MotionKind.Rapid, hole.Return);
    }

    // Calls whose arguments state only depth, feed, waits and spindle. Later arguments are from later versions: geometry mode (reference
    // of the depth), display mode (the plane), alternative mode (how arguments are read).
    private bool IsFollowed(CycleCall call) => call.Number switch
    {
        81 or 82 => HasUsualModes(call, 6),
        83 => IsToolAxis(call[12]) && call[11] is null or 0 or 1 && call.IsStated(10, 14, 16) && call.IsAbsent(17),
        84 => IsToolAxis(call[12]) && call.IsAbsent(13),
        840 => IsToolAxis(call[11]) && call.IsAbsent(12),
        85 => call.IsStated(6, 7) && HasUsualModes(call, 8),
        86 => HasUsualModes(call, 11),
        87 => call.IsAbsent(6),
        88 => call.IsAbsent(7),
        89 => HasUsualModes(call, 6),
        _ => false,
    };

    // The third axis is the tool axis, in every plane.
    private static bool IsToolAxis(double? axis) => axis is null or 0 or 3;

    // The alternative mode selects which of both depths applies (ones digit: 1 below the reference plane, 2 the position) and the unit of
    // waits (tens digit).
    private bool HasUsualModes(CycleCall call, int geometry)
    {
        var plane = control.State.Plane switch { CoordinatePlane.ZX => 2, CoordinatePlane.YZ => 3, _ => 1 };
        var alternative = call[geometry + 2] ?? 0;
        var counts = (alternative % 10) switch { 0 => true, 1 => call[4] is not null, 2 => call[3] is not null, _ => false };
        return counts && alternative is >= 0 and < 30 && call[geometry] is null or 0
            && (call[geometry + 1] is null or 0 || call[geometry + 1] == plane) && call.IsAbsent(geometry + 3);
    }

    private void DrillDeep(CycleCall call, CalledHole hole, IReadOnlyList<double> strokes)
    {
        var (down, feed, removes) = (hole.Depth < hole.Reference ? -1 : 1, control.State.Feed, call[11] == 1);
        var lift = LengthOr(call[14], 1);

        // Distance above the last depth at which a rapid ends: stated, or by the depth of the hole.
        var total = Math.Abs(hole.Depth - hole.Reference);
        var ahead = LengthOr(call[16], total <= 30 ? 0.6 : Math.Min(total / 50, 7));
        control.State.Feed = feed * (call[10] is > 0 and var factor ? factor : 1);
        for (var i = 0; i < strokes.Count; i++)
        {
            var depth = BlockValues.Sum(hole.Reference, down * strokes[i]);
            ToKnownHeight(MotionKind.Line, i == strokes.Count - 1 ? hole.Depth : depth);
            control.State.Feed = feed;
            if (i == strokes.Count - 1)
            {
                break;
            }

            if (removes)
            {
                ToKnownHeight(MotionKind.Rapid, hole.Start);
                ToKnownHeight(MotionKind.Rapid, BlockValues.Sum(depth, -down * ahead));
            }
            else
            {
                ToKnownHeight(MotionKind.Line, BlockValues.Sum(depth, -down * lift));
            }
        }
    }

    private void ToKnownHeight(MotionKind kind, double height)
    {
        var plane = control.State.Plane;
        var toolAxis = AxisSet.All & ~plane.Axes();
        if (plane.Height(control.State.Position) != height || (control.State.Unknown & toolAxis) != AxisSet.None)
        {
            control.Moves.Append(kind, MotionFlags.Cycle, plane.Lift(plane.Project(control.State.Position), height),
                control.State.Unknown & ~toolAxis);
        }
    }

    private double LengthOr(double? stated, double length) => stated is null or 0 ? length : Math.Abs(stated.Value) * control.Unit;

    // A feed that only the machine knows cannot be shown.
    private double FeedOr(double? stated, double feed) => stated is { } f && f > 0
        ? f * (control.State.InchFeed ? NcControl.MmPerInch : 1) : feed;

    // CYCLE86: lifts off the wall along up to three axes, retracts to the start, then moves back over the hole on the way to the return
    // plane.
    private void LiftOff(CycleCall call, CalledHole hole)
    {
        var lift = new Vector2(call[7] ?? 0, call[8] ?? 0) * control.Unit;
        var up = (call[9] ?? 0) * control.Unit;
        if (lift == Vector2.Zero && up == 0)
        {
            return;
        }

        var plane = control.State.Plane;
        var (over, unknown) = (plane.Project(control.State.Position), control.State.Unknown);
        var isUnknown = !double.IsFinite(lift.X + lift.Y + up);
        var (away, height) = isUnknown ? (over, hole.Depth) : (over + lift, BlockValues.Sum(hole.Depth, up));
        control.Moves.Append(MotionKind.Rapid, MotionFlags.Cycle, plane.Lift(away, height), isUnknown ? AxisSet.All : unknown);
        control.Moves.Append(MotionKind.Rapid, MotionFlags.Cycle, plane.Lift(away, hole.Start), isUnknown ? plane.Axes() : unknown);
        control.Moves.Append(MotionKind.Rapid, MotionFlags.Cycle, plane.Lift(over, hole.Return), unknown);
    }
}

/// <summary>Siemens patterns of holes: a row (HOLES1), a circle (HOLES2), a grid or frame (CYCLE801).</summary>
internal sealed class HolePatterns(NcControl control)
{
    /// <summary>The places of a call. Null if it is not a pattern, or if its places are unknown.</summary>
    public List<Point2>? PlacesOf(CycleCall call)
    {
        var places = call.Name switch
        {
            "HOLES1" when call.IsAbsent(6) && CountOf(call[5]) is { } count => Row(call, count),
            "HOLES2" when call.IsAbsent(6) && CountOf(call[5]) is { } count => Circle(call, count),
            "CYCLE801" when call.IsAbsent(8) && call[7] is null or 0 or 1 && CountOf(call[5] * call[6]) is not null => Grid(call),
            _ => null,
        };
        return places is not null && places.TrueForAll(p => double.IsFinite(p.X + p.Y)) ? places : null;
    }

    private int? CountOf(double? number)
    {
        if (number is not (>= 1 and <= ProgramRun.MostHoles)
            || number != Math.Floor(number.Value)
            || (control.Run.Holes += number.Value) > ProgramRun.MostHoles)
        {
            return null;
        }

        return (int)number;
    }

    // SPCA, SPCO (a point of the row), STA1 (angle to the first axis), FDIS (from there to the first hole), DBH (between holes), NUM. It
    // begins at the nearer end.
    private List<Point2>? Row(CycleCall call, int count)
    {
        var along = Vector2.FromDirection(Angle.FromDegrees(call[2] ?? 0));
        var places = new List<Point2>(count);
        for (var i = 0; i < count; i++)
        {
            places.Add(Place(call, along * ((call[3] ?? 0) + (i * (call[4] ?? 0)))));
        }

        var plane = control.State.Plane;
        var at = plane.Project(control.State.Position);
        var (first, last) = (at.DistanceTo(places[0]), at.DistanceTo(places[^1]));
        if (count > 1 && ((control.State.Unknown & plane.Axes()) != AxisSet.None || Math.Abs(first - last) < 1e-9))
        {
            return null;
        }

        if (last < first)
        {
            places.Reverse();
        }

        return places;
    }

    // CPA, CPO (center), RAD, STA1 (angle of the first hole), INDA (from hole to hole; 0 or omitted: full circle), NUM.
    private List<Point2> Circle(CycleCall call, int count)
    {
        var step = call[4] is null or 0 ? 360.0 / count : call[4]!.Value;
        var places = new List<Point2>(count);
        for (var i = 0; i < count; i++)
        {
            places.Add(Place(call, Vector2.FromDirection(Angle.FromDegrees((call[3] ?? 0) + (i * step))) * (call[2] ?? double.NaN)));
        }

        return places;
    }

    // SPCA, SPCO (a corner), STA (angle to the first axis), DIS1, DIS2 (between columns, rows), NUM1, NUM2 (columns, rows), VARI (1: the
    // border only). The control determines the order.
    private List<Point2>? Grid(CycleCall call)
    {
        if (CountOf(call[5]) is not { } columns || CountOf(call[6]) is not { } rows)
        {
            return null;
        }

        var along = Vector2.FromDirection(Angle.FromDegrees(call[2] ?? 0));
        var places = new List<Point2>();
        for (var row = 0; row < rows; row++)
        {
            for (var i = 0; i < columns; i++)
            {
                var column = row % 2 == 0 ? i : columns - 1 - i;
                if (call[7] is not 1 || row == 0 || row == rows - 1 || column == 0 || column == columns - 1)
                {
                    places.Add(Place(call, (along * (column * (call[3] ?? 0))) + (along.Left * (row * (call[4] ?? 0)))));
                }
            }
        }

        return places;
    }

    // As exact as sums of increments.
    private Point2 Place(CycleCall call, Vector2 from) =>
        new(
            BlockValues.Sum((call[0] ?? 0) * control.Unit, from.X * control.Unit),
            BlockValues.Sum((call[1] ?? 0) * control.Unit, from.Y * control.Unit));
}

/// <summary>Heights of one hole, mm along the tool axis.</summary>
/// <param name="Return">The return plane.</param>
/// <param name="Reference">The reference plane, origin of depths.</param>
/// <param name="Start">Where the feed begins: the safety distance above the reference plane.</param>
/// <param name="Depth">The bottom.</param>
internal readonly record struct CalledHole(double Return, double Reference, double Start, double Depth);
