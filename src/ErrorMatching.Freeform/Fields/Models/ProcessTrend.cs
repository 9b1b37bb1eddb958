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
}
