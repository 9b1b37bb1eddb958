namespace ErrorMatching.Geometry;

/// <content>The surface through points at its Greville parameters.</content>
public sealed partial class SplineSurface
{
    /// <summary>The surface over given knots that goes through as many points as it has poles, each at the Greville parameters of its pole.</summary>
    /// <param name="knotsU">Degree and knots along u, no inner one repeated more often than the degree.</param>
    /// <param name="knotsV">The same along v.</param>
    /// <param name="points">As many points as the knots need poles, v running faster.</param>
    /// <exception cref="GeometryException">The counts do not fit, a point is not finite, or a knot is repeated too often.</exception>
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
