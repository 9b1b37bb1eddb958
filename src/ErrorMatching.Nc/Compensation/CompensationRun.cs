using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Follows the tool's center from motion to motion. Where an element ends is known only when the next one is.</summary>
internal sealed class CompensationRun
{
    /// <summary>Lengths up to this one are zero, mm.</summary>
    private const double Tiny = 1e-9;

    /// <summary>An arc that is tighter than the tool by up to this is as tight as it, mm.</summary>
    private const double SameRadius = 0.001;

    private const MotionFlags Sides = MotionFlags.CompensationLeft | MotionFlags.CompensationRight;

    private const MotionFlags Unfollowed = MotionFlags.UnsureMode | MotionFlags.UnknownWord | MotionFlags.BadArc
        | MotionFlags.Cycle | MotionFlags.MachineMove;

    private readonly NcPath _path;
    private readonly CompensationRule _rule;
    private readonly CompensationModes _modes;
    private readonly CenterTrace _trace;
    private readonly CompensationCorners _corners;
    private readonly CompensationLeads _leads;
    private readonly string _lead;

    // The tool's center is beside the programmed path by this much to the left; the element that led there is _last.
    private bool _isOn;
    private double _left;
    private OffsetElement _last;
    private int _frame;

    // The way in ends at right angles to an element that is not known yet.
    private bool _waitsForNext;

    // Compensation ended, and nothing moved since.
    private bool _isBeside;
    private Point3 _programmed;

    public CompensationRun(NcPath path, ToolRadii radii, List<CompensatedMotion>? motions, string lead = "")
    {
        (_path, _rule, _modes, _trace, _lead) = (path, path.Dialect.Compensation, new(path, radii, lead), new(motions), lead);
        (_corners, _leads) = (new(_rule, _modes, _trace), new(path, _modes, _trace, lead));
    }

    /// <summary>Follows the whole path.</summary>
    /// <returns>Where the control would stop, or what is not followed; null if it is followed to its end.</returns>
    public Refusal? Follow(CancellationToken cancellation)
    {
        Refusal? refusal = null;
        for (var i = 0; i < _path.Motions.Length && refusal is null; i++)
        {
            if ((i & 0xFFFF) == 0)
            {
                cancellation.ThrowIfCancellationRequested();
            }

            refusal = _modes.Advance(i, _isOn) ?? Step(_path.Motions[i], i);
        }

        refusal ??= _modes.Advance(_path.Motions.Length, _isOn) ?? (_isOn ? CheckLast(endsStraight: true) : null);
        _trace.Release();
        return refusal;
    }

    private Refusal? Step(in NcMotion motion, int index)
    {
        var refusal = motion.Has(Sides) ? Lead(motion, index) : _isOn ? Leave(motion, index) : GoAsProgrammed(motion, index);
        _programmed = motion.End;
        return refusal;
    }

    // Without compensation. After its end the tool goes from beside the contour to the programmed place.
    private Refusal? GoAsProgrammed(in NcMotion motion, int index)
    {
        var start = motion.Start;
        if (_isBeside && !motion.MovesInPlane && !motion.IsKnownInPlane)
        {
            // The program does not say where a departure ended.
            var end = motion.Plane.Lift(motion.Plane.Project(_trace.At), motion.Plane.Height(motion.End));
            var unknown = motion.UnknownEnd & ~motion.Plane.Axes();
            _trace.Release();
            _trace.Add(new(index, motion.Kind, motion.Plane, false, false, _trace.At, end, default, 0, unknown));
            return null;
        }

        if (_isBeside)
        {
            if (motion.IsArc)
            {
                return Refuse(motion, NcRefusalCodes.CompensationEntry, "cutter compensation ended, and it ends on a straight move only. "
                    + "Leave the contour straight.");
            }

            start += _trace.At - _programmed;
            _isBeside = false;
        }

        _trace.Release();
        _trace.Add(new(
            index, motion.Kind, motion.Plane, false, false, start, motion.End, motion.Center, motion.Turns, motion.UnknownEnd));
        return null;
    }

    private Refusal? Leave(in NcMotion motion, int index)
    {
        var isAround = false;
        var goesAround = _modes.StartsOtherwiseAround || _rule.Start == CompensationStart.NextNormalOrCorner;
        if (goesAround && motion is { IsArc: false, MovesInPlane: true, IsKnownInPlane: true })
        {
            var way = OffsetElement.Of(motion, index, _left);
            isAround = _corners.KindOf(_last, way, _left) == CornerKind.Outside;
            if (isAround && (_modes.StartsOtherwiseAround ? Around(motion) : Turn(way, motion)) is { } refusal)
            {
                return refusal;
            }
        }

        if (_path.IsInsertedCorner(index) || (_waitsForNext && _path.IsLead(_path.Motions[_last.Motion]))
            || (_rule.EndsInPlane && !motion.MovesInPlane))
        {
            return _leads.NotFollowed(motion);
        }

        (_isOn, _waitsForNext, _isBeside) = (false, false, true);
        return (isAround ? null : CheckLast(endsStraight: true))
            ?? (_leads.Depart(_last, index, _left) ? null : GoAsProgrammed(motion, index));
    }

