namespace ErrorMatching.Geometry;

public static partial class SplineSurfaceFit
{
    /// <summary>The surface with given knots that balances points against the bending energy of a thin plate, for each coordinate: the
    /// integral of Suu^2 + 2 Suv^2 + Svv^2 over an area as large as the surface (J. Duchon 1977). Unless given, the weight of the energy
    /// predicts left-out points best (generalized cross-validation).</summary>
    /// <param name="points">At least three points in any order, on a grid or scattered.</param>
    /// <param name="us">One parameter u per point.</param>
    /// <param name="vs">One parameter v per point.</param>
    /// <param name="knotsU">Degree, at least 2, and knots along u. Time grows with the poles along u and the cube of those along v.</param>
    /// <param name="knotsV">Degree, at least 2, and knots along v.</param>
    /// <param name="lengthU">Length of the surface along u in mm, so that bending is that of the surface, not of its parameters.</param>
    /// <param name="lengthV">Length of the surface along v in mm.</param>
    /// <param name="weight">The weight in mm^2; null selects it.</param>
    /// <exception cref="GeometryException"><see cref="GeometryError.RankDeficient"/> if the points do not even determine a plane over the
    /// parameters; the counts differ; a number is not finite; a degree is below 2; a length is not positive.</exception>
    public static SmoothedSurface Smooth(
        ReadOnlySpan<Point3> points,
        ReadOnlySpan<double> us,
        ReadOnlySpan<double> vs,
        KnotVector knotsU,
        KnotVector knotsV,
        double lengthU,
        double lengthV,
        double? weight = null)
    {
        CheckScattered(points, us, vs, knotsU, knotsV);
        if (knotsU.Degree < 2 || knotsV.Degree < 2)
        {
            throw new GeometryException(
                GeometryError.BadKnots,
                $"a smoothed surface of degrees {knotsU.Degree} and {knotsV.Degree}; both must be at least 2, or there is no bending to "
                    + $"weigh");
        }

        if (!(lengthU > 0 && lengthV > 0 && double.IsFinite(lengthU) && double.IsFinite(lengthV)))
        {
            throw new GeometryException(GeometryError.CoincidentPoints, "a surface whose length along u or v is not a positive number");
        }

        var stride = knotsV.PoleCount;
        var fit = new PenalizedFit(knotsU.PoleCount * stride, (knotsU.Degree * stride) + knotsV.Degree);
        var product = new TensorBasis(knotsU, knotsV);
        for (var k = 0; k < points.Length; k++)
        {
            product.MoveTo(us[k], vs[k], 0);
            fit.AddPoint(product.Poles(), product.Of(0, 0), points[k]);
        }

        var (scaleU, scaleV) = (lengthU / (knotsU.End - knotsU.Start), lengthV / (knotsV.End - knotsV.Start));
        foreach (var (u, weightU) in GaussPoints.Of(knotsU))
        {
            foreach (var (v, weightV) in GaussPoints.Of(knotsV))
            {
                product.MoveTo(u, v, 2);
                var poles = product.Poles();
                var area = weightU * weightV * scaleU * scaleV;
                fit.AddBending(poles, product.Of(2, 0), area / Elementary.Pow(scaleU, 4));
                fit.AddBending(poles, product.Of(1, 1), 2 * area / Elementary.Pow(scaleU * scaleV, 2));
                fit.AddBending(poles, product.Of(0, 2), area / Elementary.Pow(scaleV, 4));
            }
        }

        var solution = fit.Solve(weight);
        return new(new(knotsU, knotsV, solution.Poles), solution.Weight, solution.EffectiveParameters);
    }
}
