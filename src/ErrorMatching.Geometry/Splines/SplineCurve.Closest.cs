namespace ErrorMatching.Geometry;

/// <content>The closest point.</content>
public sealed partial class SplineCurve
{
    private SplineSurface? _asSurface;

    /// <summary>The point of the curve closest to a given point, with the same global search and accuracy as
    /// <see cref="SplineSurface.ClosestPoint(Point3, double)"/>.</summary>
    /// <param name="p">The point.</param>
    /// <param name="tolerance">Required accuracy of the distance in millimeters, positive.</param>
    /// <exception cref="GeometryException">The point is not finite or the tolerance not positive.</exception>
    public CurveFoot ClosestPoint(Point3 p, double tolerance = 1e-7) => Foot(AsSurface().ClosestPoint(p, tolerance));

    /// <summary>The point of the curve closest to a given point, starting from a place that is probably near it. The result is as global
    /// and accurate as without it.</summary>
    /// <param name="p">The point.</param>
    /// <param name="near">Parameter at which the search starts.</param>
    /// <param name="tolerance">Required accuracy of the distance in millimeters, positive.</param>
    /// <exception cref="GeometryException">The point or the parameter is not finite or the tolerance not positive.</exception>
    public CurveFoot ClosestPoint(Point3 p, double near, double tolerance) => Foot(AsSurface().ClosestPoint(p, near, 0.5, tolerance));

    private static CurveFoot Foot(SurfaceFoot foot) => new(foot.At.U, foot.At.Position, foot.Offset, foot.Accuracy);

    /// <summary>The curve as a surface that is constant along v, so that the same search can be used.</summary>
    private SplineSurface AsSurface()
    {
        if (_asSurface is null)
        {
            var (poles, weights) = (new Point3[2 * _poles.Length], new double[IsRational ? 2 * _poles.Length : 0]);
            for (var i = 0; i < poles.Length; i++)
            {
                poles[i] = _poles[i / 2];
            }

            for (var i = 0; i < weights.Length; i++)
            {
                weights[i] = _weights![i / 2];
            }

            _asSurface = new(Knots, KnotVector.Clamped(1, [0, 1]), poles, weights);
        }

        return _asSurface;
    }
}
