namespace ErrorMatching.Freeform;

/// <summary>
/// Chooses among the models of a field: a polynomial, a Gaussian process and a cubic spline by the least error when lines are left out, and breaks only where they earn it.
/// </summary>
/// <remarks>Leaving out one value at a time is blind on grids: its neighbors on both lines tell where it must lie. So whole lines are left out.</remarks>
internal static class ModelChoice
{
    /// <summary>A model with breaks must leave this share of the line-out error of the best model without.</summary>
    private const double BreakShare = 0.7;

    /// <summary>The model of some values, of which there must be one at least.</summary>
    public static FieldModel Best(FieldData data)
    {
        var polynomials = new BreakSearch(data).Run();
        var smooth = new List<FieldModel> { polynomials[0] };
        Add(ProcessSearch.Run(data, ProcessSearch.Trend(1)));
        Add(SplineModel.Run(data));
        var best = smooth.MinBy(Error)!;
        for (var k = polynomials.Count - 1; k > 0; k--)
        {
            if (Error(polynomials[k]) <= BreakShare * Error(best))
            {
                return polynomials[k];
            }
        }

        return best;

        void Add(FieldModel? model)
        {
            if (model is not null)
            {
                smooth.Add(model);
            }
        }
    }

    private static double Error(FieldModel model) => double.IsNaN(model.LineOut) ? double.MaxValue : model.LineOut;
}
