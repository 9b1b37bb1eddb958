using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Finds the kernel of greatest likelihood: the best of a few starts, refined by a simplex. It is deterministic.</summary>
internal static class ProcessSearch
{
    private const int MostEvaluations = 140;
    private const int PlacesPerCell = 3;

    // Largest variance of a wave as a multiple of the mean square of the values about the polynomial.
    private const double MostWave = 4;

    // A shape is refined if its best start is at most this much less likely than the smooth kernel, and taken if it is likelier by the
    // lead, as logarithms.
    private const double Promising = 10;
    private const double LeastLead = 2;

    // Tolerance of a break on an axis of length 2: while the kernel still changes or a line is left out, and for the result.
    private const double Roughly = 1e-5;
    private const double Closely = 1e-9;

    /// <summary>Minimum reduction of the criterion by a break.</summary>
    private const double LeastGain = 10;

    /// <summary>Returns the smooth process with the best kernel; null if there are too few or too many values.</summary>
    public static ProcessModel? Run(FieldData data, Term[] terms)
    {
        if (!Covariance.IsPossible(data) || data.Count < terms.Length + 5)
        {
            return null;
        }

        var few = data.Thinned(FieldData.EnoughLines);
        if (ProcessTrend.Of(few, terms) is not { } trend)
        {
            return null;
        }

        var (start, _) = Start(trend, KernelShape.Smooth);
        return start is null
            ? null
            : ProcessModel.Fit(few == data ? trend : ProcessTrend.Of(data, terms), Improved(trend, KernelShape.Smooth, start));
    }

    /// <summary>Returns a process about the same polynomial with a kernel of another shape; null if none is likely enough.</summary>
    /// <remarks>The likelihoods are compared with Akaike's penalty for each parameter.</remarks>
    public static ProcessModel? OfOtherShape(ProcessModel smooth)
    {
        var trend = smooth.Trend;
        var (best, least) = ((ProcessModel?)null, -smooth.Likelihood - LeastLead);
        foreach (var shape in KernelShape.Others)
        {
            var (start, cost) = Start(trend, shape);
            if (start is not null
                && cost < Promising - smooth.Likelihood
                && ProcessModel.Fit(trend, Improved(trend, shape, start)) is { } model
                && shape.MoreParameters - model.Likelihood < least)
            {
                (best, least) = (model, shape.MoreParameters - model.Likelihood);
            }
        }

        return best;
    }

    private static (double[]? X, double Cost) Start(ProcessTrend trend, KernelShape shape)
    {
        var (start, least) = ((double[]?)null, double.PositiveInfinity);
        foreach (var x in shape.Starts(trend))
        {
            var cost = Cost(trend, shape, x);
            (start, least) = cost < least ? (x, cost) : (start, least);
        }

        return (start, least);
    }

    /// <summary>Returns a process about a polynomial with one break at the greatest likelihood; null if none is likely enough.</summary>
    public static ProcessModel? WithBreak(ProcessModel smooth)
    {
        var (linesU, linesV) = smooth.Data.LinePlaces();
        var places = Places(smooth, linesU, linesV);
        var second = Task.Run(() => places.Length > 1 ? Tuned(smooth.Data, places[1]) : null);
        var models = new[] { places.Length > 0 ? Tuned(smooth.Data, places[0]) : null, second.GetAwaiter().GetResult() };
        ProcessModel? best = null;
        for (var k = 0; k < places.Length; k++)
        {
            var (model, lines) = (models[k], places[k].AlongU ? linesU : linesV);
            best = model is not null
                && At(model) > lines[1]
                && At(model) < lines[^2]
                && model.Criterion < (best?.Criterion ?? smooth.Criterion - LeastGain)
                ? model
                : best;
        }

        return best;
    }

    /// <summary>Optimizes the kernel and the break near a place alternately.</summary>
    private static ProcessModel? Tuned(FieldData data, BreakPlace place)
    {
        var model = Moved(data, place.Kernel, Covariance.Of(data, place.Kernel), place.AlongU, place.At, place.Reach, Roughly);
        for (var round = 0; round < 2 && model is not null; round++)
        {
            var last = model.Kernel;
            double[] start = [Elementary.Log(last.LengthU), Elementary.Log(last.LengthV), Elementary.Log10(last.Noise)];
            var kernel = ProcessTrend.Of(data.Thinned(FieldData.EnoughLines), Broken(place.AlongU, At(model))) is { } trend
                ? Improved(trend, KernelShape.Smooth, start)
                : KernelShape.Smooth.Of(start, data);
            model = Moved(
                data, kernel, Covariance.Of(data, kernel), place.AlongU, At(model), place.Reach / 2, round == 0 ? Roughly : Closely);
        }

        return model;
    }

    /// <summary>Fits the same kernel to other values, moving the break within half a cell.</summary>
    public static ProcessModel? WithBreakMoved(ProcessModel model, FieldData other, Covariance covariance)
    {
        var alongU = model.BreaksU.Count > 0;
        return Moved(
            other,
            model.Kernel,
            covariance,
            alongU,
            At(model),
            1.0 / ((alongU ? model.Data.Crossings : model.Data.Curves).Length - 1),
            Roughly);
    }

    private static double At(ProcessModel model) => model.BreaksU.Concat(model.BreaksV).Single();

