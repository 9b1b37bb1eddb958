namespace ErrorMatching.Geometry;

/// <summary>Selects the degree of a polynomial whose error over the whole curve is expected to be the least, as judged by smooth random
/// curves through the same points.</summary>
/// <remarks>
/// <para>
/// The error at left-out points does not show what a polynomial does between its points, and few points do not tell noise from shape. So
/// the true curve is taken as a <see cref="SmoothProcess"/>: a Gaussian process with a length and a ratio of amplitude to noise, neither
/// of them known. Each pair gives a curve m with a mean variance V and has a weight by how probable it makes the ordinates. The degree
/// minimizes the weighted mean of <c>log(mean square of (polynomial - m) + V)</c>, which is the expected logarithm of its squared error up
/// to a constant. This is a choice of a submodel by expected loss (D. V. Lindley, "The choice of variables in multiple regression",
/// J. R. Stat. Soc. B 30, 1968). The logarithm keeps an improbable curve with a large error from deciding.
/// </para>
/// <para>
/// Prior: the length is log-normal about half the extent of the points, the ratio about 30. Within two standard deviations of the prior,
/// the length is 0.15 to 1.6 times the extent and the ratio 7 to 120. The scale of the ordinates does not matter.
/// </para>
/// </remarks>
internal static class DegreeChoice
{
    /// <summary>More points are averaged in groups before the choice: a polynomial of a moderate degree does not vary within a group, and
    /// the time grows with the cube of the number.</summary>
    private const int MostGroups = 40;

    /// <summary>Number of equal intervals of the curve between the places where polynomials are judged.</summary>
    private const int Intervals = 40;

    /// <summary>A higher degree must reduce the expected logarithm of the squared error by more than this: 1 % of the error.</summary>
    private const double Improvement = 0.02;

    /// <summary>Residuals below this share of the largest ordinate are rounding errors: the fit is exact.</summary>
    private const double Exact = 1e-14;

    /// <summary>Median of the length as a share of the extent of the points, and standard deviation of its logarithm.</summary>
    private const double Length = 0.5, LengthDeviation = 0.6;

    /// <summary>Median of the ratio of amplitude to noise, and standard deviation of its logarithm.</summary>
    private const double Ratio = 30, RatioDeviation = 0.7;

    /// <summary>A pair of this share of the largest weight does not matter.</summary>
    private const double Negligible = 1e-4;

    /// <summary>The degree from 0 to the highest of the basis.</summary>
    /// <param name="x">Abscissae, ascending.</param>
    /// <param name="y">Ordinates.</param>
    /// <param name="basis">The basis over these points up to the highest degree.</param>
    /// <param name="ridge">The ridge weight of the fit.</param>
    /// <param name="uncertainty">Stated standard uncertainty of an ordinate; 0 if it is not known.</param>
    public static int Select(DoubleDouble[] x, DoubleDouble[] y, ForsytheBasis basis, double ridge, double uncertainty)
    {
        var highest = basis.Coefficients.Length - 1;
        var largest = y.Max(v => Math.Abs(v.ToDouble()));
        var exact = Array.FindIndex(basis.Residuals, row => row.All(r => Math.Abs(r.ToDouble()) <= Exact * largest));
        if (highest == 0 || (exact >= 0 && exact < x.Length - 1))
        {
            return Math.Max(exact, 0);
        }

        // Without their mean and their scale, ordinates of any magnitude keep their digits.
        var scale = basis.Residuals[0].Max(r => Math.Abs(r.ToDouble()));
        double[] places = [.. Enumerable.Range(0, Intervals + 1).Select(i => (2.0 * i / Intervals) - 1)];
        var polynomials = Polynomials(basis, ridge, scale, places);
        var expected = new double[highest + 1];
        foreach (var (weight, course, variance) in Courses(Groups(x, basis, scale), places, uncertainty / scale))
        {
            for (var degree = 0; degree <= highest; degree++)
            {
                expected[degree] += weight * Elementary.Log(MeanSquare(polynomials[degree], course) + variance);
            }
        }

        var least = expected.Min();
        return Array.FindIndex(expected, e => e <= least + Improvement);
    }

