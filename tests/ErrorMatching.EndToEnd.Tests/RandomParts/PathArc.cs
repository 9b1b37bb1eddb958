namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A circular element; its center can shift and its radius grow.
/// Turning left it goes around the material, turning right the material is outside.</summary>
internal sealed record PathArc(Flat Start, double HeadingIn, double Radius, double Sweep, double Offset) : IPathElement
{
    public Flat End => Center + (Spoke(Sweep) * Radius);

    public double HeadingOut => HeadingIn + Sweep;

    public double BoundaryLength => BoundaryRadius * Math.Abs(Sweep);

    private bool AroundMaterial => Sweep > 0;

    private Flat Center => Start + (Flat.Toward(HeadingIn).Left * (AroundMaterial ? Radius : -Radius));

    private double BoundaryRadius => AroundMaterial ? Radius - Offset : Radius + Offset;

    public (Flat Place, Flat Normal) BoundaryAt(double length)
    {
        var spoke = Spoke(Sweep * length / BoundaryLength);
        return (Center + (spoke * BoundaryRadius), AroundMaterial ? spoke : -spoke);
    }

    public IEnumerable<PathMove> Moves() => [new(End, Center, Sweep)];

    public Func<double, double> DrawDeviation(Random random)
    {
        var center = Center + new Flat(Draw.Between(random, -0.1, 0.1), Draw.Between(random, -0.1, 0.1));
        var growth = Draw.Signed(random, 0.06, 0.25);
        var radius = AroundMaterial ? BoundaryRadius + growth : BoundaryRadius - growth;
        return length =>
        {
            // Where the normal meets the displaced circle: the nearer root of |place + t normal - center| = radius.
            var (place, normal) = BoundaryAt(length);
            var spoke = place - center;
            var along = spoke.Dot(normal);
            return -along + (Math.Sign(along) * Math.Sqrt((along * along) - spoke.Dot(spoke) + (radius * radius)));
        };
    }

    private Flat Spoke(double turned)
    {
        var left = Flat.Toward(HeadingIn + turned).Left;
        return AroundMaterial ? -left : left;
    }
}
