using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Several measurements of the same points, averaged point by point, with their repeatability. Lengths in millimeters.</summary>
/// <remarks>A measurement is reported as an outlier if it differs from the median of its point by more than <see cref="OutlierFactor"/>
/// robust standard deviations of all differences (1.4826 times the median of the absolute values; Huber, Robust Statistics, section 5.1).
/// It stays in the mean. The user may exclude it if the cause is known.</remarks>
internal sealed class RepeatedMeasurement
{
    /// <summary>Robust standard deviations beyond which a measurement is an outlier.</summary>
    public const double OutlierFactor = 5;

    private RepeatedMeasurement(IReadOnlyList<RepeatedPoint> points, IReadOnlyList<MeasurementOutlier> outliers, double repeatabilityMm) =>
        (Points, Outliers, RepeatabilityMm) = (points, outliers, repeatabilityMm);

    /// <summary>Each point with its mean, in the order of first appearance.</summary>
    public IReadOnlyList<RepeatedPoint> Points { get; }

    /// <summary>Measurements far from the others of their point.</summary>
    public IReadOnlyList<MeasurementOutlier> Outliers { get; }

    /// <summary>Standard deviation of a single measurement, pooled over all points with n - 1 degrees of freedom each; NaN if no point was
    /// measured twice.</summary>
    public double RepeatabilityMm { get; }

    /// <summary>The means as samples, each at the place of the first measurement of its point.</summary>
    public IReadOnlyList<ErrorSample> Means => [.. Points.Select(p => p.Mean)];

    /// <summary>Averages measurements of the same points.</summary>
    /// <param name="measurements">One list per measurement. Points are identified by their number, and lists may lack points.</param>
    /// <exception cref="InputException"><c>no-samples</c>; <c>doubled-point</c> if a list contains a point twice;
    /// <c>not-finite</c>.</exception>
    public static RepeatedMeasurement Estimate(IReadOnlyList<IReadOnlyList<ErrorSample>> measurements)
    {
        ArgumentNullException.ThrowIfNull(measurements);
        var first = new Dictionary<int, ErrorSample>();
        var order = new List<int>();
        var values = new Dictionary<int, List<(int Measurement, double Error)>>();
        for (var m = 0; m < measurements.Count; m++)
        {
            foreach (var sample in measurements[m])
            {
                Check(sample, m);
                if (first.TryAdd(sample.Point, sample))
                {
                    order.Add(sample.Point);
                    values[sample.Point] = [];
                }

                if (values[sample.Point].Exists(v => v.Measurement == m))
                {
                    throw Refused(
                        "doubled-point", m, $"point {sample.Point} stands twice; one value a point is expected in each measurement");
                }

                values[sample.Point].Add((m, sample.ErrorMm));
            }
        }

        if (order.Count == 0)
        {
            throw InputException.At("no-samples", "repeated measurements", "no measured point; at least one is expected");
        }

        var points = order.ConvertAll(number => Average(first[number], values[number].ConvertAll(v => v.Error)));
        return new(points, Far(order, values), Pooled(points));
    }

    private static RepeatedPoint Average(ErrorSample sample, List<double> errors)
    {
        var mean = errors.Average();
        var deviation = errors.Count > 1 ? Math.Sqrt(errors.Sum(e => (e - mean) * (e - mean)) / (errors.Count - 1)) : double.NaN;
        return new(sample with { ErrorMm = mean }, errors.Count, deviation, deviation / Math.Sqrt(errors.Count));
    }

    private static double Pooled(List<RepeatedPoint> points)
    {
        var (sum, free) = (0.0, 0);
        foreach (var point in points.Where(p => p.Count > 1))
        {
            sum += (point.Count - 1) * point.StandardDeviationMm * point.StandardDeviationMm;
            free += point.Count - 1;
        }

        return free > 0 ? Math.Sqrt(sum / free) : double.NaN;
    }

    private static List<MeasurementOutlier> Far(List<int> order, Dictionary<int, List<(int Measurement, double Error)>> values)
    {
        // Two values of a point are equally far from their median, so neither can be an outlier.
        var differences = order.Where(number => values[number].Count > 2).SelectMany(number =>
        {
            var median = Median([.. values[number].Select(v => v.Error)]);
            return values[number].Select(v => new MeasurementOutlier(number, v.Measurement, v.Error - median));
        }).ToList();
        if (differences.Count == 0)
        {
            return [];
        }

        var spread = 1.4826 * Median([.. differences.Select(d => Math.Abs(d.DifferenceMm)).Where(d => d > 0).DefaultIfEmpty(0)]);
        return [.. differences.Where(d => Math.Abs(d.DifferenceMm) > OutlierFactor * spread)];
    }

    private static double Median(double[] values)
    {
        Array.Sort(values);
        var half = values.Length / 2;
        return values.Length % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
    }

    private static void Check(ErrorSample sample, int measurement)
    {
        if (!double.IsFinite(sample.ErrorMm))
        {
            throw Refused("not-finite", measurement, $"the error of point {sample.Point} is no finite number");
        }
    }

    private static InputException Refused(string code, int measurement, FormattableString problem) =>
        InputException.At(
            code, string.Create(CultureInfo.InvariantCulture, $"measurement {measurement + 1}"), FormattableString.Invariant(problem));
}

/// <summary>A point that was measured once or several times.</summary>
/// <param name="Mean">The point with the mean of its errors.</param>
/// <param name="Count">Number of measurements.</param>
/// <param name="StandardDeviationMm">Standard deviation of its measurements with n - 1, in millimeters; NaN for one measurement.</param>
/// <param name="StandardErrorMm">Standard uncertainty of the mean, the standard deviation divided by the root of n, in millimeters; NaN
/// for one measurement.</param>
internal sealed record RepeatedPoint(ErrorSample Mean, int Count, double StandardDeviationMm, double StandardErrorMm);

/// <summary>A measurement far from the others of the same point.</summary>
/// <param name="Point">Number of the point.</param>
/// <param name="Measurement">Index of the measurement in the given order, from 0.</param>
/// <param name="DifferenceMm">Its error minus the median error of the point, in millimeters.</param>
internal sealed record MeasurementOutlier(int Point, int Measurement, double DifferenceMm);
