using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Chooses the priors of a boundary's stretches by the evidence of its key points. A curve has an amplitude and lengths of
/// correlation of its own. All lines, flanks and arcs of a job share the scale of their tilts and that of their form errors, because each
/// has too few points to tell.</summary>
/// <remarks>Each scale is a mean over a grid, weighted by the likelihood of the measured values (Rasmussen and Williams, 2006, section
/// 5.4.1). The shifts, and the linear mean of a curve, are vague, so the likelihood is the restricted one. The cost grows with the cube of
/// the number of key points in one run, up to a limit.</remarks>
internal static class PriorChoice
{
    private const int Amplitudes = 6, Lengths = 6, Tilts = 5, Errors = 5;

    // Lengths of correlation of the form error of a line, flank or arc, as parts of its length. The shortest one is shorter than the usual
    // distance of two key points: it stands for an error that each point has by itself.
    private static readonly double[] _formLengths = [0.03, 0.12, 0.25, 0.5];

    // The middle of a bow is hardly correlated with its ends.
    private const double StatedFormLength = 0.25;

    /// <summary>The form error that is assumed where nothing tells one, as a part of the standard uncertainty.</summary>
    private const double LeastError = 0.25;

    // Scales are chosen from no more rows than these, evenly taken; more say the same.
    private const int MostRows = 120;

    // A length with less evidence takes no part.
    private const double LeastWeight = 0.01;

    /// <summary>Chooses the priors.</summary>
    /// <param name="stretches">The stretches of a run.</param>
    /// <param name="rows">What its key points say.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of a row.</param>
    /// <returns>The priors for the cuts, in which a line runs through its two points, because they say nothing else; and those for the
    /// uncertainty between key points, in which its form may be off by as much as that of the others.</returns>
    public static (DeviationPrior[] OfCuts, DeviationPrior[] OfPiece) Of(
        IReadOnlyList<Stretch> stretches, IReadOnlyList<BoundaryRow> rows, double uncertaintyMm)
    {
        var noise = Math.Max(uncertaintyMm, DeviationField.LeastUncertaintyMm);
        rows = Thinned(rows);
        var own = stretches.Select((_, e) => rows.Where(r => r.Terms.Count == 1 && r.Terms[0].Stretch == e).ToArray()).ToArray();
        var forms = stretches.Select((stretch, e) => FormOf(stretch, own[e], noise)).ToArray();
        if (rows.Count == 0 || stretches.All(e => e.Form == ElementForm.Free))
        {
            var vague = Priors(DeviationPrior.VagueMm, LeastForm(noise), isCut: true);
            return (vague, vague);
        }

        // The covariance is linear in the square of each scale.
        var largest = Math.Max(rows.Max(r => Math.Abs(r.ValueMm)), 4 * noise);
        var form = FormOfStraight(stretches, own, noise, largest);
        var (still, tilted) = (Covariance(0), Covariance(1));
        double[] values = [.. rows.Select(r => r.ValueMm)];
        var scale = MeanOf(Steps(noise, 2 * largest, Tilts), tilt => LogOf(still, tilted, tilt, values));
        return (Priors(scale, form, isCut: true), Priors(scale, form, isCut: false));

        double[] Covariance(double tilt) => DeviationField.CovarianceOf(Priors(tilt, form, isCut: true), rows, noise);

        DeviationPrior[] Priors(double tilt, IReadOnlyList<(double Variance, double Part)> form, bool isCut) =>
            [
                .. stretches.Select(
                    (stretch, e) => new DeviationPrior(stretch, tilt, noise, [.. own[e].Select(r => r.Terms[0].AlongMm)])
                    {
                        Form = stretch.Form == ElementForm.Free ? forms[e]
                            : FormOf(
                                stretch,
                                isCut && own[e].Length == 2 ? LeastForm(noise)
                                    : stretch.FormMm is { } mm ? [(mm * mm, StatedFormLength)] : form)
                    })];
    }

