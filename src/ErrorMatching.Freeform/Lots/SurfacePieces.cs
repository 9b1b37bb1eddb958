using System.Globalization;
using ErrorMatching.Measurement;

namespace ErrorMatching.Freeform;

/// <summary>The pieces of a lot of surfaces. The noise of a first piece is that about its fitted error.</summary>
internal static class SurfacePieces
{
    /// <summary>The names of measured points in a lot: their numbers in the plan.</summary>
    public static string[] Names(IReadOnlyList<ErrorSample> samples) =>
        [.. samples.Select(s => s.Point.ToString(CultureInfo.InvariantCulture))];

    /// <summary>A lot with a further piece.</summary>
    /// <param name="lot">The pieces before it.</param>
    /// <param name="sha256">SHA-256 of its measurement.</param>
    /// <param name="samples">Its errors, at the points of the lot.</param>
    /// <param name="correctionsMm">What the program that cut it had corrected at each point; null for nothing.</param>
    public static MeasuredLot With(
        this MeasuredLot lot, string sha256, IReadOnlyList<ErrorSample> samples, IReadOnlyList<double>? correctionsMm)
    {
        var corrected = correctionsMm ?? [.. samples.Select(_ => 0.0)];
        var values = new LotPiece([.. samples.Select(s => s.ErrorMm)], corrected);
        return lot.With(lot.Pieces.Count == 0
            ? new(sha256, FieldFit.Fit([.. samples.Zip(corrected, (s, c) => s with { ErrorMm = s.ErrorMm - c })]).NoiseMm, values)
            : RecordedPiece.After(lot.Pieces[^1], sha256, values));
    }

    /// <summary>The only piece so far, which a nominal program cut.</summary>
    /// <param name="sha256">SHA-256 of its measurement.</param>
    /// <param name="samples">Its errors.</param>
    /// <param name="systematic">Their systematic part.</param>
    public static RecordedPiece Only(string sha256, IReadOnlyList<ErrorSample> samples, ErrorField systematic)
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
