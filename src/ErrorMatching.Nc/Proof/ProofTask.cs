using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Input of a proof: two interpreted programs and the wish that led from one to the other.</summary>
internal sealed class ProofTask
{
    /// <summary>Places closer than this are the same, mm.</summary>
    public const double SamePlace = 1e-9;

    /// <summary>Allowed displacement of a vertex, in multiples of the largest wished displacement: a corner of 10 degrees needs
    /// 11.5.</summary>
    private const double FurthestCorner = 13;

    public ProofTask(NcPath before, NcPath after, DisplacementWish wish, double increment)
    {
        (Before, After, Wish, Increment) = (before, after, wish, increment);
        var largest = 0.0;
        foreach (var element in wish.Elements)
        {
            Elements.Add(element.Motion);
            largest = Math.Max(largest, Math.Max(element.Start.Length, element.End.Length));
        }

        foreach (var motion in wish.EndPoints)
        {
            EndPoints.Add(motion);
        }

        Reach = (FurthestCorner * largest) + (2 * increment);
    }

    public NcPath Before { get; }

    public NcPath After { get; }

    public DisplacementWish Wish { get; }

    /// <summary>Increment to which new coordinates were rounded, mm.</summary>
    public double Increment { get; }

    /// <summary>The named elements, in the order of their wishes.</summary>
    public MotionRuns Elements { get; } = new();

    /// <summary>The motions whose ends are named.</summary>
    public MotionRuns EndPoints { get; } = new();

    /// <summary>Allowed displacement of an end, mm.</summary>
    public double Reach { get; }

    /// <summary>Both coordinates of an end are rounded by up to half an increment.</summary>
    public double LineTolerance => (0.75 * Increment) + 1e-6;

    /// <summary>Arcs add the rounding of their center.</summary>
    public double ArcTolerance => (1.6 * Increment) + 1e-6;

    public static bool Same(Point3 a, Point3 b) => (a - b).Length < SamePlace;

    public static bool Same(Point2 a, Point2 b) => a.DistanceTo(b) < SamePlace;

    public static double Mismatch(in NcMotion motion) => ArcCenter.Mismatch(motion.PlaneStart, motion.PlaneEnd, motion.Center);

    /// <summary>How far the places of a motion are from a circle at most, mm.</summary>
    public static double Furthest(in NcMotion motion, Circle2 circle) =>
        Math.Max(motion.Arc.FurthestFrom(circle), Math.Abs(circle.SignedDistance(motion.PlaneEnd)));

    /// <summary>How far a motion moved in its plane at most, mm: how far an end went, or how far any place of an arc is from its old
    /// circle.</summary>
    public static double Moved(in NcMotion was, in NcMotion now)
    {
        var ends = Math.Max((now.PlaneStart - was.PlaneStart).Length, (now.PlaneEnd - was.PlaneEnd).Length);
        return was.IsArc && was.PlaneStart != was.Center && now.PlaneStart != now.Center
            ? Math.Max(ends, now.Arc.FurthestFrom(was.Arc.Circle))
            : ends;
    }

    /// <summary>The wished line of a named straight element; null for any other motion.</summary>
    public Line2? Flank(int motion) => Elements.IndexOf(motion) is >= 0 and var index && Before.Motions[motion] is { IsArc: false } m
        ? Line2.Through(m.PlaneStart + Wish.Elements[index].Start, m.PlaneEnd + Wish.Elements[index].End)
        : null;

    /// <summary>True for a cut of a contour: vertical arcs and some helices lead to contours.</summary>
    public bool IsCutInPlane(int motion) =>
        motion >= 0 && motion < Before.Motions.Length && Before.Motions[motion] is { IsCut: true, MovesInPlane: true, IsLeadArc: false };

    /// <summary>True for a named line that shrank to a point because a displaced corner cut it off. The elements on both sides are
    /// measured instead.</summary>
    public bool IsShrunk(int motion, in NcMotion was) => !After.Motions.MovesInPlane(motion) && Elements.Contains(motion)
        && was is { Kind: MotionKind.Line, MovesInPlane: true } && was.PlaneLength <= Reach;
}
