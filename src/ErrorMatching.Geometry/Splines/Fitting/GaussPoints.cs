namespace ErrorMatching.Geometry;

/// <summary>Gauss-Legendre nodes and weights that integrate products of second derivatives of a spline exactly, piece by piece (Abramowitz
/// and Stegun, table 25.4).</summary>
internal static class GaussPoints
{
    /// <summary>Degree plus one nodes per piece: exact for products of two splines of this degree.</summary>
    public static IEnumerable<(double Parameter, double Weight)> Of(KnotVector knots)
    {
        var (nodes, weights) = Rule(knots.Degree + 1);
        var breaks = knots.Breaks;
        for (var piece = 1; piece < breaks.Count; piece++)
        {
            var half = (breaks[piece] - breaks[piece - 1]) / 2;
            var middle = (breaks[piece] + breaks[piece - 1]) / 2;
            for (var i = 0; i < nodes.Length; i++)
            {
                yield return (middle + (half * nodes[i]), half * weights[i]);
            }
        }
    }

    /// <summary>The zeros of the Legendre polynomial of degree n by Newton's method from Tricomi's estimate, with their weights.</summary>
    private static (double[] Nodes, double[] Weights) Rule(int n)
    {
        var (nodes, weights) = (new double[n], new double[n]);
        for (var i = 0; i < n; i++)
        {
            var x = Elementary.Cos(Math.PI * (i + 0.75) / (n + 0.5));
            var slope = 0.0;
            for (var step = 0; step < 8; step++)
            {
                var (previous, value) = (1.0, x);
                for (var k = 2; k <= n; k++)
                {
                    (previous, value) = (value, ((((2 * k) - 1) * x * value) - ((k - 1) * previous)) / k);
                }

                slope = n * ((x * value) - previous) / ((x * x) - 1);
                x -= value / slope;
            }

            (nodes[i], weights[i]) = (x, 2 / ((1 - (x * x)) * slope * slope));
        }

        return (nodes, weights);
    }
}
