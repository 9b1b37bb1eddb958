using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using MathNet.Numerics.LinearAlgebra;

namespace ErrorMatching.Mating;

/// <summary>
/// What an arc of a program can follow: a shift of its center and a change of its radius. Outward displacement at the angle t is <c>x cos t + y sin t + r</c>;
/// the three are found by least squares (QR) from the normal corrections at the key points.
/// </summary>
internal sealed class CircleField
{
    /// <summary>Smallest angle that the key points must span for center and radius to be told apart.</summary>
    private static readonly Angle SmallestSpan = Angle.FromDegrees(30);

    private readonly Vector2 shift;
    private readonly double growth;
    private readonly bool outwardIsLeft;

    private CircleField(Vector2 shift, double growth, bool outwardIsLeft)
    {
        this.shift = shift;
        this.growth = growth;
        this.outwardIsLeft = outwardIsLeft;
    }

    /// <summary>The field of a pass that consists of arcs of one circle, or null where it does not or where its key points say too little.</summary>
    public static CircleField? Of(NcPath path, FeaturePass pass, IReadOnlyList<Vector2> corrections)
    {
        var first = path.Motions[pass.First];
        for (var i = pass.First; i <= pass.Last; i++)
        {
            var motion = path.Motions[i];
            if (motion.Kind != first.Kind || !motion.IsArc || motion.Center.DistanceTo(first.Center) > 0.01 || Math.Abs(motion.Arc.Radius - first.Arc.Radius) > 0.01)
            {
                return null;
            }
        }

        var span = (pass.Feet.Max(f => f.AlongMm) - pass.Feet.Min(f => f.AlongMm)) / first.Arc.Radius;
        if (pass.Feet.Count < 3 || span < SmallestSpan.Radians)
        {
            return null;
        }

        var clockwise = first.Kind == MotionKind.ArcClockwise;
        Vector2[] outward = [.. pass.Feet.Select(f => f.MaterialIsLeft == clockwise ? -f.Normal : f.Normal)];
        var design = Matrix<double>.Build.Dense(outward.Length, 3, (i, j) => j == 0 ? outward[i].X : j == 1 ? outward[i].Y : 1);
        var solved = design.QR().Solve(Vector<double>.Build.Dense(outward.Length, i => corrections[i].Dot(outward[i])));
        return new(new(solved[0], solved[1]), solved[2], clockwise);
    }

    /// <summary>The displacement where the left normal of the path is given; the length along the pass does not matter.</summary>
    public Vector2 At(double along, Vector2 left)
    {
        var outward = outwardIsLeft ? left : -left;
        return outward * (shift.Dot(outward) + growth);
    }
}
