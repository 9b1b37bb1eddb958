using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Fits a smooth field to measured errors: their systematic part, also between the points.</summary>
public static class FieldFit
{
    /// <summary>Maximum number of samples.</summary>
    public const int MostSamples = 200_000;

    /// <summary>Returns the field with the least error when whole grid lines are left out: a sparse polynomial with breaks, a Gaussian
    /// process, or a cubic spline.</summary>
    /// <param name="samples">Measured errors on the lines of a grid, in any order; curves may have different numbers of points.</param>
    /// <param name="pointUncertaintyMm">Stated standard uncertainty of one measured point along the normal, in millimeters; zero if
    /// unknown. Stated uncertainties are never smaller than it allows.</param>
    /// <exception cref="InputException"><c>no-samples</c>; <c>too-many-samples</c>; <c>not-finite</c> if a parameter or an error is not
    /// a finite number.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The uncertainty is negative or not finite.</exception>
    public static FittedField Fit(IReadOnlyList<ErrorSample> samples, double pointUncertaintyMm = 0)
    {
        ArgumentNullException.ThrowIfNull(samples);
        if (!double.IsFinite(pointUncertaintyMm) || pointUncertaintyMm < 0)
        {
            throw new ArgumentOutOfRangeException(
                nameof(pointUncertaintyMm), pointUncertaintyMm, "A standard uncertainty is a finite number, zero or more.");
        }

        Check(samples);
        var (u, v) = (ParameterRange.Of(samples.Select(s => s.U)), ParameterRange.Of(samples.Select(s => s.V)));
        var data = FieldData.Of(samples);
        return new(Best(data, pointUncertaintyMm), u, v, pointUncertaintyMm);
    }

    // Among few points nothing but the stated uncertainty tells whether what a smooth model leaves is noise. If it is too much for noise,
    // each point is followed: no model may leave more than the plain mirror would.
    private static FieldModel Best(FieldData data, double uncertainty)
    {
        var smooth = ModelChoice.Best(data, ModelChoice.FarWorseOnErrors);
        return data.Count < FewPoints.Enough
            && smooth.Kind != FieldModelKind.Interpolant
            && FewPoints.ProbabilityOfNoise(smooth.Residuals(), smooth.Freedom, uncertainty) <= SpatialStructure.Level
            && SplineModel.Interpolate(data, smooth) is { } through
            ? through
            : smooth;
    }

    private static void Check(IReadOnlyList<ErrorSample> samples)
    {
        if (samples.Count == 0)
        {
            throw InputException.At("no-samples", "measured errors", "no measured point; at least one is expected");
        }

        if (samples.Count > MostSamples)
        {
            throw InputException.At(
                "too-many-samples",
                "measured errors",
                string.Create(CultureInfo.InvariantCulture, $"{samples.Count} measured points; at most {MostSamples} are taken"));
        }

        foreach (var sample in samples)
        {
            if (!double.IsFinite(sample.U) || !double.IsFinite(sample.V) || !double.IsFinite(sample.ErrorMm))
            {
                throw InputException.At(
                    "not-finite",
                    "measured errors",
                    string.Create(
                        CultureInfo.InvariantCulture, $"point {sample.Point} has a parameter or an error that is no finite number"));
            }
        }
    }
}
