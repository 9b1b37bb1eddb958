using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>Several measurements of the same points: their mean, and how well they repeat. Lengths in millimetres.</summary>
/// <param name="Samples">The points of the first measurement, each with the mean error of all.</param>
/// <param name="StandardDeviationMm">Standard deviation of one measurement of a point, with n - 1, pooled over the points.</param>
/// <param name="StandardErrorMm">Standard error of the mean of a point.</param>
/// <param name="Outliers">Sentences that name measurements far from the others of their point. They count all the same.</param>
public sealed record RepeatedMeasurement(IReadOnlyList<ErrorSample> Samples, double StandardDeviationMm, double StandardErrorMm, IReadOnlyList<string> Outliers)
{
    // Normal noise reaches four standard deviations once in 16,000 times.
    private const double Far = 4;

    /// <summary>The mean of measurements.</summary>
    /// <param name="repeats">Two measurements or more, each with the same points in the same order.</param>
    /// <exception cref="ArgumentException">There are fewer than two, or their points differ.</exception>
    public static RepeatedMeasurement Of(IReadOnlyList<IReadOnlyList<ErrorSample>> repeats)
    {
        ArgumentNullException.ThrowIfNull(repeats);
        if (repeats.Count < 2 || repeats.Any(r => !r.Select(s => s.Point).SequenceEqual(repeats[0].Select(s => s.Point))))
        {
            throw new ArgumentException("Two measurements or more of the same points are expected.", nameof(repeats));
        }

        var samples = repeats[0].Select((s, i) => s with { ErrorMm = repeats.Average(r => r[i].ErrorMm) }).ToArray();
        var squares = samples.Select((s, i) => repeats.Sum(r => Math.Pow(r[i].ErrorMm - s.ErrorMm, 2))).Sum();
        var deviation = Math.Sqrt(squares / (samples.Length * (repeats.Count - 1)));
        return new(samples, deviation, deviation / Math.Sqrt(repeats.Count), [.. Named(repeats, samples)]);
    }

    // Each measurement is held against the others, whose spread it does not widen: with two of them neither can be said to be the wrong one.
    private static IEnumerable<string> Named(IReadOnlyList<IReadOnlyList<ErrorSample>> repeats, ErrorSample[] samples)
    {
        var median = Median([.. repeats.SelectMany(r => r.Select((s, i) => Math.Abs(s.ErrorMm - samples[i].ErrorMm)))]);

        // The median of absolute deviations is 0.6745 standard deviations for normal noise, here of a difference from a mean of n.
        var spread = median / 0.6745 / Math.Sqrt(1 - (1.0 / repeats.Count));
        for (var i = 0; i < samples.Length; i++)
        {
            for (var r = 0; r < repeats.Count; r++)
            {
                var others = repeats.Where((_, k) => k != r).Average(o => o[i].ErrorMm);
                var away = repeats[r][i].ErrorMm - others;
                if (spread > 0 && repeats.Count > 2 && Math.Abs(away) > Far * spread * Math.Sqrt(1 + (1.0 / (repeats.Count - 1))))
                {
                    yield return string.Create(
                        CultureInfo.InvariantCulture,
                        $"Point {samples[i].Point} was {away * 1000:+0.00;-0.00} um off the other measurements in measurement {r + 1}. It counts all the same: measure again if that was a chip or a touch gone wrong.");
                }
            }
        }
    }

    private static double Median(double[] values)
    {
        Array.Sort(values);
        return values.Length % 2 == 1 ? values[values.Length / 2] : (values[(values.Length / 2) - 1] + values[values.Length / 2]) / 2;
    }
}
