using System.Globalization;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Calculates the compensated surface from the measured one (Lee 2019, sections 2.4 and 2.5).</summary>
public static class Compensator
{
    // A mean smaller than this many standard errors is not significant.
    private const double Significant = 2;

    // The residual between the points is excessive from this multiple of that at the points, unless smaller than the ridges of a ball.
    private const double MuchMore = 2;
    private const double RidgeMm = 0.001;

    // If only noise is present, the error of left-out lines is close to that at the points. From this multiple it is not noise.
    private const double FarMore = 4;

    /// <summary>Calculates the compensated surface, or returns the reasons for refusing it.</summary>
    /// <exception cref="InputException">A measured point has no foot, or there are too few for the job's fit or alignment.</exception>
    public static Outcome<CompensationResult> Compensate(CompensationInput input)
    {
        ArgumentNullException.ThrowIfNull(input);
        MeasuredPoints.ThrowIfTwice(input.Measured);
        var (job, nominal) = (input.Job, input.Surface);
        var stock = job.Stock.Of(job.Measuring.After);
        var file = input.Measured[0].File;
        var alignment = job.Measuring.BestFit
            ? SurfaceAlignment.BestFit(
                nominal, [.. input.Measured.SelectMany(m => m.Points).Select(p => (p.Planned, p.Contact))], stock, file)
            : null;
        var repeats = input.Measured.Select(m => SurfaceErrors.Of(
            nominal, m.Points.Select(p => (p.Planned, alignment?.Apply(p.Contact) ?? p.Contact)), stock, m.File)).ToArray();
        var notes = new List<string>();
        List<string> warnings = [.. input.Measured.SelectMany(m => m.Warnings)];
        for (var k = 0; k < repeats.Length; k++)
        {
            if (OtherStage(repeats[k], input.Measured[k].File, job, stock) is { } other)
            {
                return other;
            }
        }

        var samples = repeats.Length == 1 ? repeats[0] : Average(repeats, notes, warnings);
        if (BeyondLimit(samples, job, stock) is { } refusal)
        {
            return refusal;
        }

        if (Outlying(samples, repeats, input.Measured) is { } outlying)
        {
            return outlying;
        }

        var measured = samples;
        var before = DeviationStatistics.Of([.. samples.Select(s => s.ErrorMm)]);
        Lot? lot = null;
        SurfaceLot? pieces = null;
        if (input.Previous is { } previous)
        {
            if (previous.Refuse(samples, Sha256(input)) is { } others)
            {
                return others;
            }

            // The program of the lot has not cut a piece that still has its stock.
            pieces = previous.With(
                SurfacePiece.Of(Sha256(input), samples, stock > 0 ? null : previous.CorrectionsMm, previous.Pieces[^1]));
            lot = pieces.Estimate(job.Measuring.UncertaintyMm / Math.Sqrt(repeats.Length));
            samples = [.. samples.Zip(lot.ExpectedMm, (s, mm) => s with { ErrorMm = mm })];
            LotWords.Tell(pieces, lot, notes, warnings);
        }

        var statistics = lot is null ? before : DeviationStatistics.Of([.. samples.Select(s => s.ErrorMm)]);
        var structure = SpatialStructure.Of(samples);
        var systematic = Systematic(job, samples, statistics, structure, notes, warnings);
        // If only noise was found, the significance of the mean has already been decided.
        var mean = systematic as ConstantField
            ?? new ConstantField(statistics.MeanMm, statistics.StandardDeviationMm / Math.Sqrt(samples.Count));
        var compensated = job.Compensation.Mirror ? systematic : mean;
        if (CompensatedSurface.Refusal(nominal, job, samples, compensated) is { } lost)
        {
            return lost;
        }

        var surface = CompensatedSurface.Of(nominal, job, samples, compensated);
        if (surface.LargestMoveMm > job.Compensation.LimitMm)
        {
            return new Refusal("beyond-limit", string.Create(
                CultureInfo.InvariantCulture,
                $"The compensated surface would lie up to {Beyond(surface.LargestMoveMm, job.Compensation.LimitMm).TrimStart('+')} mm "
                    + $"from the nominal one; compensation.limitMm allows {job.Compensation.LimitMm:0.####} mm. Between the points the fit "
                    + $"goes further than they do: measure more points, or raise the limit if that is meant."));
        }

        var result = new CompensationResult
        {
            Input = input,
            Alignment = alignment,
            Samples = measured,
            Expected = samples,
            Lot = lot,
            Pieces = pieces ?? new([.. samples.Select(s => s.Point)], [SurfacePiece.Of(Sha256(input), samples, systematic)], []),
            Before = before,
            Structure = structure,
            Systematic = systematic,
            Compensated = compensated,
            Mean = mean,
            Surface = surface.Surface,
            ThroughPoints = surface.ThroughPoints,
            ApproximationMm = surface.ApproximationMm,
            LargestMoveMm = surface.LargestMoveMm,
            Mirror = SurfacePrediction.Of("mirror", samples, systematic, systematic, job.Compensation.Gain, lot?.NoiseMm ?? 0),
            ToolRadius = SurfacePrediction.Of("tool-radius", samples, systematic, mean, job.Compensation.Gain, lot?.NoiseMm ?? 0),
            Warnings = warnings,
            Notes = notes,
        };
        result = result with
        {
            Pieces = result.Pieces with { CorrectionsMm = [.. samples.Select(s => result.MovedMmAt(s.U, s.V))] }
        };
        if (BeyondStep(result) is { } tooFar)
        {
            return tooFar;
        }

        if (systematic is FittedField { LeaveLineOutMm: > RidgeMm } fitted
            && fitted.LeaveLineOutMm > FarMore * result.Mirror.PointUncertaintyMm)
        {
            notes.Add(string.Create(
                CultureInfo.InvariantCulture,
                $"Where a line of points is left out, the error fitted without it is {fitted.LeaveLineOutMm * 1000:0.00} um off in the "
                    + $"mean, and {result.Mirror.PointUncertaintyMm * 1000:0.00} um are expected at the points: the error changes much "
                        + $"from "
                    + $"one to the next, and between them more may be left. Measure more points to know."));
        }

        return result.ThroughPoints is null ? result : result with { Mirror = ThroughPoints(result, surface.Between, warnings) };
    }

