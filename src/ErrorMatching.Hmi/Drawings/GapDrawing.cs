using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>The two boundaries of a mating as lines in the part's frame, deviations exaggerated: the measured part, and the counterpart that a program cuts.</summary>
/// <param name="Part">The part's boundary, a line a feature, mm.</param>
/// <param name="Counterpart">The counterpart's boundary, a line a feature, mm.</param>
/// <param name="Points">The key points on the part's boundary, mm, with their labels, the gap and the part's deviation there.</param>
/// <param name="Factor">How many times deviations are drawn larger than they are.</param>
/// <param name="LargestMm">The largest gap or overlap at a key point, without sign.</param>
public sealed record GapDrawing(
    IReadOnlyList<IReadOnlyList<Point2>> Part, IReadOnlyList<IReadOnlyList<Point2>> Counterpart, IReadOnlyList<(string Label, Point2 At, double GapMm, double PartMm)> Points, double Factor, double LargestMm)
{
    // The largest deviation takes this much of the drawing.
    private const double Share = 0.08;

    /// <summary>The assembly before compensation, where the counterpart is cut as designed.</summary>
    public static GapDrawing Before(KeptReport report) => Of(report, p => p.DecidedMm);

    /// <summary>The assembly behind it, as predicted.</summary>
    public static GapDrawing After(KeptReport report) => Of(report, p => p.PredictedMm);

    // The gap is what the part lies further out than the counterpart, along the normal.
    private static GapDrawing Of(KeptReport report, Func<KeptPoint, double> gap)
    {
        var factor = FactorOf(report);
        var (part, counterpart) = (new List<IReadOnlyList<Point2>>(), new List<IReadOnlyList<Point2>>());
        foreach (var feature in report.Features.Where(f => f.Outline.Count > 1))
        {
            var points = report.Points.Where(p => p.Feature == feature.Name).ToArray();
            var boundary = new DisplacedOutline(feature.Outline, points);
            part.Add(boundary.By([.. points.Select(p => factor * p.NormalMm)]));
            counterpart.Add(boundary.By([.. points.Select(p => factor * (p.NormalMm - gap(p)))]));
        }

        return new(part, counterpart, [.. report.Points.Select(p => (p.Point, p.Theoretical + (factor * p.NormalMm * p.Normal), gap(p), p.NormalMm))], factor, report.Points.Select(p => Math.Abs(gap(p))).DefaultIfEmpty().Max());
    }

    private static double FactorOf(KeptReport report)
    {
        var (x, y) = (report.Points.Select(p => p.Theoretical.X).ToArray(), report.Points.Select(p => p.Theoretical.Y).ToArray());
        var largest = report.Points.Select(p => Math.Max(Math.Abs(p.NormalMm), Math.Abs(p.DecidedMm))).DefaultIfEmpty().Max();
        if (largest == 0 || x.Length == 0)
        {
            return 1;
        }

        // Round numbers, so that the factor can be stated: 1, 2 or 5 times a power of ten.
        var wanted = Share * Math.Max(x.Max() - x.Min(), y.Max() - y.Min()) / largest;
        var power = Math.Pow(10, Math.Floor(Math.Log10(wanted)));
        return Math.Max(1, power * (wanted / power >= 5 ? 5 : wanted / power >= 2 ? 2 : 1));
    }
}
