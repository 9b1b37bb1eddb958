using System.Collections;
using System.Runtime.CompilerServices;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The motions of a program in execution order, created from flat arrays on access.</summary>
public sealed partial class NcMotions : IReadOnlyList<NcMotion>
{
    private readonly Chunks<StoredMotion> _motions;
    private readonly MotionSettings _settings = new();
    private readonly MotionArcs _arcs;
    private readonly Dictionary<int, (Point3 Place, AxisSet Unknown)> _starts = [];
    private int _lastBlock = -1;
    private readonly NcMotions? _like;
    private NcMotions? _ahead;

    /// <summary>Creates an empty list.</summary>
    /// <param name="like">A list whose memory is shared for equal motions.</param>
    /// <param name="inPlace">True if motions can be taken over from it.</param>
    internal NcMotions(NcMotions? like = null, bool inPlace = false)
    {
        _like = like;
        _motions = new(like?._motions, inPlace);
        _arcs = new(like?._arcs, inPlace);
    }

    /// <summary>Number of motions.</summary>
    public int Length => _motions.Count;

    int IReadOnlyCollection<NcMotion>.Count => Length;

    /// <summary>True if no motion belongs to an earlier block than the motion before it: the program runs straight through.</summary>
    public bool FollowBlocks { get; private set; } = true;

    /// <summary>True if a straight cut ends where it begins, or did in the list from which motions were taken over.</summary>
    internal bool HasPoints { get; private set; }

    /// <summary>Number of motions that do not begin at the end of the one before.</summary>
    internal int Jumps => _starts.Count;

    /// <summary>The motion at a position, from 0.</summary>
    public NcMotion this[int index]
    {
        get
        {
            ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)index, (uint)Length, nameof(index));
            ref readonly var m = ref _motions[index];
            var setting = _settings[index];
            var arc = m.IsArc ? _arcs[index] : default;
            if (index > 0 && (m.Flags & MotionFlags.StartsElsewhere) == MotionFlags.None)
            {
                // The usual case: it begins at the end of the one before, and all coordinates are known.
                ref readonly var before = ref _motions[index - 1];
                if ((before.UnknownEnd | m.UnknownEnd) == AxisSet.None)
                {
                    return new(
                        m.Block,
                        m.Kind,
                        m.Plane,
                        m.Flags,
                        before.End,
                        m.End,
                        arc.Center,
                        arc.Turns,
                        setting.Feed,
                        setting.Frame,
                        AxisSet.None,
                        AxisSet.None)
                    {
                        IsVertical = arc.IsVertical,
                    };
                }
            }

