namespace ErrorMatching.Freeform;

/// <summary>The polynomial of a process over given values, shared by all kernels that are tried on them.</summary>
/// <param name="Data">The values.</param>
/// <param name="Terms">The terms of the polynomial.</param>
/// <param name="Columns">Their values at the places.</param>
/// <param name="Ordinary">The polynomial fitted alone.</param>
internal sealed record ProcessTrend(FieldData Data, Term[] Terms, double[][] Columns, LeastSquares Ordinary)
{
    /// <summary>Returns the polynomial of given terms; null if the values do not determine it.</summary>
    public static ProcessTrend? Of(FieldData data, Term[] terms)
    {
        var columns = Term.Over(terms, data.U, data.V);
        return LeastSquares.Solve(columns, data.Z) is { } ordinary ? new(data, terms, columns, ordinary) : null;
    }

    /// <summary>Numbers of waves along u and along v over the values that explain most of what the polynomial leaves: the strongest
    /// wave, and the sum of one along u and one along v. Empty if nothing is left.</summary>
    public (double U, double V)[] Waves => _waves ??= Strongest();

    private (double U, double V)[]? _waves;

    private (double U, double V)[] Strongest()
    {
        var rest = Ordinary.Residuals;
        var mean = rest.Average();
        var length = Math.Sqrt(rest.Sum(r => (r - mean) * (r - mean)));
        if (!(length > 0))
        {
            return [];
        }

        var basis = WaveBasis.Build(Data);
        double[] unit = [.. rest.Select(r => (r - mean) / length)];
        var (any, alongU, alongV) = (
            basis.Strongest(unit), basis.Strongest(unit, (_, v) => v == 0), basis.Strongest(unit, (u, _) => u == 0));
        return [(any.U, any.V), (alongU.U, alongV.V)];
    }
}
