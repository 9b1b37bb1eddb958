namespace ErrorMatching.Geometry;

/// <summary>The least-squares poles of many curves that share parameters and knots: one pass of a tensor-product fit. A surface over a
/// grid takes two passes, one along each direction (C. de Boor, A Practical Guide to Splines, chapter 17).</summary>
internal static class LinePass
{
    /// <summary>Fits every column.</summary>
    /// <param name="knots">Degree and knots.</param>
    /// <param name="parameters">Ascending parameters, one per row.</param>
    /// <param name="data">Rows with one number per column.</param>
    /// <param name="columns">Number of columns.</param>
    /// <returns>One row per pole, with the same number of columns.</returns>
    /// <exception cref="GeometryException">The parameters do not determine every pole
    /// (<see cref="GeometryError.RankDeficient"/>).</exception>
    public static double[] Fit(KnotVector knots, ReadOnlySpan<double> parameters, ReadOnlySpan<double> data, int columns)
    {
        if (!FittingKnots.Determine(knots, parameters))
        {
            throw new GeometryException(
                GeometryError.RankDeficient,
                $"{parameters.Length} points lie so that they do not determine {knots.PoleCount} poles of degree {knots.Degree}: some "
                    + $"pieces between knots have too few of them; take fewer poles or a lower degree");
        }

        var p = knots.Degree;
        var equations = new BandedLeastSquares(knots.PoleCount, p + 1, columns);
        var factors = new double[p + 1];
        var rights = new double[columns];
        for (var i = 0; i < parameters.Length; i++)
        {
            var span = knots.SpanAt(parameters[i]);
            knots.Basis.WithDerivatives(span, parameters[i], 0, factors);
            data.Slice(i * columns, columns).CopyTo(rights);
            equations.Add(span - p, factors, rights);
        }

        return equations.Solve();
    }

    public static double[] Numbers(ReadOnlySpan<Point3> points)
    {
        var numbers = new double[3 * points.Length];
        for (var i = 0; i < points.Length; i++)
        {
            if (!points[i].IsFinite)
            {
                throw new GeometryException(GeometryError.NotFinite, $"point {i + 1} has a coordinate that is no finite number");
            }

            (numbers[3 * i], numbers[(3 * i) + 1], numbers[(3 * i) + 2]) = (points[i].X, points[i].Y, points[i].Z);
        }

        return numbers;
    }

    public static Point3[] Points(ReadOnlySpan<double> numbers)
    {
        var points = new Point3[numbers.Length / 3];
        for (var i = 0; i < points.Length; i++)
        {
            points[i] = new(numbers[3 * i], numbers[(3 * i) + 1], numbers[(3 * i) + 2]);
        }

        return points;
    }

    public static double[] Transposed(ReadOnlySpan<double> grid, int rows, int columns)
    {
        var result = new double[grid.Length];
        for (var i = 0; i < rows; i++)
        {
            for (var j = 0; j < columns; j++)
            {
                grid.Slice(3 * ((i * columns) + j), 3).CopyTo(result.AsSpan(3 * ((j * rows) + i)));
            }
        }

        return result;
    }
}