    private static string Sha256(CompensationInput input) => MeasuredPoints.Sha256Of(input.Measured);

    // From one piece to the next a process moves little. A large step is a mixed-up report or measurement.
    private static Refusal? BeyondStep(CompensationResult result)
    {
        if (result.Input.Previous is not { } previous || result.Input.Job.Compensation.StepLimitMm is not { } limit)
        {
            return null;
        }

        var (point, mm) = result.Pieces.Points.Zip(result.Pieces.CorrectionsMm.Zip(previous.CorrectionsMm, (now, was) => now - was))
            .MaxBy(p => Math.Abs(p.Second));
        return Math.Abs(mm) <= limit ? null : new("beyond-step", string.Create(
            CultureInfo.InvariantCulture,
            $"At point {point} the compensation would change by {Beyond(mm, limit)} mm from the previous piece; "
                + $"compensation.stepLimitMm allows {limit:0.####} mm. Check that the previous report belongs to the program that cut "
                + $"this piece, and measure again; raise the limit if the process moved that far."));
    }

    // The actual residual of the surface through the points. It may miss the nominal surface and the measurement by any amount.
    private static SurfacePrediction ThroughPoints(
        CompensationResult result, IReadOnlyList<(double U, double V, double MovedMm)> places, List<string> warnings)
    {
        var (samples, systematic, noise) = (result.Expected, result.Systematic, result.Lot?.NoiseMm ?? 0);
        double[] left = [.. samples.Select(s => systematic.At(s.U, s.V) + result.MovedMmAt(s.U, s.V))];
        double[] between = [.. places.Select(p => systematic.At(p.U, p.V) + p.MovedMm)];
        var atPoints = SurfacePrediction.Of("mirror", samples, systematic, left, [], noise);
        if (between.Length == 0)
        {
            return atPoints;
        }

        var (there, here) = (DeviationStatistics.Of(between), atPoints.Statistics.StandardDeviationMm);
        if (there.StandardDeviationMm > Math.Max(MuchMore * here, RidgeMm))
        {
            warnings.Add(string.Create(
                CultureInfo.InvariantCulture,
                $"Between the points the surface that was fitted to them leaves up to {there.ProfileIsoMm * 500:0.00} um, with a "
                    + $"standard deviation of {there.StandardDeviationMm * 1000:0.00} um; at the points {here * 1000:0.00} um are "
                        + $"expected. "
                    + $"It does not know the nominal surface between them: fit the error instead (\"of\": \"error\"), or measure more "
                    + $"points."));
        }

        return SurfacePrediction.Of("mirror", samples, systematic, left, between, noise);
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
        IReadOnlyList<ErrorSample> samples, IReadOnlyList<ErrorSample>[] repeats, IReadOnlyList<MeasuredPoints> measured)
    {
        var points = OutlyingPoints.Of(samples);
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
                + $"place and the stylus and measure again. If it stays, the error changes there from one point to the next: plan more "
                + $"points.");
    }

    // Uses enough digits to show that a length exceeds its limit.
    private static string Beyond(double mm, double limitMm)
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

    private static ErrorField Systematic(
        FreeformJob job,
        IReadOnlyList<ErrorSample> samples,
        DeviationStatistics statistics,
        SpatialStructure structure,
        List<string> notes,
        List<string> warnings)
    {
        if (structure.Verdict != SpatialVerdict.Noise)
        {
            if (structure.Verdict == SpatialVerdict.Undetermined)
            {
                warnings.Add(
                    $"{samples.Count} points that are too few or all alike do not tell whether neighbors are alike: the error was taken "
                        + $"as systematic.");
            }

            return ErrorFit.Of(job, samples);
        }

        var standardError = statistics.StandardDeviationMm / Math.Sqrt(samples.Count);
        var isReal = Math.Abs(statistics.MeanMm) > Significant * standardError;
        var decided = isReal
            ? string.Create(CultureInfo.InvariantCulture, $"The mean of {statistics.MeanMm * 1000:+0.00;-0.00} um is compensated.")
            : "The mean is not significant either: nothing is compensated.";
        warnings.Add(string.Create(
            CultureInfo.InvariantCulture,
            $"Errors of neighboring points are not alike (Moran's I {structure.I:0.###}, p {FieldWords.Probability(structure.P)}): what "
                + $"differs from the mean looks like noise and is not mirrored. {decided}"));
        return isReal ? new ConstantField(statistics.MeanMm, standardError) : new ConstantField(0, standardError);
    }

    private static IReadOnlyList<ErrorSample> Average(IReadOnlyList<ErrorSample>[] repeats, List<string> notes, List<string> warnings)
    {
        var mean = RepeatedMeasurement.Of(repeats);
        notes.Add(string.Create(
            CultureInfo.InvariantCulture,
            $"Each point was measured {repeats.Length} times; their mean is used. One measurement repeats to "
                + $"{mean.RepeatabilityMm * 1000:0.00} um, their mean to {mean.RepeatabilityMm * 1000 / Math.Sqrt(repeats.Length):0.00} "
                + $"um."));
        foreach (var outlier in mean.Outliers)
        {
            warnings.Add(string.Create(
                CultureInfo.InvariantCulture,
                $"Point {outlier.Point} was {outlier.DifferenceMm * 1000:+0.00;-0.00} um off its other measurements in measurement "
                    + $"{outlier.Measurement + 1}. It counts all the same: measure again if that was a chip or a touch gone wrong."));
        }

        // Mixed-up or reclamped pieces look like this.
        var spread = DeviationStatistics.Of([.. mean.Means.Select(m => m.ErrorMm)]).StandardDeviationMm;
        if (mean.RepeatabilityMm > spread)
        {
            warnings.Add(string.Create(
                CultureInfo.InvariantCulture,
                $"The measurements differ among themselves by {mean.RepeatabilityMm * 1000:0.00} um, more than the error that they show "
                    + $"differs from place to place ({spread * 1000:0.00} um): are they of one piece in one clamping?"));
        }

        return mean.Means;
    }
}
