namespace ErrorMatching.Nc;

/// <summary>Finds rounded corners: one or more arcs of one circle that join two straight cuts tangentially.</summary>
internal static class Fillet
{
    /// <summary>Sine of the largest angle at which an arc counts as tangent to a line: 2.9 degrees, far above the rounding of a program's
    /// coordinates.</summary>
    private const double TangentSine = 0.05;

    /// <summary>Allowed difference of the centers and radii of arcs of one fillet, mm.</summary>
    private const double SameCircle = 0.01;

    /// <summary>The first and last arc of a motion's fillet; null if it is not part of one.</summary>
    public static (int First, int Last)? Around(NcPath path, int motion)
    {
        var motions = path.Motions;
        var (first, last) = (motion, motion);
        if (!motions[motion].IsArc)
        {
            return null;
        }

        while (first > 0 && IsSameCircle(motions[first - 1], motions[motion]))
        {
            first--;
        }

        while (last + 1 < motions.Length && IsSameCircle(motions[last + 1], motions[motion]))
        {
            last++;
        }

        return first > 0
            && last + 1 < motions.Length
            && Joins(motions[first - 1], motions[first])
            && Joins(motions[last], motions[last + 1])
            ? (first, last)
            : null;
    }

    private static bool IsSameCircle(in NcMotion other, in NcMotion arc) =>
        other.Kind == arc.Kind
            && other.Plane == arc.Plane
            && other.Center.DistanceTo(arc.Center) < SameCircle
            && Math.Abs(other.Arc.Radius - arc.Arc.Radius) < SameCircle;

    private static bool Joins(in NcMotion before, in NcMotion behind)
    {
        var line = before.IsArc ? behind : before;
        if (line.Kind != MotionKind.Line || line.PlaneStart == line.PlaneEnd || before.Plane != behind.Plane)
        {
            return false;
        }

        var (a, b) = (before.TangentAt(1), behind.TangentAt(0));
        return Math.Abs(a.Cross(b)) < TangentSine && a.Dot(b) > 0;
    }
}
