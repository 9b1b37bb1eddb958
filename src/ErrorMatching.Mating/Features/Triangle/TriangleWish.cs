using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Each flank of a triangle shifts and tilts on its own. Motions between the flanks connect them; an arc between them stays
/// tangent to both.</summary>
internal static class TriangleWish
{
    /// <summary>The two flanks, in the order of cutting.</summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="pass">The cut.</param>
    /// <param name="firstFlank">Number of its key points on the first flank.</param>
    public static IEnumerable<BoundaryElement> Flanks(NcPath path, FeaturePass pass, int firstFlank)
    {
        var inOrder = pass.Along(pass.Feet[0]) <= pass.Along(pass.Feet[firstFlank]);
        var (head, tail) = inOrder ? (..firstFlank, firstFlank..) : (firstFlank.., ..firstFlank);
        KeyPointFoot[] feet = [.. pass.Feet];
        int[] moving = [.. FeaturePass.Moving(path, pass.First, pass.Last)];
        var lastBefore = Array.IndexOf(moving, feet[head].Max(f => f.Motion));
        while (lastBefore < moving.Length - 1 && RunsOnStraight(path, moving[lastBefore], moving[lastBefore + 1]))
        {
            lastBefore++;
        }

        var firstBehind = Array.IndexOf(moving, feet[tail].Min(f => f.Motion));
        while (firstBehind > 0 && RunsOnStraight(path, moving[firstBehind - 1], moving[firstBehind]))
        {
            firstBehind--;
        }

        return [
            new(pass, pass.First, moving[lastBefore], ElementForm.Straight),
            new(pass, moving[firstBehind], pass.Last, ElementForm.Straight)];
    }

    /// <summary>The wishes for one cut, in the order of its motions.</summary>
    /// <param name="cut">The cut.</param>
    public static IEnumerable<ElementWish> For(FeatureCut cut)
    {
        var (path, pass, before, behind) = (cut.Path, cut.Pass, cut.Elements[0], cut.Elements[1]);
        foreach (var i in FeaturePass.Moving(path, pass.First, pass.Last))
        {
            yield return before.Contains(i) ? FeatureWish.Element(path, pass, i, cut.Courses[0])
                : behind.Contains(i) ? FeatureWish.Element(path, pass, i, cut.Courses[1])
                : Between(path, pass, i, before.ToMm, behind.FromMm, cut.Courses[0], cut.Courses[1]);
        }
    }

    // True if the next motion continues in the same direction: several blocks may cut one flank.
    private static bool RunsOnStraight(NcPath path, int motion, int next)
    {
        var (a, b) = (path.Motions[motion], path.Motions[next]);
        return !a.IsArc && !b.IsArc && Math.Abs(a.TangentAt(1).Cross(b.TangentAt(0))) < 0.001 && a.TangentAt(1).Dot(b.TangentAt(0)) > 0;
    }

    private static ElementWish Between(
        NcPath path,
        FeaturePass pass,
        int index,
        double from,
        double to,
        Func<double, Vector2, Vector2> before,
        Func<double, Vector2, Vector2> behind)
    {
        var element = FeatureWish.Element(path, pass, index, (s, normal) =>
        {
            var share = to > from ? (s - from) / (to - from) : 0.5;
            return (before(from, normal) * (1 - share)) + (behind(to, normal) * share);
        });
        return element with { IsFillet = path.Motions[index].IsArc };
    }
}
