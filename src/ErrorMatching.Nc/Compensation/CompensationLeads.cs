using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Leads the tool's center to a contour, and away from it, over the points that a control computes for it.</summary>
/// <param name="path">The programmed path.</param>
/// <param name="modes">What its blocks say of it.</param>
/// <param name="trace">The tool's center.</param>
/// <param name="messageLead">Begins a message after the name of the block.</param>
internal sealed class CompensationLeads(NcPath path, CompensationModes modes, CenterTrace trace, string messageLead)
{
    /// <summary>Leads the way in, which is held back, over the point ahead of the contour, if its block names one.</summary>
    /// <param name="way">The way in.</param>
    /// <param name="tangent">Unit direction of the contour at its first point.</param>
    /// <param name="left">Distance of the tool's center to the left of the contour, mm.</param>
    public void Approach(in OffsetElement way, Vector2 tangent, double left)
    {
        if (AwayOf(way.Motion, -tangent, tangent, left) is { } away)
        {
            // The tool goes there as it went before.
            var isRapid = way.Motion > 0 && path.Motions[way.Motion - 1].Kind == MotionKind.Rapid;
            var first = way.ProgrammedEnd + (tangent.Left * left);
            trace.LeadOver(first + away, isRapid ? MotionKind.Rapid : MotionKind.Line);
        }
    }

    /// <summary>Leads the tool's center away from the contour, first in the plane and then to another height.</summary>
    /// <param name="last">The last element of the contour.</param>
    /// <param name="index">Position of the motion that leaves it.</param>
    /// <param name="left">Distance of the tool's center to the left of the contour, mm.</param>
    /// <returns>False if its block does not say how.</returns>
    public bool Depart(in OffsetElement last, int index, double left)
    {
        if (AwayOf(index, last.EndTangent, last.EndTangent, left) is not { } away)
        {
            return false;
        }

        var motion = path.Motions[index];
        var (plane, place) = (motion.Plane, motion.Plane.Project(trace.At) + away);
        var unknown = motion.UnknownEnd & ~plane.Axes();
        var (level, end) = (plane.Lift(place, plane.Height(trace.At)), plane.Lift(place, plane.Height(motion.End)));
        var isLevel = level == end && unknown == AxisSet.None;
        trace.Release();
        trace.Add(new(index, MotionKind.Line, plane, !isLevel, false, trace.At, level, default, 0, AxisSet.None));
        if (!isLevel)
        {
            trace.Add(new(index, MotionKind.Line, plane, false, false, level, end, default, 0, unknown));
        }

        return true;
    }

    /// <summary>Refuses a way in or out that the control rounds, that leaves the plane, or that leads nowhere.</summary>
    public Refusal NotFollowed(in NcMotion motion) => BlockRefusal.At(
        path.Program,
        motion.Block,
        NcRefusalCodes.CompensationUnfollowed,
        messageLead + "how the control leads the tool's center into cutter compensation, or out of it, is not followed here. Begin and end "
            + "it on a straight move in the plane, longer than the tool's radius, with no rounding or chamfer beside it.");

    // From the contour to the point ahead of it or behind it: the length that the block states, along or at right angles.
    private Vector2? AwayOf(int motion, Vector2 along, Vector2 tangent, double left)
    {
        if (modes.LeadOf(motion) is not { Length: > 0 } lead)
        {
            return null;
        }

        return lead.Meaning switch
        {
            NcMeaning.ApproachTangent or NcMeaning.DepartureTangent => along * lead.Length,
            NcMeaning.ApproachNormal or NcMeaning.DepartureNormal => tangent.Left * (left < 0 ? -lead.Length : lead.Length),
            _ => null,
        };
    }
}
