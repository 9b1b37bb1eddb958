using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>
/// Turns the corrections at a feature's key points into a wish for each motion that cuts it: a line and a flank shift and tilt, a curve follows its
/// normal deviation along its length.
/// </summary>
internal static class FeatureWish
{
    /// <summary>Leave-one-out errors below half the usual least increment are all alike, mm.</summary>
    private const double Rounding = 0.0005;

    /// <summary>Sine of the angle up to which two lines count as pieces of one polyline: 5.7 degrees, as in the rewriting of the program.</summary>
    private const double PolylineSine = 0.1;

    /// <summary>The wishes for one pass, in the order of its motions.</summary>
    /// <param name="job">The job, for the frame, the direction and the gauge's uncertainty.</param>
    /// <param name="path">The program's path.</param>
    /// <param name="map">The feature on the program.</param>
    /// <param name="pass">One of its cuts.</param>
    /// <param name="decision">The corrections at its key points, in the order of the job.</param>
    public static IEnumerable<ElementWish> For(MatingJob job, NcPath path, FeatureMap map, FeaturePass pass, FeatureDecision decision)
    {
        var corrections = decision.Points.Select(p => job.Counterpart.Frame.Apply(p.Correction)).ToArray();
        return map.Feature switch
        {
            TriangleFeature triangle => Wedge(job, path, pass, corrections, triangle.FirstFlank.Count),
            CurveFeature curve => Along(path, pass, CurveCourse(job, path, pass, corrections, curve)),
            _ => Along(path, pass, Course(job, pass, corrections, null)),
        };
    }

    /// <summary>The normal deviation of a curve along its first pass, for the report.</summary>
    public static ArcLengthField NormalField(MatingJob job, FeaturePass pass, CurveFeature curve, IReadOnlyList<double> normals) =>
        ArcLengthField.Smooth([.. pass.Feet.Select(pass.Along)], normals, curve.Degree, curve.Ridge, job.Gauge.Uncertainty.CombinedMm);

    // An arc of the program can only follow as an arc. Only where that predicts its key points clearly worse than a smooth course does, the smooth course is taken and the arc comes as near as it can.
    private static Func<double, Vector2, Vector2> CurveCourse(MatingJob job, NcPath path, FeaturePass pass, Vector2[] corrections, CurveFeature curve)
    {
        if (job.Compensation.Along == CompensationDirection.Vector || CircleField.Of(path, pass, corrections) is not { } circle)
        {
            return Course(job, pass, corrections, curve);
        }

        var smooth = NormalField(job, pass, curve, [.. corrections.Select((c, i) => c.Dot(LeftOf(pass.Feet[i])))]);
        return double.IsPositiveInfinity(circle.LeaveOneOutRms) || circle.LeaveOneOutRms <= Math.Max(Rounding, smooth.Fit.LeaveOneOutRms ?? double.PositiveInfinity)
            ? circle.At
            : (s, normal) => normal * smooth.At(s);
    }

    // The displacement at a length, given the left normal there.
    private static Func<double, Vector2, Vector2> Course(MatingJob job, FeaturePass pass, Vector2[] corrections, CurveFeature? curve)
    {
        double[] along = [.. pass.Feet.Select(pass.Along)];
        if (job.Compensation.Along == CompensationDirection.Vector)
        {
            var (x, y) = (Fit(corrections.Select(c => c.X)), Fit(corrections.Select(c => c.Y)));
            return (s, _) => new(x.At(s), y.At(s));
        }

        var left = Fit(corrections.Select((c, i) => c.Dot(LeftOf(pass.Feet[i]))));
        return (s, normal) => normal * left.At(s);

        ArcLengthField Fit(IEnumerable<double> values) => curve is null
            ? ArcLengthField.Straight(along, [.. values], job.Gauge.Uncertainty.CombinedMm)
            : ArcLengthField.Smooth(along, [.. values], curve.Degree, curve.Ridge, job.Gauge.Uncertainty.CombinedMm);
    }

    private static Vector2 LeftOf(KeyPointFoot foot) => foot.MaterialIsLeft ? -foot.Normal : foot.Normal;

    private static IEnumerable<ElementWish> Along(NcPath path, FeaturePass pass, Func<double, Vector2, Vector2> course)
    {
        foreach (var i in FeaturePass.Moving(path, pass.First, pass.Last))
        {
            yield return Element(path, pass, i, course);
        }
    }

    private static ElementWish Element(NcPath path, FeaturePass pass, int index, Func<double, Vector2, Vector2> course)
    {
        var motion = path.Motions[index];
        var (from, to) = (pass.Starts[index - pass.First], pass.Starts[index - pass.First + 1]);
        return new(index, course(from, NormalAt(path, pass, index, -1)), course((from + to) / 2, motion.TangentAt(0.5).Left), course(to, NormalAt(path, pass, index, 1)));
    }

    // Where two lines of a polyline run into each other both ends get one displacement, of the same component along either normal: else lines that tilt would meet beside the place that each of them wants.
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
        return Math.Abs(tangent.Cross(other)) < PolylineSine && tangent.Dot(other) > 0 ? (tangent.Left + other.Left) / (1 + tangent.Dot(other)) : tangent.Left;
    }

    // Each flank has its own shift and tilt; what lies between them leads from the one to the other and, where it is an arc, stays tangent to both.
    private static IEnumerable<ElementWish> Wedge(MatingJob job, NcPath path, FeaturePass pass, Vector2[] corrections, int firstFlank)
    {
        var inOrder = pass.Along(pass.Feet[0]) <= pass.Along(pass.Feet[firstFlank]);
        var (head, tail) = inOrder ? (..firstFlank, firstFlank..) : (firstFlank.., ..firstFlank);
        var before = Flank(job, pass, corrections, head);
        var behind = Flank(job, pass, corrections, tail);
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
            yield return i <= lastBefore ? Element(path, pass, moving[i], before)
                : i >= firstBehind ? Element(path, pass, moving[i], behind)
                : Between(path, pass, moving[i], moving[lastBefore], moving[firstBehind], before, behind);
        }
    }

    // True if a next motion goes on in the same direction: a flank may be cut by several blocks.
    private static bool RunsOnStraight(NcPath path, int motion, int next)
    {
        var (a, b) = (path.Motions[motion], path.Motions[next]);
        return !a.IsArc && !b.IsArc && Math.Abs(a.TangentAt(1).Cross(b.TangentAt(0))) < 0.001 && a.TangentAt(1).Dot(b.TangentAt(0)) > 0;
    }

    private static Func<double, Vector2, Vector2> Flank(MatingJob job, FeaturePass pass, Vector2[] corrections, Range which)
    {
        var flank = pass with { Feet = [.. pass.Feet.Take(which)] };
        return Course(job, flank, corrections[which], null);
    }

    private static ElementWish Between(
        NcPath path, FeaturePass pass, int index, int lastBefore, int firstBehind, Func<double, Vector2, Vector2> before, Func<double, Vector2, Vector2> behind)
    {
        var (from, to) = (pass.Starts[lastBefore + 1 - pass.First], pass.Starts[firstBehind - pass.First]);
        var element = Element(path, pass, index, (s, normal) =>
        {
            var share = to > from ? (s - from) / (to - from) : 0.5;
            return (before(from, normal) * (1 - share)) + (behind(to, normal) * share);
        });
        return element with { IsFillet = path.Motions[index].IsArc };
    }
}
