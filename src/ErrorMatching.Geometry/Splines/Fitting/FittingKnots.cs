namespace ErrorMatching.Geometry;

/// <summary>Knots for fitting curves and surfaces to points with given parameters.</summary>
public static class FittingKnots
{
    /// <summary>Knots for interpolation. Each inner knot is the mean of as many neighboring parameters as the degree, so that every piece
    /// has points (The NURBS Book, equation 9.8).</summary>
    /// <param name="degree">1 to the number of parameters minus one.</param>
    /// <param name="parameters">Ascending parameters, one per pole.</param>
    /// <exception cref="GeometryException">The degree needs more parameters, or they do not ascend.</exception>
    public static KnotVector ForInterpolation(int degree, ReadOnlySpan<double> parameters)
    {
        SplineParameters.CheckRising(parameters, parameters.Length);
        if (parameters.Length <= degree)
        {
            throw new GeometryException(
                GeometryError.TooFewPoints, $"{parameters.Length} points; a spline of degree {degree} needs at least {degree + 1}");
        }

        var n = parameters.Length;
        var values = new double[n + degree + 1];
        for (var i = 0; i <= degree; i++)
        {
            (values[i], values[^(i + 1)]) = (parameters[0], parameters[^1]);
        }

        for (var j = 1; j < n - degree; j++)
        {
            var sum = 0.0;
            for (var i = j; i < j + degree; i++)
            {
                sum += parameters[i];
            }

            values[j + degree] = sum / degree;
        }

        return new(degree, values);
    }

    /// <summary>Knots for least squares with fewer poles than points: about equally many parameters in every piece (The NURBS Book,
    /// equations 9.68 and 9.69).</summary>
    /// <param name="degree">1 to <paramref name="poles"/> minus one.</param>
    /// <param name="parameters">Ascending parameters.</param>
    /// <param name="poles">Number of poles; as many as parameters gives the knots for interpolation.</param>
    /// <exception cref="GeometryException">There are more poles than parameters, or fewer than the degree needs.</exception>
    public static KnotVector ForLeastSquares(int degree, ReadOnlySpan<double> parameters, int poles)
    {
        SplineParameters.CheckRising(parameters, parameters.Length);
        if (poles <= degree || poles > parameters.Length)
        {
            throw new GeometryException(
                GeometryError.TooFewPoints,
                $"{poles} poles of degree {degree} for {parameters.Length} points; {degree + 1} to {parameters.Length} are expected");
        }

        if (poles == parameters.Length)
        {
            return ForInterpolation(degree, parameters);
        }

        var pieces = poles - degree;
        var values = new double[poles + degree + 1];
        for (var i = 0; i <= degree; i++)
        {
            (values[i], values[^(i + 1)]) = (parameters[0], parameters[^1]);
        }

        var step = (double)parameters.Length / pieces;
        for (var j = 1; j < pieces; j++)
        {
            var place = j * step;
            var i = (int)place;
            var share = place - i;
            values[degree + j] = ((1 - share) * parameters[i - 1]) + (share * parameters[i]);
        }

        return new(degree, values);
    }

    /// <summary>True if points with these parameters determine every pole: each pole can be assigned a separate parameter at which its
    /// basis function does not vanish (Schoenberg and Whitney 1953).</summary>
    /// <param name="knots">Degree and knots.</param>
    /// <param name="parameters">Ascending parameters.</param>
    public static bool Determine(KnotVector knots, ReadOnlySpan<double> parameters)
    {
        ArgumentNullException.ThrowIfNull(knots);
        var t = knots.Values;
        var next = 0;
        for (var pole = 0; pole < knots.PoleCount; pole++)
        {
            // The first and last basis functions do not vanish at the ends.
            var (low, high) = (t[pole], t[pole + knots.Degree + 1]);
            while (next < parameters.Length && !(parameters[next] > low || (pole == 0 && parameters[next] == low)))
            {
                next++;
            }

            if (next == parameters.Length || !(parameters[next] < high || (pole == knots.PoleCount - 1 && parameters[next] == high)))
            {
                return false;
            }

            next++;
        }

        return true;
    }
}
