namespace ErrorMatching.Mating;

/// <summary>Chooses the priors of a boundary's elements by the evidence of its key points. A curve has an amplitude and lengths of
/// correlation of its own. All lines, flanks and arcs of a job share the scale of their tilts and that of their form errors, because each
/// has too few points to tell.</summary>
/// <remarks>Each scale is a mean over a grid, weighted by the likelihood of the measured values (Rasmussen and Williams, 2006, section
/// 5.4.1). The shifts, and the linear mean of a curve, are vague, so the likelihood is the restricted one. The cost grows with the cube of
/// the number of key points in one run.</remarks>
internal static class PriorChoice
{
    private const int Amplitudes = 6, Lengths = 6, Tilts = 5, Errors = 5;

    /// <summary>Length of correlation of the form error of a line, flank or arc, as a part of its length.</summary>
    private const double FormLength = 0.25;

    /// <summary>The form error that is assumed where nothing tells one, as a part of the standard uncertainty.</summary>
    private const double LeastError = 0.25;

    /// <summary>Chooses the priors.</summary>
    /// <param name="elements">The elements of a run.</param>
    /// <param name="rows">What its key points say.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of a row.</param>
    /// <returns>The priors for the cuts, in which a line runs through its two points, because they say nothing else; and those for the
    /// uncertainty between key points, in which its form may be off by as much as that of the others.</returns>
    public static (DeviationPrior[] OfCuts, DeviationPrior[] OfPiece) Of(IReadOnlyList<BoundaryElement> elements, IReadOnlyList<BoundaryRow> rows, double uncertaintyMm)
    {
        var noise = Math.Max(uncertaintyMm, DeviationField.LeastUncertaintyMm);
        var own = elements.Select((_, e) => rows.Where(r => r.Terms.Count == 1 && r.Terms[0].Element == e).ToArray()).ToArray();
        var forms = elements.Select((element, e) => FormOf(element, own[e], noise)).ToArray();
        if (rows.Count == 0 || elements.All(e => e.Form == ElementForm.Free))
        {
            var vague = Priors(DeviationPrior.VagueMm, 0, isCut: true);
            return (vague, vague);
        }

        // The covariance is linear in the square of each scale.
        var largest = Math.Max(rows.Max(r => Math.Abs(r.ValueMm)), 4 * noise);
        var error = ErrorOf(elements, own, noise, largest);
        var (still, tilted) = (Covariance(0), Covariance(1));
        double[] values = [.. rows.Select(r => r.ValueMm)];
        var scale = MeanOf(Steps(noise, 2 * largest, Tilts), tilt => LogOf(still, tilted, tilt, values));
        return (Priors(scale, error, isCut: true), Priors(scale, error, isCut: false));

        double[] Covariance(double tilt) => DeviationField.CovarianceOf(Priors(tilt, error, isCut: true), rows, noise);

        DeviationPrior[] Priors(double tilt, double error, bool isCut) =>
            [
                .. elements.Select(
                    (element, e) => new DeviationPrior(element, tilt, noise, [.. own[e].Select(r => r.Terms[0].AlongMm)])
                    {
                        Form = element.Form == ElementForm.Free ? forms[e] : FormOf(element, isCut && own[e].Length == 2 ? LeastError * noise : error)
                    })];
    }

    // The scale of form errors, from the elements with more points than a line needs. Their tilts are vague, so that the likelihood is the
    // restricted one. Without such an element, nothing tells a form error.
    private static double ErrorOf(IReadOnlyList<BoundaryElement> elements, BoundaryRow[][] own, double noise, double largest)
    {
        var alone = new List<(double[] Smooth, double[] Rough, double[] Values)>();
        for (var e = 0; e < elements.Count; e++)
        {
            if (elements[e].Form != ElementForm.Free && own[e].Length > (elements[e].Form == ElementForm.Straight ? 2 : 3))
            {
                BoundaryRow[] rows = [.. own[e].Select(r => r with { Terms = [r.Terms[0] with { Element = 0 }] })];
                alone.Add((Covariance(elements[e], rows, 0), Covariance(elements[e], rows, 1), [.. rows.Select(r => r.ValueMm)]));
            }
        }

        double[] errors = [LeastError * noise, .. Steps(noise / 2, Math.Max(largest / 2, noise), Errors - 1)];
        return alone.Count == 0 ? errors[0] : MeanOf(errors, error => alone.Sum(a => LogOf(a.Smooth, a.Rough, error, a.Values)));

        double[] Covariance(BoundaryElement element, BoundaryRow[] rows, double error) => DeviationField.CovarianceOf(
            [new DeviationPrior(element, DeviationPrior.VagueMm, noise, []) { Form = FormOf(element, error) }], rows, noise);
    }

