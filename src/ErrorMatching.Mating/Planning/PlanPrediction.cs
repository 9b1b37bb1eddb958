using System.Globalization;
using System.Runtime.ExceptionServices;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>What a plan will tell, before anything is measured: parts are drawn, touched as planned, and matched as a measured part
/// is.</summary>
/// <param name="BoundMm">Half the 95 % interval of the error anywhere along the boundary, mm: the median of the parts. Null if the points
/// do not tell it somewhere.</param>
/// <param name="Assembles">The probability that the pair goes together, on average; null if the outline says nothing of it.</param>
/// <param name="Parts">The number of parts that could be matched.</param>
/// <param name="Features">The features in the order of the job.</param>
public sealed record PlanPrediction(double? BoundMm, double? Assembles, int Parts, IReadOnlyList<PlannedBound> Features)
{
    /// <summary>Parts that are drawn for what is told: the median of so many is within a tenth of the bound.</summary>
    public const int Draws = 16;

    private const ulong Seed = 0x5DEECE66D1234567;

    // Without limits a part deviates by so much, mm.
    private const double WithoutLimitsMm = 0.05;

    // The form of a part before it is measured: over how much of a curve deviations are alike, mm (half waves of 45 mm), and how large they
    // are, as a part of half the width of the limits; the same of a line, as a part of its length, and of the uncertainty of a point.
    private const double CurveMm = 15, OfHalfWidth = 0.25;
    private const double LinePart = 0.25, OfUncertainty = 0.5;

    // Cosines of which a stationary course is made (Rahimi and Recht 2007).
    private const int Waves = 24;

    /// <summary>Predicts what a plan will tell.</summary>
    /// <param name="input">A match of the planned job; its measured part is not looked at.</param>
    /// <param name="plan">The plan of the job.</param>
    /// <param name="parts">The number of parts to draw.</param>
    /// <exception cref="InputException">As <see cref="Matcher.Match"/>.</exception>
    public static PlanPrediction Predict(MatchInput input, TouchPlan plan, int parts = Draws)
    {
        ArgumentNullException.ThrowIfNull(input);
        ArgumentNullException.ThrowIfNull(plan);

        // Whatever the job makes of it, a plan is judged by how well the part is known, and the whole of it followed.
        var compensation = input.Job.Compensation with { From = CompensationSource.Part, Amount = CompensationAmount.Whole, Gain = 1 };
        input = input with { Job = input.Job with { Compensation = compensation }, Counterpart = null };
        var results = new MatchResult?[parts];
        try
        {
            Parallel.For(0, parts, draw => results[draw] = Match(input with { Part = Drawn(input, plan, (ulong)draw) }));
        }
        catch (AggregateException exception)
        {
            ExceptionDispatchInfo.Throw(exception.InnerExceptions[0]);
        }

        MatchResult[] matched = [.. results.OfType<MatchResult>()];
        PlannedBound[][] told = [.. matched.Select(r => r.Prediction.Features.Select(PlannedBound.Of).ToArray())];
        double[] chances = [.. matched.Select(r => r.Pair?.Probability).OfType<double>()];
        return new(
            PlannedBound.Median([.. told.Select(PlannedBound.Largest)])?.BoundMm,
            chances.Length > 0 ? chances.Average() : null,
            matched.Length,
            [.. input.Job.Features.Select((_, f) => PlannedBound.Median([.. told.Select(t => t[f])]) ?? new(null, null))]);
    }

    /// <summary>The form error of an element before it is measured, as an estimate takes it: its variance, and the length over which it is
    /// correlated.</summary>
    /// <param name="isLine">True for a line, false for a curve.</param>
    /// <param name="lengthMm">Length of the element, mm.</param>
    /// <param name="halfWidthMm">Half the width of its limits, mm; 0 without any.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of a point, mm.</param>
    /// <param name="statedMm">The form error that the job states, mm; null for none.</param>
    internal static (double VarianceMm2, double LengthMm) FormOf(
        bool isLine, double lengthMm, double halfWidthMm, double uncertaintyMm, double? statedMm)
    {
        var (formMm, alikeMm) = isLine
            ? (OfUncertainty * uncertaintyMm, LinePart * lengthMm)
            : (OfHalfWidth * (halfWidthMm > 0 ? halfWidthMm : WithoutLimitsMm), CurveMm);
        formMm = statedMm ?? formMm;
        return (formMm * formMm, alikeMm);
    }

    private static MatchResult? Match(MatchInput input)
    {
        try
        {
            return Matcher.Match(input).Result;
        }
        catch (GeometryException)
        {
            // A part whose points by chance determine nothing says nothing of the plan.
            return null;
        }
    }

