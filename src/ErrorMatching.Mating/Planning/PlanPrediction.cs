using System.Globalization;
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
public sealed record PlanPrediction(double? BoundMm, double? Assembles, int Parts)
{
    // The median of so many is within a tenth of the bound.
    private const int Draws = 16;

    private const ulong Seed = 0x5DEECE66D1234567;

    // Without limits a part deviates by so much, mm.
    private const double WithoutLimitsMm = 0.05;

    // Cosines of which a stationary course is made (Rahimi and Recht 2007).
    private const int Waves = 24;

    /// <summary>Predicts what a plan will tell.</summary>
    /// <param name="input">A match of the planned job; its measured part is not looked at.</param>
    /// <param name="plan">The plan of the job.</param>
    /// <exception cref="InputException">As <see cref="Matcher.Match"/>.</exception>
    public static PlanPrediction Of(MatchInput input, TouchPlan plan)
    {
        ArgumentNullException.ThrowIfNull(input);
        ArgumentNullException.ThrowIfNull(plan);

        // Whatever the job makes of it, a plan is judged by how well the part is known, and the whole of it followed.
        var compensation = input.Job.Compensation with { From = CompensationSource.Part, Amount = CompensationAmount.Whole, Gain = 1 };
        input = input with { Job = input.Job with { Compensation = compensation }, Counterpart = null };
        var (bounds, chances, isKnown, count) = (new List<double>(), new List<double>(), true, 0);
        for (var draw = 0; draw < Draws; draw++)
        {
            if (Match(input with { Part = Drawn(input, plan, (ulong)draw) }) is not { } result)
            {
                continue;
            }

            count++;
            var worst = result.Prediction.Features.Select(f => f.WorstBetween).OfType<PredictedError>().ToArray();
            isKnown &= worst.All(w => w.IsKnown);
            bounds.Add(worst.Select(w => w.Interval95Mm).Concat(
                result.Prediction.Features.SelectMany(f => f.Points).Select(p => p.Interval95Mm)).Max());
            if (result.Pair is { } pair)
            {
                chances.Add(pair.Probability);
            }
        }

        bounds.Sort();
        return new(isKnown && count > 0 ? bounds[count / 2] : null, chances.Count > 0 ? chances.Average() : null, count);
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
                var form = feature.Kind.IsStraight || isWhole
                    ? Course(TouchPlanner.OfUncertainty * u / 2, TouchPlanner.LinePart * LengthOf(list), part)
                    : Course(TouchPlanner.OfHalfWidth * half, TouchPlanner.CurveMm, part);
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
    private static Func<double, double> Course(double sigmaMm, double lengthMm, NormalVariates part)
    {
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
