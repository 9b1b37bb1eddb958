using ErrorMatching.Measurement;

namespace ErrorMatching.Freeform;

/// <summary>What is uncertain about measured points and the field fitted to them, whatever of it is compensated.</summary>
/// <param name="NoiseMm">Standard deviation of new random scatter at one point.</param>
/// <param name="FieldMm">Root mean square standard uncertainty of the field at the points.</param>
internal sealed record PointScatter(double NoiseMm, double FieldMm)
{
    /// <summary>Returns the scatter of samples about a field.</summary>
    /// <param name="samples">The measured errors.</param>
    /// <param name="field">The systematic part of the errors.</param>
    /// <param name="errors">The field at each sample.</param>
    /// <param name="lot">The lot that the samples follow from; null for a measurement alone. Its residuals show less than the scatter of
    /// one measured point, because they follow from many pieces, and the field does not know how sure the lot is.</param>
    public static PointScatter Of(IReadOnlyList<ErrorSample> samples, ErrorField field, double[] errors, Lot? lot)
    {
        var (residuals, uncertainties) = (0.0, 0.0);
        for (var k = 0; k < errors.Length; k++)
        {
            residuals += Square(samples[k].ErrorMm - errors[k]);
            uncertainties += Square(field.StandardUncertaintyAt(samples[k].U, samples[k].V));
        }

        var residual = field is FittedField { ResidualStandardDeviationMm: >= 0 } smooth
            ? smooth.ResidualStandardDeviationMm
            : Math.Sqrt(residuals / Math.Max(1, errors.Length - 1));
        var fitted = Math.Sqrt(uncertainties / errors.Length);
        return lot is null
            ? new(residual, fitted)
            : new(Math.Max(residual, lot.NoiseMm), Math.Max(fitted, Math.Sqrt(lot.UncertaintyMm.Average(Square))));
    }

    private static double Square(double x) => x * x;
}