    // The same part for the same draw, wherever it is touched.
    private static MeasurementFile Drawn(MatchInput input, TouchPlan plan, ulong draw)
    {
        var u = input.Job.Gauge.Uncertainty.CombinedMm;
        var radius = input.Job.Gauge.Reports == ProbeReport.StylusCenter ? input.Job.Gauge.StylusDiameterMm!.Value / 2 : 0;
        var part = new NormalVariates(Seed + draw);
        var text = new StringBuilder("point,x_mm,y_mm\n");
        var named = new HashSet<string>(StringComparer.Ordinal);
        foreach (var (feature, planned) in input.Job.Features.Zip(plan.Features))
        {
            var half = feature.Tolerance.Band.WidthMm is > 0 and var width ? width / 2 : WithoutLimitsMm;
            var isWhole = planned.Lists.Any(l => l.Any(p => p.Reason == TouchReason.Kept));
            var (growth, motion) = (part.Next() * half, new Vector2(part.Next() * half, part.Next() * half));
            foreach (var list in planned.Lists)
            {
                var (shift, tilt) = (part.Next() * half, part.Next() * half / 2);
                var form = Course(FormOf(feature.Kind.IsStraight || isWhole, LengthOf(list), half, u, feature.FormMm), part);
                var (along, length) = (0.0, LengthOf(list));
                for (var i = 0; i < list.Count; i++)
                {
                    along += i == 0 ? 0 : list[i].Place.DistanceTo(list[i - 1].Place);
                    var off = isWhole ? growth + motion.Dot(list[i].Normal) : shift + (tilt * ((2 * along / Math.Max(length, 1e-9)) - 1));
                    Write(list[i], off + form(along) + radius);
                }
            }
        }

        foreach (var label in input.Job.NeededPoints.Where(l => !named.Contains(l)))
        {
            var at = input.Theoretical[label].Position;
            text.Append(CultureInfo.InvariantCulture, $"{label},{at.X:0.000000},{at.Y:0.000000}\n");
        }

        return MeasurementReader.Read(Encoding.UTF8.GetBytes(text.ToString()), "drawn.csv", MeasurementFormat.Points);

        void Write(PlannedPoint point, double off)
        {
            // The same noise at the same place, so that plans are compared by their points.
            var place = ((ulong)(long)Math.Round(point.Place.X * 1e6) * 0x9E3779B97F4A7C15) ^ (ulong)(long)Math.Round(point.Place.Y * 1e6);
            var noise = new NormalVariates(Seed ^ (draw << 48) ^ place);
            named.Add(point.Label);
            var at = point.Place + (point.Normal * off) + new Vector2(noise.Next() * u, noise.Next() * u);
            text.Append(CultureInfo.InvariantCulture, $"{point.Label},{at.X:0.000000},{at.Y:0.000000}\n");
        }
    }

    private static double LengthOf(IReadOnlyList<PlannedPoint> list) =>
        list.Zip(list.Skip(1)).Sum(p => p.First.Place.DistanceTo(p.Second.Place));

    // A course whose values at two places have the covariance of an estimate's form error, on average over the draws.
    private static Func<double, double> Course((double VarianceMm2, double LengthMm) form, NormalVariates part)
    {
        var (sigmaMm, lengthMm) = (Math.Sqrt(form.VarianceMm2), form.LengthMm);
        (double Size, double Frequency)[] waves = [
            .. Enumerable.Range(0, Waves).Select(_ => (part.Next() * sigmaMm / Math.Sqrt(Waves), part.Next() / Math.Max(lengthMm, 1e-3)))];
        double[] sines = [.. waves.Select(_ => part.Next() * sigmaMm / Math.Sqrt(Waves))];
        return along =>
        {
            var sum = 0.0;
            for (var k = 0; k < waves.Length; k++)
            {
                var (sine, cosine) = Elementary.SinCos(waves[k].Frequency * along);
                sum += (waves[k].Size * cosine) + (sines[k] * sine);
            }

            return sum;
        };
    }
}

/// <summary>How well the boundary of a feature will be known.</summary>
/// <param name="BoundMm">Half the 95 % interval of the error anywhere along it, mm; null if the points do not tell it somewhere.</param>
/// <param name="Place">Where it is known least, in the part's frame; null if no place is known less than the points.</param>
public sealed record PlannedBound(double? BoundMm, Point2? Place)
{
    internal static PlannedBound Of(FeaturePrediction feature)
    {
        var points = feature.Points.Max(p => p.Interval95Mm);
        return feature.WorstBetween is not { } worst ? new(points, null)
            : new(worst.IsKnown ? Math.Max(points, worst.Interval95Mm) : null, worst.Place);
    }

    // One of which nothing is known somewhere is known least.
    internal static PlannedBound Largest(IEnumerable<PlannedBound> bounds) =>
        bounds.MaxBy(b => b.BoundMm ?? double.PositiveInfinity)!;

    internal static PlannedBound? Median(PlannedBound[] bounds) => bounds.Length == 0 ? null
        : bounds.Any(b => b.BoundMm is null) ? bounds.First(b => b.BoundMm is null)
        : bounds.OrderBy(b => b.BoundMm).ElementAt(bounds.Length / 2);
}
