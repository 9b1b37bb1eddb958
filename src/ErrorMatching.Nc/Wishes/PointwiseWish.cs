using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>A wish made of displaced points. Between the feet of two points, the displacement changes linearly with the length along the
/// run; before the first and after the last it is constant.</summary>
/// <param name="Wish">What to displace.</param>
/// <param name="LargestMisfitMm">Largest deviation of an element from the wish at a point, mm: a line cannot bend between its ends, and
/// an arc is not a free curve.</param>
/// <param name="Worst">The point with that deviation.</param>
public sealed record PointwiseWish(DisplacementWish Wish, double LargestMisfitMm, DisplacedPoint Worst)
{
    /// <summary>Allowed distance of a point from the path of the named blocks, mm.</summary>
    public const double FurthestMm = 0.5;

    /// <summary>Makes the wish.</summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="blocks">Positions of the named blocks. Their cutting motions form runs of consecutive motions without a gap.</param>
    /// <param name="points">At least one point, in any order. Each applies to every run that passes within
    /// <see cref="FurthestMm"/>.</param>
    /// <returns>
    /// The wish, or a refusal: no cutting motion, a plane other than XY, a point off every run (<see cref="NcRefusalCodes.PointOffPath"/>),
    /// a run without points (<see cref="NcRefusalCodes.RunWithoutPoint"/>), or two wishes at one place
    /// (<see cref="NcRefusalCodes.PointsCoincide"/>).
    /// </returns>
    /// <exception cref="ArgumentException">There are no points.</exception>
    public static Outcome<PointwiseWish> Of(NcPath path, IReadOnlyList<int> blocks, IReadOnlyList<DisplacedPoint> points)
    {
        if (points.Count == 0)
        {
            throw new ArgumentException("No points are given.", nameof(points));
        }

        // A wish for zero displacement names the same motions and is refused for the same reasons.
        var named = DisplacementWish.Normal(path, [.. blocks.Distinct().Order()], 0);
        if (!named.IsUsable)
        {
            return named.Refusal;
        }

        int[] motions = [.. named.Result.Elements.Select(e => e.Motion)];
        foreach (var motion in motions)
        {
            if (path.Motions[motion].Plane != CoordinatePlane.XY)
            {
                return BlockRefusal.At(
                    path.Program,
                    path.Motions[motion].Block,
                    NcRefusalCodes.PlaneChange,
                    "displaced points have X and Y, but this block is cut in another plane.");
            }
        }

        var runs = RunsOf(path, motions);
        var tree = new PathTree(path, motions);
        var feet = new List<PathFoot>();
        foreach (var point in points)
        {
            tree.Collect(point.Place, FurthestMm, feet);
            if (feet.Count == 0)
            {
                var nearest = tree.NearestTo(point.Place);
                return BlockRefusal.At(
                    path.Program,
                    path.Motions[nearest.Motion].Block,
                    NcRefusalCodes.PointOffPath,
                    string.Create(
                        CultureInfo.InvariantCulture,
                        $"the point {point.Place} lies {nearest.DistanceMm:0.000} mm from the path of the named blocks, more than "
                            + $"{FurthestMm} mm. Give points on the programmed path, and name all blocks that cut it."));
            }

            Share(point, feet, runs);
        }

        return Combine(runs, points);
    }

    // A point belongs to every run that it is on, at the nearest motion of each.
    private static void Share(DisplacedPoint point, List<PathFoot> feet, List<WishedRun> runs)
    {
        var (run, best) = (-1, default(PathFoot));
        foreach (var foot in feet)
        {
            var its = RunOf(foot.Motion, runs);
            if (its != run)
            {
                Give();
                (run, best) = (its, foot);
            }
            else if (foot.DistanceMm < best.DistanceMm)
            {
                best = foot;
            }
        }

        Give();

        void Give()
        {
            if (run >= 0)
            {
                runs[run].Add(point, best);
            }
        }
    }

    private static int RunOf(int motion, List<WishedRun> runs)
    {
        var (low, high) = (0, runs.Count - 1);
        while (low < high)
        {
            var middle = (low + high + 1) / 2;
            (low, high) = runs[middle].First <= motion ? (middle, high) : (low, middle - 1);
        }

        return low;
    }

    private static Outcome<PointwiseWish> Combine(List<WishedRun> runs, IReadOnlyList<DisplacedPoint> points)
    {
        var elements = new List<ElementWish>();
        var (misfit, worst) = (0.0, points[0]);
        foreach (var run in runs)
        {
            if (run.Sort() is { } refusal)
            {
                return refusal;
            }

            elements.AddRange(run.Elements());
            foreach (var (point, distance) in run.Misfits())
            {
                (misfit, worst) = distance > misfit ? (distance, point) : (misfit, worst);
            }
        }

        return new PointwiseWish(DisplacementWish.OfElements(elements), misfit, worst);
    }

    private static List<WishedRun> RunsOf(NcPath path, int[] motions)
    {
        var runs = new List<WishedRun>();
        var first = 0;
        for (var i = 1; i <= motions.Length; i++)
        {
            if (i == motions.Length || motions[i] != motions[i - 1] + 1)
            {
                runs.Add(new(path, motions[first], motions[i - 1]));
                first = i;
            }
        }

        return runs;
    }
}

/// <summary>A place on a programmed path and the displacement of the path there.</summary>
/// <param name="Place">The place in the XY plane, mm.</param>
/// <param name="By">The displacement, mm.</param>
public readonly record struct DisplacedPoint(Point2 Place, Vector2 By);
