namespace ErrorMatching.Mating;

/// <summary>What is not known about some places of the boundary together: a few columns, each of which one random number scales.</summary>
/// <param name="First">The first of the places.</param>
/// <param name="Columns">The columns, each with a number for each place, mm.</param>
internal sealed record JointFactor(int First, IReadOnlyList<double[]> Columns)
{
    // What remains of the variance at a place, as a part of the largest one: 3 % of a standard deviation.
    private const double Remains = 1e-3;

    /// <summary>The factor of a joint posterior: Cholesky's with the largest variance left as the pivot, until little is left. Smooth
    /// deviations at hundreds of places need about as many columns as there are key points.</summary>
    /// <param name="first">The first of the places.</param>
    /// <param name="joint">What is known about them.</param>
    public static JointFactor Of(int first, JointDeviation joint)
    {
        var n = joint.Count;
        double[] left = [.. Enumerable.Range(0, n).Select(k => joint.Covariance(k, k))];
        var (columns, least) = (new List<double[]>(), Remains * left.DefaultIfEmpty().Max());
        while (columns.Count < n)
        {
            var pivot = 0;
            for (var k = 1; k < n; k++)
            {
                pivot = left[k] > left[pivot] ? k : pivot;
            }

            if (!(left[pivot] > least))
            {
                break;
            }

            var (column, root) = (new double[n], Math.Sqrt(left[pivot]));
            for (var k = 0; k < n; k++)
            {
                var sum = joint.Covariance(k, pivot);
                foreach (var before in columns)
                {
                    sum -= before[k] * before[pivot];
                }

                column[k] = sum / root;
                left[k] -= column[k] * column[k];
            }

            left[pivot] = 0;
            columns.Add(column);
        }

        return new(first, columns);
    }
}