            var (start, unknown) = StartOf(index, m.Flags);
            return new(
                m.Block,
                m.Kind,
                m.Plane,
                m.Flags,
                unknown.KnownPartOf(start),
                m.UnknownEnd.KnownPartOf(m.End),
                arc.Center,
                arc.Turns,
                setting.Feed,
                setting.Frame,
                unknown,
                m.UnknownEnd)
            {
                IsVertical = arc.IsVertical,
            };
        }
    }

    /// <summary>The block of a motion, without reading the rest.</summary>
    public int BlockOf(int index) => _motions[index].Block;

    /// <summary>End of a motion on a control that begins at the origin with all offsets zero: equal to <see cref="NcMotion.End"/> if the
    /// program determines it, a substitute if only the machine knows it.</summary>
    public Point3 AssumedEnd(int index) => _motions[index].End;

    /// <summary>True if a motion is an arc.</summary>
    internal bool IsArc(int index) => _motions[index].IsArc;

    /// <summary>The same as <see cref="NcMotion.IsVertical"/> of the motion.</summary>
    internal bool IsVertical(int index) => _motions[index].IsArc && _arcs[index].IsVertical;

    /// <summary>True if cutter compensation begins or ends with a motion.</summary>
    internal bool SwitchesCompensation(int index) => (_motions[index].Flags & MotionFlags.CompensationSwitches) != MotionFlags.None;

    /// <summary>End of a motion, without reading the rest. Unknown coordinates read as zero.</summary>
    internal Point3 EndOf(int index)
    {
        ref readonly var m = ref _motions[index];
        return m.UnknownEnd.KnownPartOf(m.End);
    }

    /// <summary>Start of a motion, without reading the rest. Unknown coordinates read as zero.</summary>
    internal Point3 StartOf(int index)
    {
        var (place, unknown) = StartOf(index, _motions[index].Flags);
        return unknown.KnownPartOf(place);
    }

    /// <summary>The same as <see cref="NcMotion.IsLeadArc"/> of the motion.</summary>
    internal bool IsLeadArc(int index) => _motions[index].IsArc && this[index].IsLeadArc;

    /// <summary>The place of a joint: where a motion begins, or where the last one ends.</summary>
    internal Point3 PlaceOf(int joint) => joint < Length ? StartOf(joint) : EndOf(joint - 1);

    /// <summary>True if a motion is a cut that moves in its plane and does not switch compensation, as all motions of a contour.</summary>
    internal bool IsContour(int index)
    {
        ref readonly var m = ref _motions[index];
        return m.Kind is MotionKind.Line or MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise
            && (m.Flags & MotionFlags.CompensationSwitches) == MotionFlags.None
            && MovesInPlane(index);
    }

    /// <summary>The same as <see cref="NcMotion.MovesInPlane"/> of the motion.</summary>
    internal bool MovesInPlane(int index)
    {
        ref readonly var m = ref _motions[index];
        if (m.Kind is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise)
        {
            return true;
        }

        if (m.Plane == CoordinatePlane.XY && index > 0 && (m.Flags & MotionFlags.StartsElsewhere) == MotionFlags.None)
        {
            ref readonly var before = ref _motions[index - 1];
            if ((before.UnknownEnd | m.UnknownEnd) == AxisSet.None)
            {
                return before.X != m.X || before.Y != m.Y;
            }
        }

        var (start, unknown) = StartOf(index, m.Flags);
        return m.Plane.Project(unknown.KnownPartOf(start)) != m.Plane.Project(m.UnknownEnd.KnownPartOf(m.End))
            || ((unknown ^ m.UnknownEnd) & m.Plane.Axes()) != AxisSet.None;
    }

    /// <summary>True if two motions have the same plane and frame, so that their places can be compared.</summary>
    internal bool IsComparable(int index, int other)
    {
        ref readonly var a = ref _motions[index];
        ref readonly var b = ref _motions[other];
        return a.Plane == b.Plane && (_settings.HaveOneFrame || _settings[index].Frame == _settings[other].Frame);
    }

    /// <summary>True if all values of a motion are bitwise equal in another list, apart from lines inserted before its block.</summary>
    internal bool SameAt(NcMotions other, int index, int linesBefore)
    {
        ref readonly var a = ref _motions[index];
        ref readonly var b = ref other._motions[index];
        if (!a.SameAs(b) || a.Block + linesBefore != b.Block || !_settings[index].SameAs(other._settings[index]))
        {
            return false;
        }

        if (a.IsArc && _arcs[index] != other._arcs[index])
        {
            return false;
        }

        return (a.Flags & MotionFlags.StartsElsewhere) != MotionFlags.None
            ? _starts[index] == other._starts[index]
            : index == 0 || _motions[index - 1].SameEnd(other._motions[index - 1]);
    }

    /// <summary>Enumerates all motions.</summary>
    public IEnumerator<NcMotion> GetEnumerator()
    {
        for (var i = 0; i < Length; i++)
        {
            yield return this[i];
        }
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    /// <summary>Skips straight cuts in the XY plane that have the modes of a given motion and do not end at a place. Returns the first
    /// motion, from a position on, that it cannot skip: a walk along a contour needs a closer look only there.</summary>
    internal int PassAhead(int from, int like, Point3 place, double tolerance)
    {
        ref readonly var model = ref _motions[like];
        while (from > 0 && from < Length && PassesBy(from, model) && Math.Abs(_motions[from].X - place.X) >= tolerance)
        {
            from++;
        }

        return from;
    }

    /// <summary>The same backwards, for cuts that do not begin at a place.</summary>
    internal int PassBack(int from, int like, Point3 place, double tolerance)
    {
        ref readonly var model = ref _motions[like];
        while (from > 0 && PassesBy(from, model) && Math.Abs(_motions[from - 1].X - place.X) >= tolerance)
        {
            from--;
        }

        return from;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool PassesBy(int index, in StoredMotion model)
    {
        ref readonly var m = ref _motions[index];
        ref readonly var before = ref _motions[index - 1];
        return _settings.HaveOneFrame
            && m.SameModes(model)
            && m.IsPlainCut
            && before.UnknownEnd == AxisSet.None
            && (before.X != m.X || before.Y != m.Y);
    }

    /// <summary>The motions that differ from those at the same position of another list of the same length, in order, by the rule of
    /// <see cref="SameAt"/>.</summary>
    /// <param name="other">The other list.</param>
    /// <param name="border">The first block before which the other has an inserted line.</param>
    internal List<int> DifferencesFrom(NcMotions other, int border)
    {
        // Motions in a memory piece that both lists share are equal, if none of them has separately stored values and no line was inserted.
        var mayPass = border == int.MaxValue && _starts.Count == 0 && other._starts.Count == 0 && _arcs.AreNone && other._arcs.AreNone
            && _settings.SameAs(other._settings);
        var different = new List<int>();
        for (var i = 0; i < Length; i++)
        {
            if (!SameAt(other, i, _motions[i].Block < border ? 0 : 1))
            {
                different.Add(i);
            }
            else if (mayPass)
            {
                // The end of one motion is the start of the next, so equality here covers the shared motions after it.
                i += Math.Max(0, _motions.SharedFrom(i, other._motions) - 1);
            }
        }

        return different;
    }

    /// <summary>Appends a motion. Unknown coordinates are stored as they would be on a control that begins at the origin.</summary>
    internal void Add(in NcMotion motion)
    {
        _settings.Add(motion.Feed, motion.Frame);
        if (motion.IsArc)
        {
            _arcs.Add(new(motion.Center, motion.Turns, motion.IsVertical));
        }
        else
        {
            _arcs.AddOther();
        }

        var index = Length;
        var flags = motion.Flags & ~MotionFlags.StartsElsewhere;
        var start = motion.Start;
        if ((start, motion.UnknownStart) != StartOf(index, flags))
        {
            flags |= MotionFlags.StartsElsewhere;
            _starts[index] = (start, motion.UnknownStart);
        }

        HasPoints |= motion.IsPoint;
        FollowBlocks &= motion.Block >= _lastBlock;
        _lastBlock = motion.Block;
        _motions.Add(new(motion.Block, motion.Kind, motion.Plane, flags, motion.End, motion.UnknownEnd));
    }

    /// <summary>Appends a straight move from the tool's current place.</summary>
    internal void AddStraight(int block, in ModalState state, MotionFlags flags, in Point3 end, AxisSet unknownEnd)
    {
        if (Length == 0 || (state.Unknown | unknownEnd) != AxisSet.None || !StartsAtLast(state.Position))
        {
            Add(new(
                block,
                state.Mode,
                state.StraightPlane,
                flags,
                state.Position,
                end,
                default,
                0,
                state.Feed,
                state.Frame,
                state.Unknown,
                unknownEnd));
            return;
        }

        HasPoints |= state.Mode == MotionKind.Line && state.Position.X == end.X && state.Position.Y == end.Y && state.Position.Z == end.Z;
        FollowBlocks &= block >= _lastBlock;
        _lastBlock = block;
        _settings.Add(state.Feed, state.Frame);
        _arcs.AddOther();
        _motions.Add(new(block, state.Mode, state.StraightPlane, flags, end, AxisSet.None));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool StartsAtLast(in Point3 place)
    {
        ref readonly var last = ref _motions[Length - 1];
        return last.X == place.X && last.Y == place.Y && last.Z == place.Z && last.UnknownEnd == AxisSet.None;
    }

    /// <summary>Moves the end of the last motion; the next begins there.</summary>
    internal void MoveLastEnd(Point3 end)
    {
        ref var last = ref _motions[Length - 1];
        (last.X, last.Y, last.Z) = (end.X, end.Y, end.Z);
    }

    private (Point3 Place, AxisSet Unknown) StartOf(int index, MotionFlags flags)
    {
        if ((flags & MotionFlags.StartsElsewhere) != MotionFlags.None)
        {
            return _starts[index];
        }

        if (index == 0)
        {
            return (default, AxisSet.All);
        }

        ref readonly var before = ref _motions[index - 1];
        return (before.End, before.UnknownEnd);
    }
}
