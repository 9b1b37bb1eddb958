namespace ErrorMatching.Freeform;

/// <summary>A product of one function of each axis.</summary>
internal sealed record Term(AxisFunction U, AxisFunction V)
{
    public double At(double u, double v) => U.At(u) * V.At(v);

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
