namespace ErrorMatching.Mating;

/// <summary>Chooses the priors of a boundary's elements by the evidence of its key points. A curve has an amplitude and lengths of
/// correlation of its own. All lines, flanks and arcs of a job share the scale of their tilts and that of their form errors, because each
/// has too few points to tell.</summary>
/// <remarks>Each scale is a mean over a grid, weighted by the likelihood of the measured values (Rasmussen and Williams, 2006, section
/// 5.4.1). The shifts, and the linear mean of a curve, are vague, so the likelihood is the restricted one.</remarks>
internal static class PriorChoice
{
    private const int Amplitudes = 7, Lengths = 7;

    // Form errors of straight elements: of their scale, mm, and how long they are compared with the element.
    private const double FormLength = 0.4;

    /// <summary>Chooses the priors.</summary>
    public static DeviationPrior[] Of(IReadOnlyList<BoundaryElement> elements, IReadOnlyList<BoundaryRow> rows, double uncertaintyMm)
    {
        var noise = Math.Max(uncertaintyMm, DeviationField.LeastUncertaintyMm);
        var own = elements.Select((_, e) => rows.Where(r => r.Terms.Count == 1 && r.Terms[0].Element == e).ToArray()).ToArray();
        var forms = elements.Select(
            (element, e) => element is { Form: ElementForm.Free, Degree: null } ? FormOf(element, own[e], noise) : []).ToArray();
        if (elements.All(e => e.Form == ElementForm.Free))
        {
            return Priors(elements, forms, own, DeviationPrior.VagueMm, 0, noise);
        }

        var largest = Math.Max(rows.Max(r => Math.Abs(r.ValueMm)), 4 * noise);
        var tilts = Steps(noise, 2 * largest, 6);
        double[] errors = [0.25 * noise, .. Steps(0.5 * noise, Math.Max(largest / 2, noise), 5)];
        var tried = tilts.SelectMany(tilt => errors.Select(error => (tilt, error))).Select(
            t => (t.tilt, t.error, new DeviationField(Priors(elements, forms, own, t.tilt, t.error, noise), rows, noise).LogEvidence)).ToArray();
        var weights = Weights(tried.Select(t => t.LogEvidence));
        return Priors(
            elements,
            forms,
            own,
            Math.Exp(tried.Zip(weights, (t, w) => w * Math.Log(t.tilt)).Sum()),
            Math.Exp(tried.Zip(weights, (t, w) => w * Math.Log(t.error)).Sum()),
            noise);
    }

    private static DeviationPrior[] Priors(
        IReadOnlyList<BoundaryElement> elements,
        IReadOnlyList<(double, double)>[] forms,
        BoundaryRow[][] own,
        double tilt,
        double error,
        double noise) =>
        [
            .. elements.Select(
                (element, e) => new DeviationPrior(element, tilt, noise, Math.Max(1, own[e].Length))
                {
                    Form = element.Form == ElementForm.Free ? forms[e]
                        : [(error * error, FormLength * (element.ToMm - element.FromMm))],
                })];

    // Amplitude and lengths of a curve's form.
    private static (double, double)[] FormOf(BoundaryElement element, BoundaryRow[] rows, double noise)
    {
        if (rows.Length < 3)
        {
            return [];
        }

        double[] along = [.. rows.Select(r => r.Terms[0].AlongMm).Order()];
        var span = along[^1] - along[0];
        var spacing = span / (rows.Length - 1);
        var scatter = rows.Max(r => r.ValueMm) - rows.Min(r => r.ValueMm);
        var amplitudes = Steps(noise / 2, Math.Max(2 * scatter, 2 * noise), Amplitudes);
        var lengths = Steps(0.5 * spacing, 1.5 * span, Lengths);
        BoundaryRow[] alone = [.. rows.Select(r => new BoundaryRow([r.Terms[0] with { Element = 0 }], r.ValueMm))];
        var tried = lengths.SelectMany(length => amplitudes.Select(amplitude => (length, amplitude))).Select(t =>
        {
            var prior = new DeviationPrior(element, 0, noise, rows.Length) { Form = [(t.amplitude * t.amplitude, t.length)] };
            return (t.length, t.amplitude, new DeviationField([prior], alone, noise).LogEvidence);
        }).ToArray();
        var weights = Weights(tried.Select(t => t.LogEvidence));
        return
        [
            .. tried.Zip(weights).GroupBy(t => t.First.length).Select(g =>
            {
                var weight = g.Sum(t => t.Second);
                var amplitude = weight > 0 ? Math.Exp(g.Sum(t => t.Second * Math.Log(t.First.amplitude)) / weight) : 0;
                return (weight * amplitude * amplitude, g.Key);
            }).Where(f => f.Item1 > 0)];
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
