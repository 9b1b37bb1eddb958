using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>A slot as a pass cuts it, in the program's frame: arcs about two centers, and lines tangent to both.</summary>
/// <param name="One">Center of one of its ends.</param>
/// <param name="Other">Center of the other.</param>
/// <param name="PathRadius">Radius of the arcs of the tool's path.</param>
/// <param name="ToMaterial">Distance of the boundary beyond the path, seen from the center line: plus the tool radius if the material is
/// outside, minus it if inside, 0 under cutter compensation.</param>
internal sealed record CutSlot(Point2 One, Point2 Other, double PathRadius, double ToMaterial)
{
    private const double Same = 0.01;

    /// <summary>Half the width of the boundary.</summary>
    public double Radius => Math.Max(0, PathRadius + ToMaterial);

    private Vector2 Direction => (One - Other).Normalize();

    /// <summary>The slot of a pass, or the first motion that does not belong to one.</summary>
    public static (CutSlot? Slot, int Stranger) Of(NcPath path, FeaturePass pass, double toolDiameterMm)
    {
        int[] moving = [.. FeaturePass.Moving(path, pass.First, pass.Last)];
        int[] arcs = [.. moving.Where(m => path.Motions[m].IsArc)];
        if (arcs.Length == 0)
        {
            return (null, pass.First);
        }

        var first = path.Motions[arcs[0]];
        var second = Array.Find(arcs, m => path.Motions[m].Center.DistanceTo(first.Center) > Same);
        if (second == 0)
        {
            return (null, arcs[0]);
        }

        var isOutside = pass.Feet[0].MaterialIsLeft == (first.Kind == MotionKind.ArcClockwise);
        var aside = first.Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight) ? 0 : toolDiameterMm / 2;
        var slot = new CutSlot(first.Center, path.Motions[second].Center, first.Arc.Radius, isOutside ? aside : -aside);
        return Array.FindIndex(moving, m => !slot.Has(path.Motions[m], first.Kind)) is >= 0 and var stranger
            ? (null, moving[stranger])
            : (slot, -1);
    }

    /// <summary>The boundary point at a foot.</summary>
    public Point2 BoundaryAt(NcPath path, KeyPointFoot foot) =>
        path.Motions[foot.Motion].PlaneAt(foot.Fraction) - (foot.Normal * Math.Abs(ToMaterial));

    /// <summary>The wishes that change the boundary's slot; the path's slot widens by the same amount and has the same end
    /// centers.</summary>
    /// <param name="cut">The cut.</param>
    /// <param name="wanted">The boundary's slot; its first and second center match the centers here in either order.</param>
    public IEnumerable<ElementWish> Wishes(FeatureCut cut, MeasuredSlot wanted)
    {
        var isOne = wanted.FirstCenter.DistanceTo(One) < wanted.FirstCenter.DistanceTo(Other);
        var (one, other) = isOne ? (wanted.FirstCenter, wanted.SecondCenter) : (wanted.SecondCenter, wanted.FirstCenter);
        var to = new CutSlot(one, other, PathRadius + (wanted.Radius - Radius), ToMaterial);
        foreach (var i in FeaturePass.Moving(cut.Path, cut.Pass.First, cut.Pass.Last))
        {
            var motion = cut.Path.Motions[i];
            yield return new(i, Move(motion.PlaneStart, to), Move(motion.PlaneAt(0.5), to), Move(motion.PlaneEnd, to));
        }
    }

    // Points where flank and end touch stay tangent points. Other flank points move straight across, and end points along their ray, so
    // tangent lead-ins and lead-outs move only across their direction.
    private Vector2 Move(Point2 place, CutSlot to)
    {
        var (along, side) = ((place - Other).Dot(Direction), Math.Sign((place - Other).Cross(Direction)));
        var length = (One - Other).Dot(Direction);
        if (Math.Abs(along) <= Same || Math.Abs(along - length) <= Same)
        {
            return (Math.Abs(along) <= Same ? to.Other : to.One) - (to.Direction.Left * (side * to.PathRadius)) - place;
        }

        if (along > 0 && along < length)
        {
            var flank = new Line2(to.Other - (to.Direction.Left * (side * to.PathRadius)), to.Direction);
            return Direction.Left * (-flank.SignedDistance(place) / to.Direction.Dot(Direction));
        }

        var (from, end) = along < length / 2 ? (Other, to.Other) : (One, to.One);
        var (ray, shift) = ((place - from).Normalize(), end - from);
        var across = shift.Cross(ray);
        return ray * (
            shift.Dot(ray) + Math.Sqrt(Math.Max(0, (to.PathRadius * to.PathRadius) - (across * across))) - place.DistanceTo(from));
    }

    private bool Has(in NcMotion motion, MotionKind turn)
    {
        if (motion.IsArc)
        {
            return motion.Kind == turn && Math.Abs(motion.Arc.Radius - PathRadius) <= Same
                && Math.Min(motion.Center.DistanceTo(One), motion.Center.DistanceTo(Other)) <= Same;
        }

        var axis = new Line2(Other, One - Other);
        return Math.Abs(Math.Abs(axis.SignedDistance(motion.PlaneStart)) - PathRadius) <= Same
            && Math.Abs(Math.Abs(axis.SignedDistance(motion.PlaneEnd)) - PathRadius) <= Same
            && axis.SignedDistance(motion.PlaneStart) * axis.SignedDistance(motion.PlaneEnd) > 0;
    }
}
