using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Collects the named and the changed motions of a proved result.</summary>
internal static class CertifiedMotions
{
    public static IReadOnlyList<CertifiedMotion> Of(ProofTask task, NcProof proof, int markerBlock)
    {
        var fillets = new FilletCheck(task, new(task.Before));
        var roles = proof.Neighbors.ToLookup(n => n.Line, n => n.Role);
        var (before, after) = (task.Before.Motions, task.After.Motions);
        var moved = new SortedDictionary<int, CertifiedMotion>();
        foreach (var element in task.Wish.Elements)
        {
            moved.Add(element.Motion, Named(task, fillets, element));
        }

        for (var i = 0; i < task.Wish.EndPoints.Count; i++)
        {
            var motion = task.Wish.EndPoints[i];
            moved.Add(motion, Measured(task, motion, CertifiedAs.Point) with { By = task.Wish.ByOf(i) });
        }

        foreach (var i in before.DifferencesFrom(after, markerBlock))
        {
            var (was, now) = (before[i], after[i]);
            if (!moved.ContainsKey(i)
                && !(ProofTask.Same(was.Start, now.Start) && ProofTask.Same(was.End, now.End) && ProofTask.Same(was.Center, now.Center)))
            {
                // A fillet whose lines hardly moved also slides; the judge builds it from them.
                moved.Add(i, Measured(task, i, fillets.Is(i) ? CertifiedAs.FollowedFillet : RoleOf(roles[was.Block + 1])));
            }
        }

        return [.. moved.Values];
    }

    private static CertifiedAs RoleOf(IEnumerable<NeighborRole> roles) => roles.FirstOrDefault(NeighborRole.Positioning) switch
    {
        NeighborRole.Slides => CertifiedAs.Slides,
        NeighborRole.Follows => CertifiedAs.Follows,
        NeighborRole.Fillet => CertifiedAs.FollowedFillet,
        _ => CertifiedAs.Positioning,
    };

    private static CertifiedMotion Named(ProofTask task, FilletCheck fillets, in ElementWish element)
    {
        var was = task.Before.Motions[element.Motion];
        var role = !was.IsArc
            ? task.IsShrunk(element.Motion, was) ? CertifiedAs.Shrunk : CertifiedAs.Line
            : fillets.Is(element.Motion) ? CertifiedAs.Fillet : CertifiedAs.Arc;
        return Measured(task, element.Motion, role) with
        {
            Element = element,
            Carrier = role switch
            {
                CertifiedAs.Line => OfLine(was, element),
                CertifiedAs.Arc => OfCircle(was, element),
                _ => null,
            },
        };
    }

    private static Carried OfLine(in NcMotion was, in ElementWish element)
    {
        var normal = was.TangentAt(0).Left;
        var (start, end) = (normal.Dot(element.Start), normal.Dot(element.End));
        return new((start + end) / 2, (end - start) / was.PlaneLength, Vector2.Zero, 0);
    }

    private static Carried? OfCircle(in NcMotion was, in ElementWish element) =>
        ElementCheck.WantedCircle(was, element) is { } circle
            ? new(0, 0, circle.Center - was.Center, circle.Radius - was.Arc.Radius)
            : null;

    private static CertifiedMotion Measured(ProofTask task, int motion, CertifiedAs role)
    {
        var (was, now) = (task.Before.Motions[motion], task.After.Motions[motion]);
        return new(
            motion,
            role,
            null,
            null,
            Vector3.Zero,
            now.Start - was.Start,
            was.IsArc ? now.Arc.Middle - was.Arc.Middle : null,
            now.End - was.End);
    }
}
