using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>What all kinds of features share when they turn corrections at key points into a wish for each motion that cuts
/// them.</summary>
internal static class FeatureWish
{
    /// <summary>Sine of the largest angle between two lines of one polyline: 5.7 degrees, as in the program rewriter.</summary>
    private const double PolylineSine = 0.1;

    /// <summary>The wishes for a cut whose motions all follow one course.</summary>
    public static IEnumerable<ElementWish> Along(FeatureCut cut) =>
        FeaturePass.Moving(cut.Path, cut.Pass.First, cut.Pass.Last).Select(i => Element(cut.Path, cut.Pass, i, cut.Courses[0]));

    /// <summary>The wish for one motion of a pass that follows a course.</summary>
    public static ElementWish Element(NcPath path, FeaturePass pass, int index, Func<double, Vector2, Vector2> course)
    {
        var motion = path.Motions[index];
        var (from, to) = (pass.Starts[index - pass.First], pass.Starts[index - pass.First + 1]);
        return new(
            index,
            course(from, NormalAt(path, pass, index, -1)),
            course((from + to) / 2, motion.TangentAt(0.5).Left),
            course(to, NormalAt(path, pass, index, 1)));
    }

    // Where two lines of a polyline meet, both ends get one displacement, with the same component along either normal. Otherwise, tilting
    // lines would not meet where both should.
    private static Vector2 NormalAt(NcPath path, FeaturePass pass, int index, int step)
    {
        var motion = path.Motions[index];
        var tangent = motion.TangentAt(step > 0 ? 1 : 0);
        var next = index + step;
        while (next >= pass.First && next <= pass.Last && !path.Motions[next].MovesInPlane)
        {
            next += step;
        }

        if (motion.IsArc || next < pass.First || next > pass.Last || path.Motions[next].IsArc)
        {
            return tangent.Left;
        }

        var other = path.Motions[next].TangentAt(step > 0 ? 0 : 1);
        return Math.Abs(tangent.Cross(other)) < PolylineSine && tangent.Dot(other) > 0
            ? (tangent.Left + other.Left) / (1 + tangent.Dot(other))
            : tangent.Left;
    }
}