    private Refusal? Lead(in NcMotion motion, int index)
    {
        var isMove = motion.IsCut || motion.Kind == MotionKind.Rapid || (!_isOn && _path.IsLead(motion));
        if (motion.IsTransformed || motion.Has(Unfollowed) || !isMove || !motion.IsKnownInPlane)
        {
            return Refuse(motion, NcRefusalCodes.CompensationUnfollowed, "the path of the tool's center is not followed here: cutter "
                + "compensation is on, and this move depends on something that the program does not say.");
        }

        if (motion.Plane == CoordinatePlane.YZ && !_rule.WorksInYz)
        {
            return Refuse(motion, NcRefusalCodes.CompensationStop, "the control has no cutter compensation in the plane YZ (G19).");
        }

        if (!_isOn)
        {
            return Enter(motion, index);
        }

        if (motion.Has(MotionFlags.StartsElsewhere) || motion.Frame != _frame)
        {
            return Refuse(motion, NcRefusalCodes.CompensationUnfollowed, "the origin changes while cutter compensation is on; the path of "
                + "the tool's center is not followed. Switch it off before.");
        }

        if (!motion.MovesInPlane)
        {
            Add(motion, index, motion.Plane.Project(_trace.At), motion.Center);
            return null;
        }

        var element = OffsetElement.Of(motion, index, _left);
        if (IsTooTight(element))
        {
            return TooTight(motion);
        }

        if (Turn(element, motion) is { } refusal)
        {
            return refusal;
        }

        if (element.IsArc && Math.Min(element.StartRadius, element.Radius) <= SameRadius && !_rule.ArcsExceedRadius)
        {
            // The tool's center stays where it is while the tool touches the whole arc.
            element = element with { Center = element.End, StartRadius = 0, Radius = 0 };
            Add(motion with { Kind = MotionKind.Line }, index, element.End, default);
        }
        else
        {
            Add(motion, index, element.End, element.Center);
        }

        _last = element;
        return null;
    }

    // The way in.
    private Refusal? Enter(in NcMotion motion, int index)
    {
        if (_modes.Find(motion, index, out var left) is { } unknown)
        {
            return unknown;
        }

        if (_rule.Start == CompensationStart.Unknown)
        {
            return Refuse(motion, NcRefusalCodes.CompensationUnfollowed, "how the control begins cutter compensation is not known to the "
                + "dialect, so that the path of the tool's center is not followed.");
        }

        var (start, radius) = (motion.Start, Math.Abs(left));
        start += _isBeside ? _trace.At - _programmed : Vector3.Zero;
        var (from, to) = (motion.Plane.Project(start), motion.PlaneEnd);
        if (_path.IsLead(motion) && from.DistanceTo(to) <= Tiny)
        {
            return _leads.NotFollowed(motion);
        }

        if (!motion.IsArc && from.DistanceTo(to) <= (_rule.StartExceedsRadius ? radius + Tiny : Tiny))
        {
            if (_rule.StartExceedsRadius && radius > 0)
            {
                return Refuse(motion, NcRefusalCodes.CompensationEntry, string.Create(
                    CultureInfo.InvariantCulture,
                    $"cutter compensation begins on a move of {from.DistanceTo(to):0.###} mm in the plane, which must be longer than the "
                        + $"tool radius of {radius:0.###} mm. Lengthen the way in."));
            }

            return GoAsProgrammed(motion, index);
        }

        (_left, _frame) = (left, motion.Frame);
        if (motion.IsArc)
        {
            if (EnterOnArc(motion, index, from, radius) is { } refusal)
            {
                return refusal;
            }
        }
        else
        {
            _last = OffsetElement.Straight(from, to, index, _left);
            _waitsForNext = _rule.Start != CompensationStart.OwnNormal;
        }

        _trace.Release();
        _trace.Begin(start);
        Add(motion, index, _last.End, _last.Center);
        (_isOn, _isBeside) = (true, false);
        return null;
    }