    /// <summary>Returns the two likeliest places, each with its kernel. The kernel without a break has to bend at the break, so longer
    /// waves are tried too.</summary>
    private static BreakPlace[] Places(ProcessModel smooth, double[] linesU, double[] linesV)
    {
        var kernels = new List<Kernel> { smooth.Kernel };
        foreach (var length in (ReadOnlySpan<double>)[0.7, 1.5, 3])
        {
            kernels.AddRange([new(length, length, 1e-8), new(length, length, 1e-4)]);
        }

        // Half of them run on a second core. The order of the kernels is preserved.
        var half = kernels.Count / 2;
        var behind = Task.Run(() => Found(kernels[half..]));
        var likeliest = Found(kernels[..half]).Concat(behind.GetAwaiter().GetResult()).OrderBy(p => p.Criterion).ToArray();
        return [
            .. likeliest.Where((p, k) => !likeliest.Take(k).Any(q => q.AlongU == p.AlongU && Math.Abs(q.At - p.At) < 2 * p.Reach)).Take(2)];

        List<BreakPlace> Found(List<Kernel> some)
        {
            var found = new List<BreakPlace>();
            foreach (var kernel in some)
            {
                if (Covariance.Of(smooth.Data, kernel) is { } covariance)
                {
                    var begun = Begun(smooth.Data, covariance);
                    found.AddRange(Scan(smooth, kernel, covariance, begun, true, linesU));
                    found.AddRange(Scan(smooth, kernel, covariance, begun, false, linesV));
                }
            }

            return found;
        }
    }

    /// <summary>Finds places in the cells along one direction where a break is likelier than at the neighbors.</summary>
    private static IEnumerable<BreakPlace> Scan(
        ProcessModel smooth, Kernel kernel, Covariance covariance, double[][] begun, bool alongU, double[] lines)
    {
        var places = new List<BreakPlace>();
        for (var cell = 1; cell + 2 < lines.Length; cell++)
        {
            for (var k = 0; k < PlacesPerCell; k++)
            {
                var reach = (lines[cell + 1] - lines[cell]) / PlacesPerCell;
                var at = lines[cell] + (reach * (k + 0.5));
                places.Add(new(
                    kernel,
                    alongU,
                    at,
                    reach,
                    ProcessModel.Fit(ProcessTrend.Of(smooth.Data, Broken(alongU, at)), kernel, covariance, begun)?.Criterion
                        ?? double.PositiveInfinity));
            }
        }

        return places.Where(
            (p, k) => p.Criterion < smooth.Criterion - LeastGain
                && (k == 0 || p.Criterion <= places[k - 1].Criterion)
                && (k + 1 == places.Count || p.Criterion <= places[k + 1].Criterion));
    }

    /// <summary>Fits the process with its break at the least criterion within a reach.</summary>
    private static ProcessModel? Moved(
        FieldData data, Kernel kernel, Covariance? covariance, bool alongU, double at, double reach, double tolerance)
    {
        if (covariance is null)
        {
            return null;
        }

        var begun = Begun(data, covariance);
        return Model(LineMinimum.Find(t => Model(t)?.Criterion ?? double.PositiveInfinity, at - reach, at + reach, tolerance));

        ProcessModel? Model(double t) => ProcessModel.Fit(ProcessTrend.Of(data, Broken(alongU, t)), kernel, covariance, begun);
    }

    /// <summary>A quadratic, and beyond the break another one with the same value and slope there. The change of curvature may vary along
    /// the break.</summary>
    private static Term[] Broken(bool alongU, double at) =>
        [.. Trend(2), .. Enumerable.Range(0, 3).Select(p => alongU ? new Term(new(2, at), new(p)) : new Term(new(p), new(2, at)))];

    /// <summary>The covariance's solutions for the quadratic, with which <see cref="Broken"/> starts for every break.</summary>
    private static double[][] Begun(FieldData data, Covariance covariance) =>
        Array.ConvertAll(Term.Over(Trend(2), data.U, data.V), covariance.Solve);

    private static Kernel Improved(ProcessTrend trend, KernelShape shape, double[] start) =>
        shape.Of(
            Simplex.Minimum(x => Cost(trend, shape, x), start, 0.7, shape.IsWave ? 2 * MostEvaluations : MostEvaluations, 1e-3),
            trend.Data);

    public static Term[] Trend(int degree) =>
        [.. from a in Enumerable.Range(0, degree + 1) from b in Enumerable.Range(0, degree + 1 - a) select new Term(new(a), new(b))];

    private static double Cost(ProcessTrend trend, KernelShape shape, double[] x) => Cost(trend, shape.Of(x, trend.Data));

    private static double Cost(ProcessTrend trend, Kernel kernel) =>
        ProcessModel.Fit(trend, kernel) is { } model && !IsHidden(model, trend) ? -model.Likelihood : double.PositiveInfinity;

    /// <summary>True for a wave far higher than the values show: they would all lie near its zeros, and between them nothing speaks for
    /// it.</summary>
    private static bool IsHidden(ProcessModel model, ProcessTrend trend) =>
        (model.Kernel.WaveU > 0 || model.Kernel.WaveV > 0)
            && model.Variance > MostWave * trend.Ordinary.SquareSum / trend.Data.Count;

    /// <summary>A candidate for a break.</summary>
    /// <param name="Kernel">The kernel for which it is likely.</param>
    /// <param name="AlongU">True for a break in u.</param>
    /// <param name="At">Its parameter.</param>
    /// <param name="Reach">The distance to search on either side.</param>
    /// <param name="Criterion">The criterion of the process with this break.</param>
    private sealed record BreakPlace(Kernel Kernel, bool AlongU, double At, double Reach, double Criterion);
}
