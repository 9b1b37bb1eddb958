using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The motions of the tool's center. The last element, and what follows it outside its plane, are held back until the next element
/// shows where they end.</summary>
/// <param name="motions">Receives the motions; null if nobody reads them.</param>
internal sealed class CenterTrace(List<CompensatedMotion>? motions)
{
    private readonly List<CompensatedMotion> _held = [];

    /// <summary>Where the tool's center is, if nothing else moves the end of what is held back.</summary>
    public Point3 At { get; private set; }

    /// <summary>Axes of that place that the program does not determine.</summary>
    public AxisSet UnknownAt { get; private set; } = AxisSet.All;

    /// <summary>Start of the element that is held back.</summary>
    public Point3 HeldStart => _held[0].Start;

    /// <summary>Sets where the next motion starts.</summary>
    public void Begin(Point3 start) => At = start;

    /// <summary>Adds a motion after those held back.</summary>
    public void Add(in CompensatedMotion motion)
    {
        _held.Add(motion);
        (At, UnknownAt) = (motion.End, motion.UnknownEnd);
    }

    /// <summary>Moves the end in the plane of all that is held back.</summary>
    public void MoveEnd(Point2 end)
    {
        for (var i = 0; i < _held.Count; i++)
        {
            var (motion, plane) = (_held[i], _held[i].Plane);
            _held[i] = motion with
            {
                Start = i == 0 ? motion.Start : plane.Lift(end, plane.Height(motion.Start)),
                End = plane.Lift(end, plane.Height(motion.End)),
            };
            At = _held[i].End;
        }
    }

    /// <summary>Leads the first motion that is held back over another place: there in the plane, then to its height, then to its
    /// end.</summary>
    /// <param name="place">The place in the plane.</param>
    /// <param name="kind">How the tool moves there.</param>
    public void LeadOver(Point2 place, MotionKind kind)
    {
        var way = _held[0];
        var over = way with
        {
            Kind = kind,
            IsInserted = true,
            IsCompensated = false,
            End = way.Plane.Lift(place, way.Plane.Height(way.Start)),
        };
        var down = over with
        {
            Kind = MotionKind.Line,
            Start = over.End,
            End = way.Plane.Lift(place, way.Plane.Height(way.End)),
        };
        _held[0] = way with { Kind = MotionKind.Line, Start = down.End };
        _held.InsertRange(0, down.Start == down.End ? [over] : [over, down]);
    }

    /// <summary>Releases what is held back.</summary>
    public void Release()
    {
        motions?.AddRange(_held);
        _held.Clear();
    }
}
