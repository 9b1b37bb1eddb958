namespace ErrorMatching.Freeform;

/// <summary>Finds a local minimum by the simplex method of Nelder and Mead (The Computer Journal 7, 1965), without derivatives or random
/// numbers.</summary>
internal static class Simplex
{
    /// <summary>Returns a place near a local minimum.</summary>
    /// <param name="function">The function to minimize.</param>
    /// <param name="start">Start of the search.</param>
    /// <param name="size">Edge length of the initial simplex along each axis.</param>
    /// <param name="evaluations">Maximum number of evaluations.</param>
    /// <param name="tolerance">The search ends when the values at the corners differ by less.</param>
    public static double[] Minimum(Func<double[], double> function, double[] start, double size, int evaluations, double tolerance)
    {
        var n = start.Length;
        var corners = Enumerable.Range(0, n + 1).Select(k =>
        {
            var x = (double[])start.Clone();
            if (k > 0)
            {
                x[k - 1] += size;
            }

            return (X: x, Value: function(x));
        }).ToArray();
        for (var used = n + 1; used < evaluations;)
        {
            Array.Sort(corners, (a, b) => a.Value.CompareTo(b.Value));
            if (corners[n].Value - corners[0].Value < tolerance)
            {
                break;
            }

            var center = Enumerable.Range(0, n).Select(i => corners.Take(n).Average(c => c.X[i])).ToArray();
            var next = Along(-1);
            if (next.Value < corners[0].Value)
            {
                var farther = Along(-2);
                next = farther.Value < next.Value ? farther : next;
            }
            else if (next.Value >= corners[n - 1].Value)
            {
                next = Along(next.Value < corners[n].Value ? -0.5 : 0.5);
            }

            if (next.Value < corners[n].Value)
            {
                corners[n] = next;
                continue;
            }

            for (var k = 1; k <= n; k++)
            {
                var x = corners[k].X.Zip(corners[0].X, (a, b) => (a + b) / 2).ToArray();
                corners[k] = (x, function(x));
                used++;
            }

            (double[] X, double Value) Along(double share)
            {
                var x = center.Zip(corners[n].X, (c, w) => c + (share * (w - c))).ToArray();
                used++;
                return (x, function(x));
            }
        }

        return corners.MinBy(c => c.Value).X;
    }
}
