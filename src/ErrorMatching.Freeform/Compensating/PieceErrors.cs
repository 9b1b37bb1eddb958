using System.Globalization;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>The errors of one measured piece.</summary>
/// <param name="Sha256">SHA-256 of its measurement.</param>
/// <param name="Alignment">The alignment of the points to the surface; null if they were not moved.</param>
/// <param name="Samples">The error at each point; the mean if it was measured several times.</param>
internal sealed record PieceErrors(string Sha256, SurfaceAlignment? Alignment, IReadOnlyList<ErrorSample> Samples)
{
    /// <summary>Finds the errors, or the reason why the measurement must not be compensated.</summary>
    /// <param name="measured">The measurements of the piece, at least one.</param>
    /// <param name="job">The job.</param>
    /// <param name="nominal">The nominal surface.</param>
    /// <param name="notes">Gets notes.</param>
    /// <param name="warnings">Gets warnings.</param>
    /// <exception cref="InputException">A point has no foot, or there are too few for the alignment.</exception>
    public static Outcome<PieceErrors> Find(
        IReadOnlyList<MeasuredPoints> measured, FreeformJob job, PartSurface nominal, List<string> notes, List<ReportWarning> warnings)
    {
        if (WithoutUnknown(measured, job) is { } unknown)
        {
            return unknown;
        }

        var stock = job.Stock.Of(job.Measuring.After);
        measured = [
            .. measured.Select(m => m with { Points = [.. m.Points.Where(p => !job.Measuring.Without.Contains(p.Planned.Number))] })];
        var alignment = job.Measuring.BestFit
            ? SurfaceAlignment.BestFit(
                nominal, [.. measured.SelectMany(m => m.Points).Select(p => (p.Planned, p.Contact))], stock, measured[0].File)
            : null;
        var repeats = measured.Select(m => SurfaceErrors.Find(
            nominal, m.Points.Select(p => (p.Planned, alignment?.Apply(p.Contact) ?? p.Contact)), stock, m.File)).ToArray();
        for (var k = 0; k < repeats.Length; k++)
        {
            if (OtherStage(repeats[k], measured[k].File, job, stock) is { } other)
            {
                return other;
            }
        }

        var samples = repeats.Length == 1 ? repeats[0] : Average(repeats, notes, warnings);
        if (BeyondLimit(samples, job, stock) is { } refusal)
        {
            return refusal;
        }

        return Outlying(samples, repeats, measured, job.Measuring.UncertaintyMm) is { } outlying
            ? outlying
            : new PieceErrors(MeasuredPoints.Sha256Of(measured), alignment, samples);
    }

    // A number that no point has would leave the bad touch in.
    private static Refusal? WithoutUnknown(IReadOnlyList<MeasuredPoints> measured, FreeformJob job)
    {
        int[] unknown = [.. job.Measuring.Without.Except(measured[0].Points.Select(p => p.Planned.Number))];
        return unknown.Length == 0 ? null : new("unknown-point", string.Create(
            CultureInfo.InvariantCulture,
            $"measuring.without names point {unknown[0]}, and the plan has points 1 to {measured[0].Points.Count}."));
    }

    /// <summary>A length with enough digits to show that it exceeds its limit.</summary>
    public static string Beyond(double mm, double limitMm)
    {
        var limit = limitMm.ToString("0.####", CultureInfo.InvariantCulture);
        for (var digits = 4; digits < 10; digits++)
        {
            var format = "0." + new string('#', digits);
            if (Math.Abs(mm).ToString(format, CultureInfo.InvariantCulture) is var text && text != limit)
            {
                return mm.ToString($"+{format};-{format}", CultureInfo.InvariantCulture);
            }
        }

        return mm.ToString("R", CultureInfo.InvariantCulture);
    }

    // Mirroring missing or remaining stock as if it were an error would spoil the piece.
    private static Refusal? OtherStage(IReadOnlyList<ErrorSample> samples, string file, FreeformJob job, double stock)
    {
        var mean = samples.Sum(s => s.ErrorMm) / samples.Count;
        var found = MeasuredStage.Of(job, mean + stock);
        return found == job.Measuring.After ? null : new("other-stage", string.Create(
            CultureInfo.InvariantCulture,
            $"The points of {file} lie {mean:+0.0000;-0.0000} mm from the surface after {MeasuredStage.Name(job.Measuring.After)}, in "
                + $"the mean, and so on the surface after {MeasuredStage.Name(found)}: the stock of {job.Stock.SemiFinishingMm:0.###} mm "
                + $"would be taken for an error. Give what was measured after {MeasuredStage.Name(job.Measuring.After)}, or change "
                + $"measuring.measuredAfter."));
    }

