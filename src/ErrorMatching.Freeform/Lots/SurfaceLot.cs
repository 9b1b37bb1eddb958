using System.Globalization;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The pieces of a surface that were measured one after the other, and how far the program for the next one moves the measured
/// points. A report carries it, so that the next compensation can go on from it.</summary>
/// <param name="Points">The measured points, by their numbers in the plan.</param>
/// <param name="Pieces">The pieces in the order of cutting, each with the values at these points; at most <see cref="MostPieces"/>.</param>
/// <param name="CorrectionsMm">How far the program for the next piece moves each point along its normal, mm; positive leaves
/// material.</param>
public sealed record SurfaceLot(IReadOnlyList<int> Points, IReadOnlyList<SurfacePiece> Pieces, IReadOnlyList<double> CorrectionsMm)
{
    /// <summary>The number of pieces that are kept; older ones say little about the next.</summary>
    public const int MostPieces = 100;

    /// <summary>Why the errors of a further piece cannot be added; null if they can.</summary>
    /// <param name="samples">The errors of the further piece.</param>
    /// <param name="sha256">SHA-256 of its measurement.</param>
    public Refusal? Refuse(IReadOnlyList<ErrorSample> samples, string sha256)
    {
        ArgumentNullException.ThrowIfNull(samples);
        if (Pieces.Select(p => p.MeasuredSha256).Contains(sha256, StringComparer.Ordinal))
        {
            return new(
                "same-measurement",
                "This measurement is in the lot of the previous report already: a piece counts once. Give the measurement of the piece "
                    + "that the previous report's program cut.");
        }

        if (samples.Select(s => s.Point).SequenceEqual(Points))
        {
            return null;
        }

        int[] lacking = [.. Points.Except(samples.Select(s => s.Point)).Order()];
        int[] further = [.. samples.Select(s => s.Point).Except(Points).Order()];
        var differ = lacking.Length > 0 ? string.Create(CultureInfo.InvariantCulture, $"point {lacking[0]} is missing now")
            : further.Length > 0 ? string.Create(CultureInfo.InvariantCulture, $"point {further[0]} is new")
            : "their order differs";
        return new(
            "other-points",
            string.Create(
                CultureInfo.InvariantCulture,
                $"The previous report has {Points.Count} measured points and this measurement {samples.Count}; {differ}. Pieces of a lot "
                    + $"are measured at the same points: measure by the plan of the previous piece, or begin a new lot without "
                    + $"the previous report."));
    }

    /// <summary>The lot with a further piece, before it is known what the next program corrects.</summary>
    /// <param name="sha256">SHA-256 of its measurement.</param>
    /// <param name="samples">Its errors, at the points of the lot.</param>
    /// <param name="correctionsMm">What the program that cut it had corrected at each point; null for nothing.</param>
    internal SurfaceLot With(string sha256, IReadOnlyList<ErrorSample> samples, IReadOnlyList<double>? correctionsMm)
    {
        var corrected = correctionsMm ?? [.. samples.Select(_ => 0.0)];
        var piece = Pieces.Count == 0
            ? SurfacePiece.First(sha256, samples, corrected)
            : SurfacePiece.After(Pieces[^1], sha256, samples, corrected);
        return this with { Pieces = [.. Pieces.Append(piece).TakeLast(MostPieces)] };
    }

    /// <summary>What the pieces say about the next one.</summary>
    /// <param name="uncertaintyMm">Stated standard uncertainty of one measured point; the noise that the pieces show counts if it is
    /// larger.</param>
    public Lot Estimate(double uncertaintyMm)
    {
        var noise = Math.Sqrt(Pieces.Average(p => p.NoiseMm * p.NoiseMm));
        return Lot.Of([.. Pieces.Select(p => p.Values)], Math.Max(Math.Max(uncertaintyMm, noise), LeastUncertaintyMm));
    }

    // A nanometer: what no probe tells.
    private const double LeastUncertaintyMm = 1e-6;
}

/// <summary>A measured piece of a lot.</summary>
/// <param name="MeasuredSha256">SHA-256 of its measurement.</param>
/// <param name="NoiseMm">Standard deviation of one measured point, as this piece shows it, mm.</param>
/// <param name="Values">Its errors, and what the program that cut it had corrected.</param>
public sealed record SurfacePiece(string MeasuredSha256, double NoiseMm, LotPiece Values)
{
    /// <summary>A further piece.</summary>
    /// <param name="before">The piece before it. What two pieces differ by, apart from a shift of all points, is noise.</param>
    /// <param name="sha256">SHA-256 of its measurement.</param>
    /// <param name="samples">Its errors.</param>
    /// <param name="correctionsMm">What the program that cut it had corrected at each point.</param>
    internal static SurfacePiece After(
        SurfacePiece before, string sha256, IReadOnlyList<ErrorSample> samples, IReadOnlyList<double> correctionsMm)
    {
        double[] errors = [.. samples.Select(s => s.ErrorMm)];
        double[] changes = [
            .. errors.Select((e, i) => e - correctionsMm[i] - before.Values.ErrorsMm[i] + before.Values.CorrectionsMm[i])];
        return new(sha256, DeviationStatistics.Of(changes).StandardDeviationMm / Math.Sqrt(2), new(errors, correctionsMm));
    }

    /// <summary>The first piece of several. Its noise is that about its fitted error.</summary>
    /// <param name="sha256">SHA-256 of its measurement.</param>
    /// <param name="samples">Its errors.</param>
    /// <param name="correctionsMm">What the program that cut it had corrected at each point.</param>
    internal static SurfacePiece First(string sha256, IReadOnlyList<ErrorSample> samples, IReadOnlyList<double> correctionsMm)
    {
        ErrorSample[] uncorrected = [.. samples.Zip(correctionsMm, (s, c) => s with { ErrorMm = s.ErrorMm - c })];
        return new(sha256, FieldFit.Fit(uncorrected).NoiseMm, new([.. samples.Select(s => s.ErrorMm)], correctionsMm));
    }

    /// <summary>The only piece so far, which a nominal program cut.</summary>
    /// <param name="sha256">SHA-256 of its measurement.</param>
    /// <param name="samples">Its errors.</param>
    /// <param name="systematic">Their systematic part.</param>
    internal static SurfacePiece Of(string sha256, IReadOnlyList<ErrorSample> samples, ErrorField systematic)
    {
        double[] errors = [.. samples.Select(s => s.ErrorMm)];
        var noise = systematic switch
        {
            FittedField fitted => fitted.NoiseMm,
            ConstantField => DeviationStatistics.Of(errors).StandardDeviationMm,
            _ => FieldFit.Fit(samples).NoiseMm,
        };
        return new(sha256, noise, new(errors, new double[errors.Length]));
    }
}