    // An arc that touches the contour's own arc at its end, and begins where the tool is.
    private Refusal? EnterOnArc(in NcMotion motion, int index, Point2 from, double radius)
    {
        if (!_rule.StartsOnArcs && radius > 0)
        {
            return Refuse(
                motion, NcRefusalCodes.CompensationEntry, "cutter compensation begins on a straight move only. Post a straight way in.");
        }

        _last = OffsetElement.Of(motion, index, _left);
        if (IsTooTight(_last))
        {
            return TooTight(motion);
        }

        if (radius > 0)
        {
            var (outwards, back) = ((_last.End - motion.Center).Normalize(), from - _last.End);
            var newRadius = -back.Dot(back) / (2 * back.Dot(outwards));
            var outside = _last.Radius > motion.Center.DistanceTo(motion.PlaneEnd);
            if (!(newRadius > (outside ? radius : 0)))
            {
                return Refuse(motion, NcRefusalCodes.CompensationEntry, "cutter compensation begins on an arc that is too tight for the "
                    + "tool. Post a larger one, or a straight way in.");
            }

            _last = _last with { Start = from, Center = _last.End - (outwards * newRadius), StartRadius = newRadius, Radius = newRadius };
        }

        return null;
    }

    // The two radii of an arc differ by the rounding of its words.
    private bool IsTooTight(in OffsetElement element) =>
        element.IsArc && Math.Min(element.StartRadius, element.Radius) <= (_rule.ArcsExceedRadius ? Tiny : -SameRadius);

    // Leads the tool's center from the last element to the next one.
    private Refusal? Turn(in OffsetElement next, in NcMotion motion)
    {
        if (_left == 0)
        {
            _trace.Release();
            return null;
        }

        var kind = _corners.KindOf(_last, next, _left);
        if (_waitsForNext)
        {
            _waitsForNext = false;
            if (_path.IsInsertedCorner(next.Motion))
            {
                return _leads.NotFollowed(motion);
            }

            if (_modes.StartsOtherwiseAround && kind == CornerKind.Outside)
            {
                return Around(motion);
            }

            if (_rule.Start == CompensationStart.NextNormal || kind != CornerKind.Outside)
            {
                _trace.MoveEnd(_last.ProgrammedEnd + (next.StartTangent.Left * _left));
                _leads.Approach(_last, next.StartTangent, _left);
                _trace.Release();
                return null;
            }
        }

        var corner = CompensationCorner.Intersection;
        if (kind == CornerKind.Inside)
        {
            if (_last.Meet(next) is not { } meeting)
            {
                return TooShort(_last.Motion);
            }

            _trace.MoveEnd(meeting);
        }
        else if (kind == CornerKind.Outside)
        {
            corner = _corners.GoOn(_last, next, _left);
        }

        if (CheckLast(endsStraight: kind != CornerKind.Straight && !next.IsArc) is { } refusal)
        {
            return refusal;
        }

        _trace.Release();
        _corners.Insert(corner, _last, next, _left, motion);
        _trace.Release();
        return null;
    }

    // The element must not run backwards between its two corners, nor much further than programmed.
    private Refusal? CheckLast(bool endsStraight)
    {
        var motion = _path.Motions[_last.Motion];
        var remaining = _last.Remaining(motion.Plane.Project(_trace.HeldStart), motion.Plane.Project(_trace.At));
        if (remaining < -Tiny)
        {
            return TooShort(_last.Motion);
        }

        var most = _rule.ArcGrowthRadians / (motion.Has(MotionFlags.Inch) ? NcControl.MmPerInch : 1);
        return _last.IsArc && endsStraight && remaining > _last.Sweep(_last.Start, _last.End) + most
            ? Refuse(
                motion,
                NcRefusalCodes.CompensationStop,
                "the control stops here: the contour turns slightly outwards before this arc, and under cutter compensation the arc gets "
                    + "too long. Make them tangent.")
            : null;
    }

    private void Add(in NcMotion motion, int index, Point2 end, Point2 center) => _trace.Add(new(
        index,
        motion.Kind,
        motion.Plane,
        false,
        true,
        _trace.At,
        motion.Plane.Lift(end, motion.Plane.Height(motion.End)),
        center,
        motion.Turns,
        motion.UnknownEnd));

    private Refusal Around(in NcMotion motion) => Refuse(motion, NcRefusalCodes.CompensationUnfollowed, "cutter compensation begins or "
        + "ends around a corner here, and the path of the tool's center is not followed there.");

    private Refusal TooTight(in NcMotion motion) => Refuse(motion, NcRefusalCodes.CompensationGouge, string.Create(
        CultureInfo.InvariantCulture,
        $"under cutter compensation the tool with a radius of {Math.Abs(_left):0.###} mm does not fit into this arc with a radius of "
            + $"{motion.Center.DistanceTo(motion.PlaneEnd):0.###} mm. Use a smaller tool, or a larger arc."));

    private Refusal TooShort(int index) => Refuse(_path.Motions[index], NcRefusalCodes.CompensationGouge, string.Create(
        CultureInfo.InvariantCulture,
        $"under cutter compensation the tool with a radius of {Math.Abs(_left):0.###} mm does not fit into an inside corner of this "
            + $"element, which is too short for it. Use a smaller tool, or leave the element out."));

    private Refusal Refuse(in NcMotion motion, string code, string message) =>
        BlockRefusal.At(_path.Program, motion.Block, code, _lead + message);
}