    // The form errors of lines, flanks and arcs, from those with more points than they need. Their tilts are vague, so that the likelihood
    // is the restricted one. Without such a stretch, nothing tells a form error.
    private static IReadOnlyList<(double Variance, double Part)> FormOfStraight(
        IReadOnlyList<Stretch> stretches, BoundaryRow[][] own, double noise, double largest)
    {
        var alone = new List<StraightRows>();
        for (var e = 0; e < stretches.Count; e++)
        {
            if (stretches[e].Form != ElementForm.Free && own[e].Length > (stretches[e].Form == ElementForm.Straight ? 2 : 3))
            {
                BoundaryRow[] rows = [.. own[e].Select(r => r with { Terms = [r.Terms[0] with { Stretch = 0 }] })];
                alone.Add(new(stretches[e], rows, Covariance(stretches[e], rows, []), [.. rows.Select(r => r.ValueMm)]));
            }
        }

        if (alone.Count == 0)
        {
            return LeastForm(noise);
        }

        double[] errors = [LeastError * noise, .. Steps(noise / 2, Math.Max(largest / 2, noise), Errors - 1)];
        return Mixture([.. _formLengths.SelectMany(part =>
        {
            double[][] rough = [.. alone.Select(a => Covariance(a.Element, a.Rows, [(1, part)]))];
            return errors.Select(
                error => new TriedForm(part, error, alone.Select((a, i) => LogOf(a.Smooth, rough[i], error, a.Values)).Sum()));
        })]);

        double[] Covariance(Stretch stretch, BoundaryRow[] rows, IReadOnlyList<(double, double)> form) =>
            DeviationField.CovarianceOf(
                [new DeviationPrior(stretch, DeviationPrior.VagueMm, noise, []) { Form = FormOf(stretch, form) }], rows, noise);
    }

    private static IReadOnlyList<(double Variance, double Part)> LeastForm(double noise) =>
        [(Elementary.Pow(LeastError * noise, 2), _formLengths[2])];

    private static (double, double)[] FormOf(Stretch stretch, IReadOnlyList<(double Variance, double Part)> form) =>
        [.. form.Select(f => (f.Variance, f.Part * (stretch.ToMm - stretch.FromMm)))];

    // For each length, the mean of the logarithms of the scale; all of them weighted by their evidence.
    private static List<(double Variance, double Length)> Mixture(IReadOnlyList<TriedForm> tried)
    {
        var weights = Weights(tried.Select(t => t.Log));
        var form = new List<(double Variance, double Length)>();
        for (var from = 0; from < tried.Count;)
        {
            var (length, weight, sum) = (tried[from].Length, 0.0, 0.0);
            for (; from < tried.Count && tried[from].Length == length; from++)
            {
                weight += weights[from];
                sum += weights[from] * Elementary.Log(tried[from].Scale);
            }

            var scale = weight > 0 ? Elementary.Exp(sum / weight) : 0;
            if (weight > LeastWeight)
            {
                form.Add((weight * scale * scale, length));
            }
        }

        return form;
    }

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
        Elementary.Exp(Weights(scales.Select(log)).Select((w, i) => w * Elementary.Log(scales[i])).Sum());

    // Amplitude and lengths of a curve's form.
    private static List<(double Variance, double Length)> FormOf(Stretch stretch, BoundaryRow[] rows, double noise)
    {
        if (stretch is not { Form: ElementForm.Free, Degree: null } || rows.Length < 3)
        {
            return [];
        }

        double[] along = [.. rows.Select(r => r.Terms[0].AlongMm)];
        double[] values = [.. rows.Select(r => r.ValueMm)];
        var span = along.Max() - along.Min();
        var scatter = values.Max() - values.Min();
        var amplitudes = Steps(noise / 2, Math.Max(2 * scatter, 2 * noise), Amplitudes);
        BoundaryRow[] alone = [.. rows.Select(r => new BoundaryRow([r.Terms[0] with { Stretch = 0 }], r.ValueMm))];
        var flat = DeviationField.CovarianceOf([new DeviationPrior(stretch, 0, noise, along)], alone, noise);
        var (work, form) = (new double[flat.Length], new double[flat.Length]);
        var tried = new List<TriedForm>();
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

                tried.Add(new(length, amplitude, Evidence.Log(work, values)));
            }
        }

        return Mixture(tried);
    }

    private static IReadOnlyList<BoundaryRow> Thinned(IReadOnlyList<BoundaryRow> rows) => rows.Count <= MostRows ? rows
        : [.. Enumerable.Range(0, MostRows).Select(i => rows[(int)((long)i * (rows.Count - 1) / (MostRows - 1))])];

    private static double[] Weights(IEnumerable<double> evidence)
    {
        double[] logs = [.. evidence];
        var best = logs.Max();
        double[] weights = [.. logs.Select(l => Elementary.Exp(l - best))];
        var sum = weights.Sum();
        return [.. weights.Select(w => w / sum)];
    }

    // Equal ratios from one value to another.
    private static double[] Steps(double from, double to, int count) =>
        [.. Enumerable.Range(0, count).Select(i => from * Elementary.Pow(to / from, (double)i / (count - 1)))];

    // A line, a flank or an arc with more points than it needs: what they say, and their covariance without form errors.
    private sealed record StraightRows(Stretch Element, BoundaryRow[] Rows, double[] Smooth, double[] Values);

    // A form error that was tried: its length, its scale, and the logarithm of its evidence.
    private sealed record TriedForm(double Length, double Scale, double Log);
}
