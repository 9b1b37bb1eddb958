namespace ErrorMatching.Geometry;

/// <content>Interpolation at Greville parameters.</content>
public sealed partial class SplineSurface
{
    /// <summary>The surface over given knots that passes through one point per pole, each at the Greville parameters of its pole.</summary>
    /// <param name="knotsU">Degree and knots along u; the multiplicity of inner knots is at most the degree.</param>
    /// <param name="knotsV">The same along v.</param>
    /// <param name="points">One point per pole, v varying fastest.</param>
    /// <exception cref="GeometryException">The counts do not match, a point is not finite, or a knot is repeated too often.</exception>
    public static SplineSurface AtGreville(KnotVector knotsU, KnotVector knotsV, ReadOnlySpan<Point3> points)
    {
        var through = new SplineSurface(knotsU, knotsV, points);
        return through.Each(SolveAtGreville, SolveAtGreville);
    }

    private static SplineRows SolveAtGreville(SplineRows points)
    {
        var values = (double[])points.Values.Clone();
        new GrevilleSystem(points.Knots).Solve(values, points.Width);
        return points with { Values = values };
    }
}