    private static Refusal? BeyondLimit(IReadOnlyList<ErrorSample> samples, FreeformJob job, double stock)
    {
        var beyond = samples.Where(s => Math.Abs(s.ErrorMm) > job.Compensation.LimitMm).ToArray();
        if (beyond.Length == 0)
        {
            return null;
        }

        var worst = beyond.MaxBy(s => Math.Abs(s.ErrorMm))!;
        var hint = beyond.Length > samples.Count / 2
            ? $" Most points are off: check the work offset, measuring.reports, and measuring.measuredAfter, which says that "
                + $"{(stock > 0 ? string.Create(CultureInfo.InvariantCulture, $"{stock:0.###} mm of stock lie") : "no stock lies")} on "
                + $"the surface."
            : " Touch it again, or look for a chip or a wrong probe.";
        return new("beyond-limit", string.Create(
            CultureInfo.InvariantCulture,
            $"Point {worst.Point} is {Beyond(worst.ErrorMm, job.Compensation.LimitMm)} mm off along the "
                + $"normal{(beyond.Length > 1 ? $", and {beyond.Length - 1} more points are too" : "")}; compensation.limitMm allows "
                + $"{job.Compensation.LimitMm:0.####} mm.{hint}"));
    }

    // Checked before fitting: neither fit nor noise test can tell a bad touch from a surface error, and it would be cut into the piece.
    private static Refusal? Outlying(
        IReadOnlyList<ErrorSample> samples,
        IReadOnlyList<ErrorSample>[] repeats,
        IReadOnlyList<MeasuredPoints> measured,
        double uncertaintyMm)
    {
        var points = OutlyingPoints.Find(samples, uncertaintyMm / Math.Sqrt(repeats.Length));
        if (points.Count == 0)
        {
            return null;
        }

        var worst = OutlyingPoint.Furthest(points);
        var off = Array.ConvertAll(repeats, r => Math.Abs(r.First(s => s.Point == worst.Sample.Point).ErrorMm - worst.SaidMm));
        var (place, mean) = repeats.Length == 1
            ? ("", "")
            : ($" {measured[Array.IndexOf(off, off.Max())].File} is furthest off there.", ", in the mean of all measurements");
        return new(
            "outlying-point",
            $"{OutlyingPoint.Words(points)}{mean}: a chip, or a touch gone wrong, and it would be cut into the piece.{place} Clean the "
                + $"place and the stylus and measure again, or take the point out by measuring.without. If it stays, the error changes "
                + $"there from one point to the next: plan more points.");
    }

    private static IReadOnlyList<ErrorSample> Average(
        IReadOnlyList<ErrorSample>[] repeats, List<string> notes, List<ReportWarning> warnings)
    {
        var mean = RepeatedMeasurement.Estimate(repeats);
        notes.Add(string.Create(
            CultureInfo.InvariantCulture,
            $"Each point was measured {repeats.Length} times; their mean is used. One measurement repeats to "
                + $"{mean.RepeatabilityMm * 1000:0.00} µm, their mean to {mean.RepeatabilityMm * 1000 / Math.Sqrt(repeats.Length):0.00} "
                + $"µm."));
        foreach (var outlier in mean.Outliers)
        {
            warnings.Add(ReportWarning.Of(
                SurfaceWarningForms.RepeatOutlier,
                outlier.Point.ToString(CultureInfo.InvariantCulture),
                (outlier.DifferenceMm * 1000).ToString("+0.00;-0.00", CultureInfo.InvariantCulture),
                (outlier.Measurement + 1).ToString(CultureInfo.InvariantCulture)));
        }

        // Mixed-up or reclamped pieces look like this.
        var spread = DeviationStatistics.Of([.. mean.Means.Select(m => m.ErrorMm)]).StandardDeviationMm;
        if (mean.RepeatabilityMm > spread)
        {
            warnings.Add(ReportWarning.Of(
                SurfaceWarningForms.RepeatsDiffer,
                (mean.RepeatabilityMm * 1000).ToString("0.00", CultureInfo.InvariantCulture),
                (spread * 1000).ToString("0.00", CultureInfo.InvariantCulture)));
        }

        return mean.Means;
    }
}