    private static double MeanSquare(double[] a, double[] b)
    {
        var sum = 0.0;
        for (var i = 0; i < a.Length; i++)
        {
            sum += (a[i] - b[i]) * (a[i] - b[i]);
        }

        return sum / a.Length;
    }

    /// <summary>The fit of each degree, without the mean, at places of the mapped abscissa.</summary>
    private static double[][] Polynomials(ForsytheBasis basis, double ridge, double scale, double[] places)
    {
        var rows = new double[basis.Coefficients.Length][];
        var sum = new double[places.Length];
        var before = new double[places.Length];
        var value = Array.ConvertAll(places, _ => 1.0);
        for (var k = 0; k < rows.Length; k++)
        {
            var (a, b) = (basis.A[k].ToDouble(), basis.B[k].ToDouble());
            var coefficient = k == 0 ? 0 : LeaveOneOut.Shrink(k, ridge) * basis.Coefficients[k].ToDouble() / scale;
            for (var i = 0; i < places.Length; i++)
            {
                sum[i] += coefficient * value[i];
                (before[i], value[i]) = (value[i], ((places[i] - a) * value[i]) - (b * before[i]));
            }

            rows[k] = [.. sum];
        }

        return rows;
    }

    /// <summary>The points without their mean and with mapped abscissae, averaged in groups of neighbors if there are too many.</summary>
    private static (double[] Places, double[] Values, double[] Counts) Groups(DoubleDouble[] x, ForsytheBasis basis, double scale)
    {
        var count = Math.Min(x.Length, MostGroups);
        var (places, values, counts) = (new double[count], new double[count], new double[count]);
        for (var i = 0; i < x.Length; i++)
        {
            var group = (int)((long)i * count / x.Length);
            places[group] += ((x[i] - basis.Center) / basis.HalfWidth).ToDouble();
            values[group] += basis.Residuals[0][i].ToDouble() / scale;
            counts[group]++;
        }

        for (var group = 0; group < count; group++)
        {
            places[group] /= counts[group];
            values[group] /= counts[group];
        }

        return (places, values, counts);
    }

    /// <summary>The courses of the process for every pair of length and ratio that is not improbable, with their weights.</summary>
    private static IEnumerable<(double Weight, double[] Course, double Variance)> Courses(
        (double[] Places, double[] Values, double[] Counts) points, double[] places, double uncertainty)
    {
        var pairs = new List<(SmoothProcess Process, double Evidence)>();
        // In standard deviations of the prior. The ratio is tried beyond what the prior makes probable: many points outweigh the prior.
        for (var ofLength = -2.5; ofLength <= 2.5; ofLength += 0.5)
        {
            for (var ofRatio = -6.0; ofRatio <= 6; ofRatio++)
            {
                // The mapped abscissae extend from -1 to 1.
                var length = 2 * Length * Elementary.Exp(LengthDeviation * ofLength);
                var ratio = Ratio * Elementary.Exp(RatioDeviation * ofRatio);
                var process = new SmoothProcess(points.Places, points.Values, points.Counts, length, ratio, uncertainty);
                pairs.Add((process, process.LogEvidence - (((ofLength * ofLength) + (ofRatio * ofRatio)) / 2)));
            }
        }

        var most = pairs.Max(p => p.Evidence);
        var kept = pairs.Select(p => (p.Process, Weight: Elementary.Exp(p.Evidence - most))).Where(p => p.Weight > Negligible).ToArray();
        var sum = kept.Sum(p => p.Weight);
        foreach (var (process, weight) in kept)
        {
            var (course, variance) = process.At(places);
            yield return (weight / sum, course, variance);
        }
    }
}
