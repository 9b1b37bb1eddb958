namespace ErrorMatching.Freeform;

/// <summary>Finds the kernel of greatest likelihood: the best of a few starts, then a simplex. The same values give the same kernel.</summary>
internal static class ProcessSearch
{
    private const int MostEvaluations = 140;
    private const int PlacesPerCell = 6;

    /// <summary>A break must lower the criterion by this much.</summary>
    private const double LeastGain = 10;

    /// <summary>The process with the best kernel; null if the values are too few or too many.</summary>
    public static ProcessModel? Run(FieldData data, Term[] trend)
    {
        if (!Covariance.IsPossible(data) || data.Count < trend.Length + 5)
        {
            return null;
        }

        var few = data.Thinned(FieldData.EnoughLines);
        double[]? best = null;
        var least = double.PositiveInfinity;
        foreach (var length in (ReadOnlySpan<double>)[0.3, 0.8, 2])
        {
            foreach (var noise in (ReadOnlySpan<double>)[-10, -4, -1])
            {
                double[] start = [Math.Log(length), Math.Log(length), noise];
                var value = Cost(few, start, trend);
                (best, least) = value < least ? (start, value) : (best, least);
            }
        }

        return best is null ? null : ProcessModel.Fit(data, Improved(few, best, trend), trend);
    }

    /// <summary>A process about a polynomial with one break, which is moved to where the likelihood is greatest; null if no place is likely enough.</summary>
    public static ProcessModel? WithBreak(ProcessModel smooth)
    {
        ProcessModel? best = null;
        var (linesU, linesV) = smooth.Data.LinePlaces();
        foreach (var place in Scan(smooth, true, linesU).Concat(Scan(smooth, false, linesV)).OrderBy(p => p.Criterion).Take(2).ToArray())
        {
            var (model, lines) = (Moved(smooth.Data, smooth.Kernel, place.AlongU, place.At, place.Reach), place.AlongU ? linesU : linesV);
            for (var round = 0; round < 2 && model is not null; round++)
            {
                var kernel = Improved(smooth.Data.Thinned(FieldData.EnoughLines), [Math.Log(model.Kernel.LengthU), Math.Log(model.Kernel.LengthV), Math.Log10(model.Kernel.Noise)], Broken(place.AlongU, At(model)));
                model = Moved(smooth.Data, kernel, place.AlongU, At(model), place.Reach / 2);
            }

            best = model is not null && At(model) > lines[1] && At(model) < lines[^2] && model.Criterion < (best?.Criterion ?? smooth.Criterion - LeastGain) ? model : best;
        }

        return best;
    }

    /// <summary>The same kernel over other values, the break moved within half a cell.</summary>
    public static ProcessModel? WithBreakMoved(ProcessModel model, FieldData other)
    {
        var alongU = model.BreaksU.Count > 0;
        return Moved(other, model.Kernel, alongU, At(model), 1.0 / ((alongU ? model.Data.Crossings : model.Data.Curves).Length - 1), 1e-5);
    }

    private static double At(ProcessModel model) => model.BreaksU.Concat(model.BreaksV).Single();

    /// <summary>Places in the cells along one direction at which a break is likelier than at their neighbors.</summary>
    private static IEnumerable<(bool AlongU, double At, double Reach, double Criterion)> Scan(ProcessModel smooth, bool alongU, double[] lines)
    {
        var places = new List<(bool AlongU, double At, double Reach, double Criterion)>();
        for (var cell = 1; cell + 2 < lines.Length; cell++)
        {
            for (var k = 0; k < PlacesPerCell; k++)
            {
                var reach = (lines[cell + 1] - lines[cell]) / PlacesPerCell;
                var at = lines[cell] + (reach * (k + 0.5));
                places.Add((alongU, at, reach, ProcessModel.Fit(smooth.Data, smooth.Kernel, Broken(alongU, at))?.Criterion ?? double.PositiveInfinity));
            }
        }

        return places.Where((p, k) => p.Criterion < smooth.Criterion - LeastGain && (k == 0 || p.Criterion <= places[k - 1].Criterion) && (k + 1 == places.Count || p.Criterion <= places[k + 1].Criterion));
    }

    /// <summary>The process with its break moved by less than a reach, by golden sections.</summary>
    private static ProcessModel? Moved(FieldData data, Kernel kernel, bool alongU, double at, double reach, double tolerance = 1e-9)
    {
        var share = (Math.Sqrt(5) - 1) / 2;
        var (low, high) = (at - reach, at + reach);
        var (left, right) = (high - (share * (high - low)), low + (share * (high - low)));
        var (atLeft, atRight) = (Value(left), Value(right));
        while (high - low > tolerance)
        {
            if (atLeft < atRight)
            {
                (high, right, atRight) = (right, left, atLeft);
                left = high - (share * (high - low));
                atLeft = Value(left);
            }
            else
            {
                (low, left, atLeft) = (left, right, atRight);
                right = low + (share * (high - low));
                atRight = Value(right);
            }
        }

        return ProcessModel.Fit(data, kernel, Broken(alongU, (low + high) / 2));

        double Value(double t) => ProcessModel.Fit(data, kernel, Broken(alongU, t))?.Criterion ?? double.PositiveInfinity;
    }

    /// <summary>A quadratic, and behind the break another one that meets it with its value and slope; how much it bends may change along the break.</summary>
    private static Term[] Broken(bool alongU, double at) =>
        [.. Trend(2), .. Enumerable.Range(0, 3).Select(p => alongU ? new Term(new(2, at), new(p)) : new Term(new(p), new(2, at)))];

    private static Kernel Improved(FieldData data, double[] start, Term[] trend) =>
        KernelOf(Simplex.Minimum(x => Cost(data, x, trend), start, 0.7, MostEvaluations, 1e-3));

    /// <summary>The terms up to a total degree.</summary>
    public static Term[] Trend(int degree) =>
        [.. from a in Enumerable.Range(0, degree + 1) from b in Enumerable.Range(0, degree + 1 - a) select new Term(new(a), new(b))];

    private static double Cost(FieldData data, double[] x, Term[] trend) => -(ProcessModel.Fit(data, KernelOf(x), trend)?.Likelihood ?? double.NegativeInfinity);

    private static Kernel KernelOf(double[] x) =>
        new(Math.Exp(Math.Clamp(x[0], -3, 3)), Math.Exp(Math.Clamp(x[1], -3, 3)), Math.Pow(10, Math.Clamp(x[2], -13, 2)));
}
