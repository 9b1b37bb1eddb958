using ErrorMatching.Geometry;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>A small rigid motion that aligns measured points to the surface: rotation about the points' center, then translation.</summary>
/// <remarks>The default is no alignment, because it hides every error that a rigid motion can produce. It minimizes the squared distances
/// along the normals (point to plane; Chen and Medioni, "Object modelling by registration of multiple range images", 1992) and recalculates
/// the feet until the motion converges. Motions that the surface does not resist (along a straight profile) stay zero.</remarks>
/// <param name="TranslateMm">The translation.</param>
/// <param name="RotateDegrees">The rotation, as small angles about X, Y and Z.</param>
/// <param name="Center">The center of rotation, in millimeters.</param>
public sealed record SurfaceAlignment(Vector3 TranslateMm, Vector3 RotateDegrees, Point3 Center)
{
    private const int MostRounds = 30;

    // A motion that moves every point off the surface by less than this share is not resisted.
    private const double RelativeResistance = 1e-6;

    /// <summary>Applies the motion to a point.</summary>
    public Point3 Apply(Point3 point)
    {
        var r = RotateDegrees * (Math.PI / 180);
        var arm = point - Center;
        var angle = r.Length;
        if (angle == 0)
        {
            return point + TranslateMm;
        }

        // Rodrigues' formula.
        var axis = r * (1 / angle);
        var (sin, cos) = Elementary.SinCos(angle);
        return Center + (arm * cos) + (axis.Cross(arm) * sin) + (axis * (axis.Dot(arm) * (1 - cos))) + TranslateMm;
    }

    /// <summary>Returns the best-fit motion of points to the surface with its stock.</summary>
    /// <param name="surface">The nominal surface.</param>
    /// <param name="points">Points of the plan with their measured contacts; at least six.</param>
    /// <param name="stockMm">Expected stock on the surface.</param>
    /// <param name="file">Name of the file of measured points, for messages.</param>
    /// <exception cref="InputException"><c>too-few-points</c>; <c>no-foot</c> as for <see cref="SurfaceErrors.Find"/>.</exception>
    public static SurfaceAlignment BestFit(
        PartSurface surface, IReadOnlyList<(PlanPoint Plan, Point3 Contact)> points, double stockMm, string file)
    {
        ArgumentNullException.ThrowIfNull(points);
        if (points.Count < 6)
        {
            throw InputException.At("too-few-points", file, $"{ReportNumber.Count(points.Count, "point")} for an alignment; "
                + $"at least 6 are expected");
        }

        var center = points.Aggregate(default(Vector3), (s, p) => s + (p.Contact - default(Point3))) * (1.0 / points.Count);
        var alignment = new SurfaceAlignment(default, default, default(Point3) + center);
        for (var round = 0; round < MostRounds; round++)
        {
            var samples = SurfaceErrors.Find(surface, points.Select(p => (p.Plan, alignment.Apply(p.Contact))), stockMm, file);
            var step = Step(samples, alignment);
            alignment = alignment with
            {
                TranslateMm = alignment.TranslateMm + step.Move,
                RotateDegrees = alignment.RotateDegrees + (step.Turn * (180 / Math.PI))
            };
            if (step.Move.Length < 1e-9 && step.Turn.Length < 1e-11)
            {
                break;
            }
        }

        return alignment;
    }

    // Least squares by the eigenvectors of the normal matrix, without the directions that the surface does not resist.
    private static (Vector3 Move, Vector3 Turn) Step(IReadOnlyList<ErrorSample> samples, SurfaceAlignment alignment)
    {
        var matrix = new double[6, 6];
        var right = new double[6];
        // Rotations are scaled by the size of the piece, so that all unknowns are lengths.
        var size = samples.Max(s => (s.Nominal - alignment.Center).Length);
        foreach (var s in samples)
        {
            var moment = (s.Nominal - alignment.Center).Cross(s.Normal) * (1 / size);
            double[] row = [s.Normal.X, s.Normal.Y, s.Normal.Z, moment.X, moment.Y, moment.Z];
            for (var i = 0; i < 6; i++)
            {
                right[i] -= row[i] * s.ErrorMm;
                for (var j = 0; j < 6; j++)
                {
                    matrix[i, j] += row[i] * row[j];
                }
            }
        }

        var x = SmallSymmetric.Solve(matrix, right, RelativeResistance);
        return (new(x[0], x[1], x[2]), new Vector3(x[3], x[4], x[5]) * (1 / size));
    }
}
