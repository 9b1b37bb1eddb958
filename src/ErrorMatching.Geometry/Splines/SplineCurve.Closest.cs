namespace ErrorMatching.Geometry;

/// <content>The closest place.</content>
public sealed partial class SplineCurve
{
    private SplineSurface? _asSurface;

    /// <summary>The place of the curve that is closest to a point: as global and as accurate as <see cref="SplineSurface.ClosestPoint(Point3, double)"/>.</summary>
    /// <param name="p">The point.</param>
    /// <param name="tolerance">Accuracy wanted of the distance in millimetres, positive.</param>
    /// <exception cref="GeometryException">The point is not finite or the tolerance not positive.</exception>
    public CurveFoot ClosestPoint(Point3 p, double tolerance = 1e-7) => Foot(AsSurface().ClosestPoint(p, tolerance));

    /// <summary>The place of the curve that is closest to a point, searched from a place that is probably near it. The result is as global and as accurate as without.</summary>
    /// <param name="p">The point.</param>
    /// <param name="near">Parameter to begin at.</param>
    /// <param name="tolerance">Accuracy wanted of the distance in millimetres, positive.</param>
    /// <exception cref="GeometryException">The point or the parameter is not finite or the tolerance not positive.</exception>
    public CurveFoot ClosestPoint(Point3 p, double near, double tolerance) => Foot(AsSurface().ClosestPoint(p, near, 0.5, tolerance));

    private static CurveFoot Foot(SurfaceFoot foot) => new(foot.At.U, foot.At.Position, foot.Offset, foot.Accuracy);

    /// <summary>The curve as a surface that does not change along v, so that one search serves both.</summary>
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