    private static (double, double)[] FormOf(BoundaryElement element, double error) =>
        [(error * error, FormLength * (element.ToMm - element.FromMm))];

    // The evidence of a scale, from the covariances for the scales 0 and 1.
    private static double LogOf(double[] without, double[] with, double scale, double[] values)
    {
        var covariance = new double[without.Length];
        for (var i = 0; i < covariance.Length; i++)
        {
            covariance[i] = without[i] + (scale * scale * (with[i] - without[i]));
        }

        return Evidence.Log(covariance, values);
    }

    // The mean of the logarithms of a scale, weighted by its evidence.
    private static double MeanOf(double[] scales, Func<double, double> log) =>
        Math.Exp(scales.Zip(Weights(scales.Select(log)), (s, w) => w * Math.Log(s)).Sum());

    // Amplitude and lengths of a curve's form.
    private static (double, double)[] FormOf(BoundaryElement element, BoundaryRow[] rows, double noise)
    {
        if (element is not { Form: ElementForm.Free, Degree: null } || rows.Length < 3)
        {
            return [];
        }

        double[] along = [.. rows.Select(r => r.Terms[0].AlongMm)];
        double[] values = [.. rows.Select(r => r.ValueMm)];
        var span = along.Max() - along.Min();
        var scatter = values.Max() - values.Min();
        var amplitudes = Steps(noise / 2, Math.Max(2 * scatter, 2 * noise), Amplitudes);
        BoundaryRow[] alone = [.. rows.Select(r => new BoundaryRow([r.Terms[0] with { Element = 0 }], r.ValueMm))];
        var flat = DeviationField.CovarianceOf([new DeviationPrior(element, 0, noise, along)], alone, noise);
        var (work, form) = (new double[flat.Length], new double[flat.Length]);
        var tried = new List<(double Length, double Amplitude, double Log)>();
        foreach (var length in Steps(0.5 * span / (rows.Length - 1), 1.5 * span, Lengths))
        {
            for (var i = 0; i < along.Length; i++)
            {
                for (var j = 0; j <= i; j++)
                {
                    form[(i * along.Length) + j] = DeviationPrior.Correlation(along[i] - along[j], length);
                }
            }

            foreach (var amplitude in amplitudes)
            {
                for (var i = 0; i < work.Length; i++)
                {
                    work[i] = flat[i] + (amplitude * amplitude * form[i]);
                }

                tried.Add((length, amplitude, Evidence.Log(work, values)));
            }
        }

        return
        [
            .. tried.Zip(Weights(tried.Select(t => t.Log))).GroupBy(t => t.First.Length).Select(g =>
            {
                var weight = g.Sum(t => t.Second);
                var amplitude = weight > 0 ? Math.Exp(g.Sum(t => t.Second * Math.Log(t.First.Amplitude)) / weight) : 0;
                return (weight * amplitude * amplitude, g.Key);
            }).Where(f => f.Item1 > 1e-6 * scatter * scatter)];
    }

    private static double[] Weights(IEnumerable<double> evidence)
    {
        double[] logs = [.. evidence];
        var best = logs.Max();
        double[] weights = [.. logs.Select(l => Math.Exp(l - best))];
        var sum = weights.Sum();
        return [.. weights.Select(w => w / sum)];
    }

    // Equal ratios from one value to another.
    private static double[] Steps(double from, double to, int count) =>
        [.. Enumerable.Range(0, count).Select(i => from * Math.Pow(to / from, (double)i / (count - 1)))];
}
