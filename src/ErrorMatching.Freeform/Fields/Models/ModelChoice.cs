namespace ErrorMatching.Freeform;

/// <summary>Selects the polynomial, Gaussian process or cubic spline with the least line-out error. Breaks must be worthwhile.</summary>
/// <remarks>Whole lines are left out, because leaving out single values reveals little on grids: the neighbors on both lines determine
/// each value.</remarks>
internal static class ModelChoice
{
    /// <summary>A model with breaks must reduce the line-out error to this share of that of the best model without breaks.</summary>
    private const double BreakShare = 0.7;

    /// <summary>The same for a kernel that is not smooth in both directions.</summary>
    private const double ShapeShare = 0.9;

    private const double FreedomShare = 0.5;

    /// <summary>A line-out error that no other model needs to improve on: a thousandth of a nanometer.</summary>
    private const double Nothing = 1e-9;

    /// <summary>Maximum number of values in which breaks among waves are searched.</summary>
    private const int MostForBreaksInWaves = 300;

    /// <summary>A model with more than this share of the values' freedom passes through them anyway.</summary>
    private const double ThroughShare = 0.8;

    /// <summary>A spline through measured errors does not replace a model that predicts left-out lines so many times better. With 3, it
    /// replaced one on noise, and left 9 um at a point of one of 60 virtual pieces.</summary>
    public const double FarWorseOnErrors = 1.5;

    /// <summary>The same for the points of a surface, which are meant, and have less noise.</summary>
    public const double FarWorseOnPoints = 3;

    /// <summary>Returns the best model of at least one value: the one with the least line-out error, or a spline through the values if
    /// that misses a part of the field.</summary>
    /// <param name="data">The values.</param>
    /// <param name="farWorse">The ratio of line-out errors from which the spline does not replace the model.</param>
    public static FieldModel Best(FieldData data, double farWorse)
    {
        var model = LeastLineOut(data);
        return Misses(model) && SplineModel.Interpolate(data, model) is { } interpolant && Error(interpolant) < farWorse * Error(model)
            ? interpolant
            : model;
    }

    /// <summary>True if what a model leaves of the values is no noise.</summary>
    public static bool Misses(FieldModel model) =>
        model.Kind != FieldModelKind.Interpolant
            && model is not PolynomialModel { IsExact: true }
            && model.Freedom <= ThroughShare * model.Data.Count
            && LeftStructure.IsIn(model.Data.With(model.Residuals()));

    private static FieldModel LeastLineOut(FieldData data)
    {
        // Polynomials are tried on one core, the other models on a second. Shared properties of the data are calculated first.
        _ = (data.Grid, data.Crossings, data.LinesOut);
        var search = Task.Run(() => Polynomials(data));
        var process = Unless(search, () => ProcessSearch.Run(data, ProcessSearch.Trend(2)));
        var linear = data.Count > MostForBreaksInWaves ? null : Unless(search, () => ProcessSearch.Run(data, ProcessSearch.Trend(1)));
        var shaped = linear is null ? null : Unless(search, () => ProcessSearch.OfOtherShape(linear));
        var spline = Unless(search, () => SplineModel.Run(data));
        var (polynomials, broken) = search.GetAwaiter().GetResult();
        if (IsPerfect(polynomials[^1]))
        {
            return polynomials[^1];
        }

        var smooth = Least([polynomials[0], linear, process, spline])!;
        if (process is not null
            && (polynomials.Count > 1 || smooth is ProcessModel)
            && !polynomials[^1].IsExact
            && data.Count <= MostForBreaksInWaves)
        {
            broken.Add(ProcessSearch.WithBreak(process));
        }

        var best = Least(broken.Where(m => m is not null && IsEarned(m, smooth))) ?? smooth;
        return shaped is not null && Error(shaped) <= ShapeShare * Error(best) ? shaped : best;
    }

    /// <summary>Returns all polynomials, from none to the most breaks, and those with breaks, each also limited to squares. Their line-out
    /// errors are calculated.</summary>
    private static (IReadOnlyList<PolynomialModel> All, List<FieldModel?> Broken) Polynomials(FieldData data)
    {
        var all = new BreakSearch(data).Run();
        var broken = new List<FieldModel?>();
        if (IsPerfect(all[^1]))
        {
            return (all, broken);
        }

        Tried(all[0]);
        for (var k = 1; k < all.Count; k++)
        {
            broken.Add(Tried(all[k]));
            broken.Add(Tried(BreakSearch.Squares(all[k])));
        }

        return (all, broken);
    }

    private static bool IsPerfect(PolynomialModel model) => model.IsExact && !(Error(model) > Nothing);

    /// <summary>Tries a model, unless a perfect polynomial is already known.</summary>
    private static T? Unless<T>(Task<(IReadOnlyList<PolynomialModel> All, List<FieldModel?> Broken)> search, Func<T?> model)
        where T : FieldModel => search.IsCompletedSuccessfully && IsPerfect(search.Result.All[^1]) ? null : Tried(model());

    /// <summary>Calculates the line-out error of a model, if there is one.</summary>
    private static T? Tried<T>(T? model)
        where T : FieldModel
    {
        _ = model?.LineOut;
        return model;
    }

    /// <summary>True if breaks reduce the line-out error enough; or, if noise hides the difference, if they do not increase it and use at
    /// most half the degrees of freedom.</summary>
    private static bool IsEarned(FieldModel broken, FieldModel smooth) =>
        Error(broken) <= BreakShare * Error(smooth) || (Error(broken) <= Error(smooth) && broken.Freedom <= FreedomShare * smooth.Freedom);

    private static FieldModel? Least(IEnumerable<FieldModel?> models) => models.OfType<FieldModel>().MinBy(Error);

    /// <summary>The line-out error. For a polynomial it is at least the mean residual of the full fit: its terms are reselected without
    /// each line, and the selection from all values may have been poor.</summary>
    private static double Error(FieldModel model)
    {
        if (double.IsNaN(model.LineOut))
        {
            return double.MaxValue;
        }

        return model is PolynomialModel polynomial ? Math.Max(model.LineOut, polynomial.MeanResidual) : model.LineOut;
    }
}
