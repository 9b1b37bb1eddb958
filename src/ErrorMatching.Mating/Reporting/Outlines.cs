using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Boundaries as polylines in the part's frame, for drawing.</summary>
internal static class Outlines
{
    private const int PointsOfAnArc = 24;

    /// <summary>The boundary that a path leaves along a pass: the path offset by the tool's radius, or the path itself under cutter compensation.</summary>
    public static IReadOnlyList<Point2> Boundary(MatingJob job, NcPath path, FeaturePass pass) => Boundary(job, path, pass, _ => 0);

    /// <summary>
    /// The measured boundary as the compensation sees it: straight between the points of a line, through the apex of a triangle, and for a curve the designed boundary
    /// displaced by the deviation along its length.
    /// </summary>
    public static IReadOnlyList<Point2> Measured(MatingJob job, NcPath path, FeatureMap map, IReadOnlyList<Point2> actual, IReadOnlyList<Point2> theoretical)
    {
        switch (map.Feature)
        {
            case CurveFeature curve:
                var field = FeatureWish.NormalField(job, map.Passes[0], curve, [.. actual.Select((p, i) => (p - theoretical[i]).Dot(map.Normals[i]))]);
                return Boundary(job, path, map.Passes[0], field.At);
            case TriangleFeature triangle:
                var wedge = Wedge.Fit([.. actual.Take(triangle.FirstFlank.Count)], [.. actual.Skip(triangle.FirstFlank.Count)]);
                return [actual[0], wedge.Apex, actual[^1]];
            default:
                return actual;
        }
    }

    private static List<Point2> Boundary(MatingJob job, NcPath path, FeaturePass pass, Func<double, double> towardTool)
    {
        var toPart = job.Counterpart.Frame.Inverse();
        var points = new List<Point2>();
        for (var i = pass.First; i <= pass.Last; i++)
        {
            var motion = path.Motions[i];
            if (motion.PlaneLength < 1e-9)
            {
                continue;
            }

            var radius = motion.Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight) ? 0 : job.Counterpart.ToolDiameterMm / 2;
            var (from, to) = (pass.Starts[i - pass.First], pass.Starts[i - pass.First + 1]);
            var steps = motion.IsArc ? PointsOfAnArc : 1;
            for (var step = 0; step <= steps; step++)
            {
                var fraction = (double)step / steps;
                var towardMaterial = pass.Feet[0].MaterialIsLeft ? motion.TangentAt(fraction).Left : -motion.TangentAt(fraction).Left;
                points.Add(toPart.Apply(motion.PlaneAt(fraction) + (towardMaterial * (radius - towardTool(from + ((to - from) * fraction))))));
            }
        }

        return points;
    }
}
