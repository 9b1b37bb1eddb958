namespace ErrorMatching.Freeform;

/// <summary>Finds the kernel of greatest likelihood: the best of a few starts, then a simplex. The same values give the same kernel.</summary>
internal static class ProcessSearch
{
    private const int MostEvaluations = 140;
    private const int PlacesPerCell = 3;

    // How near a break is brought to its place, on an axis of length 2: while the kernel still changes or a line is left out, and at last.
    private const double Roughly = 1e-5;
    private const double Closely = 1e-9;

    /// <summary>A break must lower the criterion by this much.</summary>
    private const double LeastGain = 10;

    /// <summary>The process with the best kernel; null if the values are too few or too many.</summary>
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

        double[]? best = null;
        var least = double.PositiveInfinity;
        foreach (var length in (ReadOnlySpan<double>)[0.3, 0.8, 2])
        {
            foreach (var noise in (ReadOnlySpan<double>)[-10, -4, -1])
            {
                double[] start = [Math.Log(length), Math.Log(length), noise];
                var value = Cost(trend, start);
                (best, least) = value < least ? (start, value) : (best, least);
            }
        }

        return best is null ? null : ProcessModel.Fit(few == data ? trend : ProcessTrend.Of(data, terms), Improved(trend, best));
    }

    /// <summary>A process about a polynomial with one break, which is moved to where the likelihood is greatest; null if no place is likely enough.</summary>
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
            best = model is not null && At(model) > lines[1] && At(model) < lines[^2] && model.Criterion < (best?.Criterion ?? smooth.Criterion - LeastGain) ? model : best;
        }

        return best;
    }

    /// <summary>The process with a break near a place, kernel and break brought in turn to where they are likeliest.</summary>
    private static ProcessModel? Tuned(FieldData data, BreakPlace place)
    {
        var model = Moved(data, place.Kernel, Covariance.Of(data, place.Kernel), place.AlongU, place.At, place.Reach, Roughly);
        for (var round = 0; round < 2 && model is not null; round++)
        {
            double[] start = [Math.Log(model.Kernel.LengthU), Math.Log(model.Kernel.LengthV), Math.Log10(model.Kernel.Noise)];
            var kernel = ProcessTrend.Of(data.Thinned(FieldData.EnoughLines), Broken(place.AlongU, At(model))) is { } trend ? Improved(trend, start) : KernelOf(start);
            model = Moved(data, kernel, Covariance.Of(data, kernel), place.AlongU, At(model), place.Reach / 2, round == 0 ? Roughly : Closely);
        }

        return model;
    }

    /// <summary>The same kernel over other values, the break moved within half a cell.</summary>
    public static ProcessModel? WithBreakMoved(ProcessModel model, FieldData other, Covariance covariance)
    {
        var alongU = model.BreaksU.Count > 0;
        return Moved(other, model.Kernel, covariance, alongU, At(model), 1.0 / ((alongU ? model.Data.Crossings : model.Data.Curves).Length - 1), Roughly);
    }

    private static double At(ProcessModel model) => model.BreaksU.Concat(model.BreaksV).Single();

    /// <summary>The two likeliest places, each with the kernel that makes it so: that of the process without a break has to bend where the break is, so longer waves are tried as well.</summary>
    private static BreakPlace[] Places(ProcessModel smooth, double[] linesU, double[] linesV)
    {
        var kernels = new List<Kernel> { smooth.Kernel };
        foreach (var length in (ReadOnlySpan<double>)[0.7, 1.5, 3])
        {
            kernels.AddRange([new(length, length, 1e-8), new(length, length, 1e-4)]);
        }

        // Half of them on a second core; in the order of kernels all the same.
        var half = kernels.Count / 2;
        var behind = Task.Run(() => Found(kernels[half..]));
        var likeliest = Found(kernels[..half]).Concat(behind.GetAwaiter().GetResult()).OrderBy(p => p.Criterion).ToArray();
        return [.. likeliest.Where((p, k) => !likeliest.Take(k).Any(q => q.AlongU == p.AlongU && Math.Abs(q.At - p.At) < 2 * p.Reach)).Take(2)];

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

    /// <summary>Places in the cells along one direction at which a break is likelier than at their neighbors.</summary>
    private static IEnumerable<BreakPlace> Scan(ProcessModel smooth, Kernel kernel, Covariance covariance, double[][] begun, bool alongU, double[] lines)
    {
        var places = new List<BreakPlace>();
        for (var cell = 1; cell + 2 < lines.Length; cell++)
        {
            for (var k = 0; k < PlacesPerCell; k++)
            {
                var reach = (lines[cell + 1] - lines[cell]) / PlacesPerCell;
                var at = lines[cell] + (reach * (k + 0.5));
                places.Add(new(kernel, alongU, at, reach, ProcessModel.Fit(ProcessTrend.Of(smooth.Data, Broken(alongU, at)), kernel, covariance, begun)?.Criterion ?? double.PositiveInfinity));
            }
        }

        return places.Where((p, k) => p.Criterion < smooth.Criterion - LeastGain && (k == 0 || p.Criterion <= places[k - 1].Criterion) && (k + 1 == places.Count || p.Criterion <= places[k + 1].Criterion));
    }

    /// <summary>The process with its break moved by less than a reach to where the criterion is least.</summary>
    private static ProcessModel? Moved(FieldData data, Kernel kernel, Covariance? covariance, bool alongU, double at, double reach, double tolerance)
    {
        if (covariance is null)
        {
            return null;
        }

        var begun = Begun(data, covariance);
        return Model(LineMinimum.Of(t => Model(t)?.Criterion ?? double.PositiveInfinity, at - reach, at + reach, tolerance));

        ProcessModel? Model(double t) => ProcessModel.Fit(ProcessTrend.Of(data, Broken(alongU, t)), kernel, covariance, begun);
    }

    /// <summary>A quadratic, and behind the break another one that meets it with its value and slope; how much it bends may change along the break.</summary>
    private static Term[] Broken(bool alongU, double at) =>
        [.. Trend(2), .. Enumerable.Range(0, 3).Select(p => alongU ? new Term(new(2, at), new(p)) : new Term(new(p), new(2, at)))];

    /// <summary>The quadratic, with which <see cref="Broken"/> begins wherever the break is, as a covariance solves it.</summary>
    private static double[][] Begun(FieldData data, Covariance covariance) => Array.ConvertAll(Term.Over(Trend(2), data.U, data.V), covariance.Solve);

    private static Kernel Improved(ProcessTrend trend, double[] start) =>
        KernelOf(Simplex.Minimum(x => Cost(trend, x), start, 0.7, MostEvaluations, 1e-3));

    /// <summary>The terms up to a total degree.</summary>
    public static Term[] Trend(int degree) =>
        [.. from a in Enumerable.Range(0, degree + 1) from b in Enumerable.Range(0, degree + 1 - a) select new Term(new(a), new(b))];

    private static double Cost(ProcessTrend trend, double[] x) => -(ProcessModel.Fit(trend, KernelOf(x))?.Likelihood ?? double.NegativeInfinity);

    private static Kernel KernelOf(double[] x) =>
        new(Math.Exp(Math.Clamp(x[0], -3, 3)), Math.Exp(Math.Clamp(x[1], -3, 3)), Math.Pow(10, Math.Clamp(x[2], -13, 2)));

    /// <summary>A place where a break may be.</summary>
    /// <param name="Kernel">The kernel that makes it likely.</param>
    /// <param name="AlongU">True for a value of u.</param>
    /// <param name="At">The value.</param>
    /// <param name="Reach">How far on either side it may be.</param>
    /// <param name="Criterion">That of the process with the break there.</param>
    private sealed record BreakPlace(Kernel Kernel, bool AlongU, double At, double Reach, double Criterion);
}
