using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using MathNet.Numerics.LinearAlgebra;
using MathNet.Numerics.LinearAlgebra.Factorization;

namespace ErrorMatching.Mating;

/// <summary>The displacement that an arc of a program can follow: a shift s of its center and a growth g of its radius. Along the unit
/// ray u of the old center, a circle of radius r changed in this way is met at <c>s.u + sqrt((r + g)^2 - (s x u)^2)</c>. Least squares
/// (Gauss-Newton over QR) finds the three unknowns from the corrections at the key points, which are on the boundary's circle. The path's
/// circle has the same center, shift and growth.</summary>
internal sealed class CircleField
{
    /// <summary>Smallest angle that three key points must span; they determine the circle exactly and leave no residual to judge it
    /// by.</summary>
    private static readonly Angle SmallestSpan = Angle.FromDegrees(30);

    private const int Iterations = 4;

    private readonly double _pathRadius;
    private readonly Vector2 _shift;
    private readonly double _growth;
    private readonly bool _outwardIsLeft;

    private CircleField(double pathRadius, Vector2 shift, double growth, bool outwardIsLeft, double leaveOneOutRms)
    {
        LeaveOneOutRms = leaveOneOutRms;
        _pathRadius = pathRadius;
        _shift = shift;
        _growth = growth;
        _outwardIsLeft = outwardIsLeft;
    }

    /// <summary>Root mean square error at each point of the fit through the others (closed form from the hat matrix); infinite for three
    /// points.</summary>
    public double LeaveOneOutRms { get; }

    /// <summary>The field of a pass that consists of arcs of one circle; null for other passes, or if the key points determine the circle
    /// poorly.</summary>
    public static CircleField? Of(NcPath path, FeaturePass pass, IReadOnlyList<Vector2> corrections)
    {
        var first = path.Motions[pass.First];
        foreach (var i in FeaturePass.Moving(path, pass.First, pass.Last))
        {
            var motion = path.Motions[i];
            if (motion.Kind != first.Kind
                || !motion.IsArc
                || motion.Center.DistanceTo(first.Center) > 0.01
                || Math.Abs(motion.Arc.Radius - first.Arc.Radius) > 0.01)
            {
                return null;
            }
        }

        var clockwise = first.Kind == MotionKind.ArcClockwise;
        Vector2[] rays = [.. pass.Feet.Select(f => f.MaterialIsLeft == clockwise ? -f.Normal : f.Normal)];
        double[] radii = [.. pass.Feet.Select(f => first.Arc.Radius + (f.MaterialIsLeft == clockwise ? f.DistanceMm : -f.DistanceMm))];
        var spans = pass.Feet.Max(pass.Along) - pass.Feet.Min(pass.Along) >= SmallestSpan.Radians * radii.Max();
        if (pass.Feet.Count < 3 || (pass.Feet.Count == 3 && !spans))
        {
            return null;
        }

        var matrix = Matrix<double>.Build.Dense(rays.Length, 3, (i, j) => j == 0 ? rays[i].X : j == 1 ? rays[i].Y : 1);
        var design = matrix.QR(QRMethod.Thin);
        var (moved, grown) = (Vector2.Zero, 0.0);
        for (var iteration = 0; iteration < Iterations; iteration++)
        {
            var step = design.Solve(Vector<double>.Build.Dense(
                rays.Length, i => corrections[i].Dot(rays[i]) - Outward(rays[i], radii[i], moved, grown)));
            (moved, grown) = (moved + new Vector2(step[0], step[1]), grown + step[2]);
        }

        var leftOut = rays.Select(
            (ray, i) => (
                corrections[i].Dot(ray) - Outward(ray, radii[i], moved, grown))
                / Math.Max(0, 1 - design.Q.Row(i).DotProduct(design.Q.Row(i))));
        return new(
            first.Arc.Radius, moved, grown, clockwise, rays.Length == 3 ? double.PositiveInfinity : Math.Sqrt(leftOut.Average(e => e * e)));
    }

    /// <summary>The displacement for a left normal of the path; the length along the pass does not matter.</summary>
    public Vector2 At(double along, Vector2 left)
    {
        var ray = _outwardIsLeft ? left : -left;
        return ray * Outward(ray, _pathRadius, _shift, _growth);
    }

    private static double Outward(Vector2 ray, double radius, Vector2 shift, double growth)
    {
        var across = shift.Cross(ray);
        return shift.Dot(ray) + Math.Sqrt(((radius + growth) * (radius + growth)) - (across * across)) - radius;
    }
}
