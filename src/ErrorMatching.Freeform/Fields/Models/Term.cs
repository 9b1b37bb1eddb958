namespace ErrorMatching.Freeform;

/// <summary>A product of one function of each axis.</summary>
internal sealed record Term(AxisFunction U, AxisFunction V)
{
    public double At(double u, double v) => U.At(u) * V.At(v);

    /// <summary>Evaluates several terms at places. Each axis function is evaluated once.</summary>
    public static double[][] Over(IReadOnlyList<Term> terms, double[] u, double[] v)
    {
        var (alongU, alongV) = (new Dictionary<AxisFunction, double[]>(), new Dictionary<AxisFunction, double[]>());
        var result = new double[terms.Count][];
        for (var k = 0; k < result.Length; k++)
        {
            result[k] = Vectors.Products(Values(alongU, terms[k].U, u), Values(alongV, terms[k].V, v));
        }

        return result;

        static double[] Values(Dictionary<AxisFunction, double[]> known, AxisFunction function, double[] at)
        {
            if (!known.TryGetValue(function, out var values))
            {
                known[function] = values = Array.ConvertAll(at, function.At);
            }

            return values;
        }
    }

    public double[] Over(double[] u, double[] v)
    {
        var result = new double[u.Length];
        for (var k = 0; k < result.Length; k++)
        {
            result[k] = At(u[k], v[k]);
        }

        return result;
    }
}
