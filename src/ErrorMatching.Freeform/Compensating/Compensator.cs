using System.Globalization;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

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
        MeasuredPoints.ThrowIfTwice([.. input.Earlier.SelectMany(p => p), .. input.Measured]);
        var (job, nominal) = (input.Job, input.Surface);
        var notes = new List<string>();
        List<ReportWarning> warnings = [.. input.Earlier.Append(input.Measured).SelectMany(p => p).SelectMany(m => m.Warnings)];
        var all = new List<PieceErrors>();
        foreach (var measurements in input.Earlier.Append(input.Measured))
        {
            var piece = PieceErrors.Find(measurements, job, nominal, notes, warnings);
            if (!piece.IsUsable)
            {
                return piece.Refusal;
            }

            all.Add(piece.Result);
        }

        if (job.Measuring.Without is { Count: > 0 } without)
        {
            notes.Add(
                $"{(without.Count == 1 ? "Point" : "Points")} {ReportNames.Of([.. without.Select(ReportNumber.Count)])} "
                    + $"{(without.Count == 1 ? "is" : "are")} left out (measuring.without): what is compensated there follows from the "
                    + "points around.");
        }

        var (alignment, samples) = (all[^1].Alignment, all[^1].Samples);
        var measured = samples;
        var before = DeviationStatistics.Of([.. samples.Select(s => s.ErrorMm)]);
        var uncertainty = job.Measuring.UncertaintyMm / Math.Sqrt(input.Measured.Count);
        var motion = alignment is null ? SurfaceMotion.Find(measured, uncertainty, job.CommonMotionMm) : null;
        if (motion is { AsksForOrigin: true })
        {
            warnings.Add(ReportWarning.Of(SurfaceWarningForms.CheckOrigin, motion.Values));
        }

        if (samples.Count < FewPoints.LeastToContradict)
        {
            notes.Add($"{samples.Count.ToString(CultureInfo.InvariantCulture)} points cannot contradict each other: a bad touch would "
                + "not be found.");
        }

        if (Follow(input, all, out var pieces) is { } notOfLot)
        {
            return notOfLot;
        }

        var lot = pieces?.Estimate(uncertainty);
        if (lot is not null)
        {
            samples = [.. samples.Zip(lot.ExpectedMm, (s, mm) => s with { ErrorMm = mm })];
            uncertainty = Math.Max(uncertainty, Math.Sqrt(lot.UncertaintyMm.Average(u => u * u)));
            warnings.AddRange(LotWords.Warnings(lot).Select(w => ReportWarning.Of(w.Form, w.Values)));
            notes.AddRange(LotWords.Notes(lot));
        }

        var statistics = lot is null ? before : DeviationStatistics.Of([.. samples.Select(s => s.ErrorMm)]);
        var structure = SpatialStructure.Test(samples, uncertainty);
        var systematic = Systematic(job, samples, statistics, structure, uncertainty, warnings);
        // If only noise was found, the significance of the mean has already been decided.
        var mean = systematic as ConstantField
            ?? new ConstantField(statistics.MeanMm, statistics.StandardDeviationMm / Math.Sqrt(samples.Count));
        var compensated = job.Compensation.Mirror ? systematic : mean;
        if (CompensatedSurface.Refusal(nominal, job, samples, compensated) is { } lost)
        {
            return lost;
        }

        var surface = CompensatedSurface.Fit(nominal, job, samples, compensated);
        if (surface.LargestMoveMm > job.Compensation.LimitMm)
        {
            return new Refusal("beyond-limit", string.Create(
                CultureInfo.InvariantCulture,
                $"The compensated surface would lie up to "
                    + $"{PieceErrors.Beyond(surface.LargestMoveMm, job.Compensation.LimitMm).TrimStart('+')} mm from the nominal one; "
                    + $"compensation.limitMm allows {job.Compensation.LimitMm:0.####} mm. Between the points the fit "
                    + $"goes further than they do: measure more points, or raise the limit if that is meant."));
        }

        double[] errors = [.. samples.Select(s => systematic.At(s.U, s.V))];
        var scatter = PointScatter.Of(samples, systematic, errors, lot);
        var result = new CompensationResult
        {
            Input = input,
            Alignment = alignment,
            Motion = motion,
            Samples = measured,
            Expected = samples,
            Lot = lot,
            Pieces = pieces ?? new(SurfacePieces.Names(samples), [SurfacePieces.Only(all[^1].Sha256, samples, systematic)], []),
            Before = before,
            Structure = structure,
            Systematic = systematic,
            Compensated = compensated,
            Mean = mean,
            Surface = surface.Surface,
            ThroughPoints = surface.ThroughPoints,
            ApproximationMm = surface.ApproximationMm,
            LargestMoveMm = surface.LargestMoveMm,
            Mirror = Prediction("mirror", errors),
            ToolRadius = Prediction("tool-radius", [.. samples.Select(s => mean.At(s.U, s.V))]),
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
            warnings.Add(ReportWarning.Of(
                SurfaceWarningForms.TooFarApart, Um(fitted.LeaveLineOutMm), Um(result.Mirror.PointUncertaintyMm)));
        }

        // Many points still tell such waves apart, because they are not equally spaced.
        if (samples.Count < FewPoints.Enough && systematic is FittedField { PointsPerWave: < FewPoints.LeastPerWave } wave)
        {
            warnings.Add(ReportWarning.Of(
                SurfaceWarningForms.FewForWave, wave.PointsPerWave.ToString("0.0", CultureInfo.InvariantCulture)));
        }

        return result.ThroughPoints is null
            ? result
            : result with { Mirror = ThroughPoints(result, scatter, errors, surface.Between, warnings) };

        SurfacePrediction Prediction(string method, double[] taken) =>
            SurfacePrediction.Of(method, scatter, [.. errors.Zip(taken, (e, t) => e - (job.Compensation.Gain * t))], []);
    }

    // The lot with all measured pieces; none for a single piece that a nominal program cut.
    private static Refusal? Follow(CompensationInput input, List<PieceErrors> all, out MeasuredLot? pieces)
    {
        pieces = input.Previous;
        if (pieces is null && all.Count == 1)
        {
            return null;
        }

        // The program of the lot has not cut a piece that still has its stock.
        var corrections = input.Job.Stock.Of(input.Job.Measuring.After) > 0 ? null : pieces?.CorrectionsMm;
        pieces ??= new(SurfacePieces.Names(all[0].Samples), [], []);
        foreach (var piece in all)
        {
            if (pieces.Refuse(SurfacePieces.Names(piece.Samples), piece.Sha256) is { } notOfLot)
            {
                return notOfLot;
            }

            pieces = pieces.With(piece.Sha256, piece.Samples, corrections);
        }

        return null;
    }

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
            $"At point {point} the compensation would change by {PieceErrors.Beyond(mm, limit)} mm from the previous piece; "
                + $"compensation.stepLimitMm allows {limit:0.####} mm. Check that the previous report belongs to the program that cut "
                + $"this piece, and measure again; raise the limit if the process moved that far."));
    }

    // The actual residual of the surface through the points. It may miss the nominal surface and the measurement by any amount.
    private static SurfacePrediction ThroughPoints(
        CompensationResult result,
        PointScatter scatter,
        double[] errors,
        IReadOnlyList<(double U, double V, double MovedMm)> places,
        List<ReportWarning> warnings)
    {
        var systematic = result.Systematic;
        double[] left = [.. result.Expected.Zip(errors, (s, e) => e + result.MovedMmAt(s.U, s.V))];
        double[] between = [.. places.Select(p => systematic.At(p.U, p.V) + p.MovedMm)];
        var atPoints = SurfacePrediction.Of("mirror", scatter, left, []);
        if (between.Length == 0)
        {
            return atPoints;
        }

        var (there, here) = (DeviationStatistics.Of(between), atPoints.Statistics.StandardDeviationMm);
        if (there.StandardDeviationMm > Math.Max(MuchMore * here, RidgeMm))
        {
            warnings.Add(ReportWarning.Of(
                SurfaceWarningForms.WorseBetween, Um(there.ProfileIsoMm / 2), Um(there.StandardDeviationMm), Um(here)));
        }

        return SurfacePrediction.Of("mirror", scatter, left, between);
    }

    private static ErrorField Systematic(
        FreeformJob job,
        IReadOnlyList<ErrorSample> samples,
        DeviationStatistics statistics,
        SpatialStructure structure,
        double uncertaintyMm,
        List<ReportWarning> warnings)
    {
        if (structure.Verdict != SpatialVerdict.Noise)
        {
            if (structure.Verdict == SpatialVerdict.Undetermined)
            {
                warnings.Add(
                    ReportWarning.Of(SurfaceWarningForms.StructureUnknown, samples.Count.ToString(CultureInfo.InvariantCulture)));
            }

            var field = ErrorFit.Fit(job, samples, uncertaintyMm);
            if (field is FittedField { Kind: FieldModelKind.Interpolant })
            {
                warnings.Add(
                    samples.Count < FewPoints.Enough
                        ? ReportWarning.Of(
                            SurfaceWarningForms.FollowsFewPoints,
                            samples.Count.ToString(CultureInfo.InvariantCulture),
                            (1000 * uncertaintyMm).ToString("0.###", CultureInfo.InvariantCulture))
                        : ReportWarning.Of(SurfaceWarningForms.FollowsEachPoint));
            }

            return field;
        }

        var standardError = statistics.StandardDeviationMm / Math.Sqrt(samples.Count);
        var isReal = Math.Abs(statistics.MeanMm) > Significant * standardError;
        var probability = StructureTest.Words(structure.Tests.Min(t => t.P));
        warnings.Add(isReal
            ? ReportWarning.Of(
                SurfaceWarningForms.OnlyMean,
                probability,
                (statistics.MeanMm * 1000).ToString("+0.00;-0.00", CultureInfo.InvariantCulture))
            : ReportWarning.Of(SurfaceWarningForms.OnlyNoise, probability));
        return isReal ? new ConstantField(statistics.MeanMm, standardError) : new ConstantField(0, standardError);
    }

    private static string Um(double mm) => (mm * 1000).ToString("0.00", CultureInfo.InvariantCulture);
}
