namespace ErrorMatching.Freeform;

/// <summary>
/// Chooses among the models of a field: a polynomial, a Gaussian process and a cubic spline by the least error when lines are left out, and breaks only where they earn it.
/// </summary>
/// <remarks>Leaving out one value at a time is blind on grids: its neighbors on both lines tell where it must lie. So whole lines are left out.</remarks>
internal static class ModelChoice
{
    /// <summary>A model with breaks must leave this share of the line-out error of the best model without.</summary>
    private const double BreakShare = 0.7;

    private const double FreedomShare = 0.5;

    /// <summary>A line-out error that no other model needs to beat: a thousandth of a nanometer.</summary>
    private const double Nothing = 1e-9;

    /// <summary>Breaks among waves are sought in so many values at most.</summary>
    private const int MostForBreaksInWaves = 300;

    /// <summary>The model of some values, of which there must be one at least.</summary>
    public static FieldModel Best(FieldData data)
    {
        // The models know nothing of each other: polynomials are sought and tried on one core, the others on a second. What both ask of the values is made before.
        _ = (data.Grid, data.Crossings, data.LinesOut);
        var search = Task.Run(() => Polynomials(data));
        var process = Unless(search, () => ProcessSearch.Run(data, ProcessSearch.Trend(2)));
        var linear = data.Count > MostForBreaksInWaves ? null : Unless(search, () => ProcessSearch.Run(data, ProcessSearch.Trend(1)));
        var spline = Unless(search, () => SplineModel.Run(data));
        var (polynomials, broken) = search.GetAwaiter().GetResult();
        if (IsPerfect(polynomials[^1]))
        {
            return polynomials[^1];
        }

        var smooth = Least([polynomials[0], linear, process, spline])!;
        if (process is not null && (polynomials.Count > 1 || smooth is ProcessModel) && !polynomials[^1].IsExact && data.Count <= MostForBreaksInWaves)
        {
            broken.Add(ProcessSearch.WithBreak(process));
        }

        return Least(broken.Where(m => m is not null && IsEarned(m, smooth))) ?? smooth;
    }

    /// <summary>The polynomials without breaks and with more and more, and those of them that have some, each also of squares alone; all of them tried.</summary>
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

    /// <summary>A model that is tried, unless a perfect polynomial is known already: then nobody asks for it.</summary>
    private static T? Unless<T>(Task<(IReadOnlyList<PolynomialModel> All, List<FieldModel?> Broken)> search, Func<T?> model)
        where T : FieldModel => search.IsCompletedSuccessfully && IsPerfect(search.Result.All[^1]) ? null : Tried(model());

    /// <summary>A model whose line-out error was found, where there is one.</summary>
    private static T? Tried<T>(T? model)
        where T : FieldModel
    {
        _ = model?.LineOut;
        return model;
    }

    /// <summary>True if breaks lower the line-out error enough; or, where noise hides the difference, if they do not raise it and say the same with half the freedom.</summary>
    private static bool IsEarned(FieldModel broken, FieldModel smooth) =>
        Error(broken) <= BreakShare * Error(smooth) || (Error(broken) <= Error(smooth) && broken.Freedom <= FreedomShare * smooth.Freedom);

    private static FieldModel? Least(IEnumerable<FieldModel?> models) => models.OfType<FieldModel>().MinBy(Error);

    /// <summary>The line-out error; that of a polynomial, whose terms are chosen anew without each line, is not less than what it leaves of the values it was fitted to: the choice from all of them may have been a poor one.</summary>
    private static double Error(FieldModel model)
    {
        if (double.IsNaN(model.LineOut))
        {
            return double.MaxValue;
        }

        return model is PolynomialModel polynomial ? Math.Max(model.LineOut, polynomial.MeanResidual) : model.LineOut;
    }
}
