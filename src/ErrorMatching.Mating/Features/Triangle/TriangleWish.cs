using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Each flank of a triangle shifts and tilts on its own. Motions between the flanks connect them; an arc between them stays
/// tangent to both.</summary>
internal static class TriangleWish
{
    /// <summary>The wishes for one cut, in the order of its motions.</summary>
    /// <param name="cut">The cut.</param>
    /// <param name="firstFlank">Number of its key points on the first flank.</param>
    public static IEnumerable<ElementWish> For(FeatureCut cut, int firstFlank)
    {
        var (path, pass) = (cut.Path, cut.Pass);
        var inOrder = pass.Along(pass.Feet[0]) <= pass.Along(pass.Feet[firstFlank]);
        var (head, tail) = inOrder ? (..firstFlank, firstFlank..) : (firstFlank.., ..firstFlank);
        var before = Flank(cut, head);
        var behind = Flank(cut, tail);
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

        for (var i = 0; i < moving.Length; i++)
        {
            yield return i <= lastBefore ? FeatureWish.Element(path, pass, moving[i], before)
                : i >= firstBehind ? FeatureWish.Element(path, pass, moving[i], behind)
                : Between(path, pass, moving[i], moving[lastBefore], moving[firstBehind], before, behind);
        }
    }

    // True if the next motion continues in the same direction: several blocks may cut one flank.
    private static bool RunsOnStraight(NcPath path, int motion, int next)
    {
        var (a, b) = (path.Motions[motion], path.Motions[next]);
        return !a.IsArc && !b.IsArc && Math.Abs(a.TangentAt(1).Cross(b.TangentAt(0))) < 0.001 && a.TangentAt(1).Dot(b.TangentAt(0)) > 0;
    }

    private static Func<double, Vector2, Vector2> Flank(FeatureCut cut, Range which)
    {
        var flank = cut with { Pass = cut.Pass with { Feet = [.. cut.Pass.Feet.Take(which)] }, Corrections = cut.Corrections[which] };
        return FeatureWish.Course(flank, FeatureWish.Straight(flank));
    }

    private static ElementWish Between(
        NcPath path,
        FeaturePass pass,
        int index,
        int lastBefore,
        int firstBehind,
        Func<double, Vector2, Vector2> before,
        Func<double, Vector2, Vector2> behind)
    {
        var (from, to) = (pass.Starts[lastBefore + 1 - pass.First], pass.Starts[firstBehind - pass.First]);
        var element = FeatureWish.Element(path, pass, index, (s, normal) =>
        {
            var share = to > from ? (s - from) / (to - from) : 0.5;
            return (before(from, normal) * (1 - share)) + (behind(to, normal) * share);
        });
        return element with { IsFillet = path.Motions[index].IsArc };
    }
}
