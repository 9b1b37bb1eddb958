using System.Collections;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The motions of a program in the order in which they are executed, made from flat arrays when they are looked at.</summary>
public sealed class NcMotions : IReadOnlyList<NcMotion>
{
    private readonly Chunks<StoredMotion> _motions;
    private readonly List<MotionSetting> _settings = [];
    private readonly Chunks<StoredArc> _arcs;
    private readonly Dictionary<int, (Point3 Place, AxisSet Unknown)> _starts = [];
    private int _lastBlock = -1;

    internal NcMotions(NcMotions? like = null)
    {
        _motions = new(like?._motions);
        _arcs = new(like?._arcs);
    }

    /// <summary>Number of motions.</summary>
    public int Length => _motions.Count;

    int IReadOnlyCollection<NcMotion>.Count => Length;

    /// <summary>True if no motion belongs to an earlier block than the one before it: the program runs straight through.</summary>
    public bool FollowBlocks { get; private set; } = true;

    /// <summary>True if a straight cut ends where it begins.</summary>
    internal bool HasPoints { get; private set; }

    /// <summary>The motion at a position, from 0.</summary>
    public NcMotion this[int index]
    {
        get
        {
            ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)index, (uint)Length, nameof(index));
            ref readonly var m = ref _motions[index];
            var (start, unknown) = StartOf(index, m.Flags);
            var setting = _settings[m.Setting];
            var arc = m.Arc < 0 ? default : _arcs[m.Arc];
            return new(m.Block, m.Kind, m.Plane, m.Flags, unknown.KnownPartOf(start), m.UnknownEnd.KnownPartOf(m.End), arc.Center, arc.Turns, setting.Feed, setting.Frame, unknown, m.UnknownEnd);
        }
    }

    /// <summary>The block of a motion, without the rest.</summary>
    public int BlockOf(int index) => _motions[index].Block;

    /// <summary>
    /// Where a motion ends on a control that begins at the origin with all offsets zero: the same as <see cref="NcMotion.End"/> where the program says it, a stand-in where only the machine knows.
    /// </summary>
    public Point3 AssumedEnd(int index) => _motions[index].End;

    /// <summary>Walks over all motions.</summary>
    public IEnumerator<NcMotion> GetEnumerator()
    {
        for (var i = 0; i < Length; i++)
        {
            yield return this[i];
        }
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    /// <summary>Appends a motion. Coordinates that are not known are kept as they would be on a control that begins at the origin.</summary>
    internal void Add(in NcMotion motion)
    {
        var setting = new MotionSetting(motion.Feed, motion.Frame);
        if (_settings.Count == 0 || _settings[^1] != setting)
        {
            _settings.Add(setting);
        }

        var arc = -1;
        if (motion.IsArc)
        {
            arc = _arcs.Count;
            _arcs.Add(new(motion.Center, motion.Turns));
        }

        var index = Length;
        var flags = motion.Flags & ~MotionFlags.StartsElsewhere;
        var start = motion.Start;
        if ((start, motion.UnknownStart) != StartOf(index, flags))
        {
            flags |= MotionFlags.StartsElsewhere;
            _starts[index] = (start, motion.UnknownStart);
        }

        HasPoints |= PathWithoutPoints.IsPoint(motion);
        FollowBlocks &= motion.Block >= _lastBlock;
        _lastBlock = motion.Block;
        _motions.Add(new(motion.Block, motion.Kind, motion.Plane, flags, motion.End, motion.UnknownEnd, _settings.Count - 1, arc));
    }

    /// <summary>Moves the end of the motion that was added last; what follows begins there.</summary>
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
