using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The surface to cut instead of the nominal one.</summary>
/// <param name="Surface">The surface.</param>
/// <param name="ThroughPoints">The fit through the compensation points; null if the error was fitted.</param>
/// <param name="ApproximationMm">Largest distance of the surface from the exact nominal surface displaced by the field.</param>
/// <param name="LargestMoveMm">Largest distance from the nominal surface, checked on a dense grid and at the measured points.</param>
/// <param name="Between">For a fit through the compensation points: its signed distance from the nominal surface along the normal, sampled
/// between the measured points, with the parameters of each foot. Empty if the error was fitted.</param>
internal sealed record CompensatedSurface(
    PartSurface Surface,
    FittedSurface? ThroughPoints,
    double ApproximationMm,
    double LargestMoveMm,
    IReadOnlyList<(double U, double V, double MovedMm)> Between)
{
    /// <summary>Largest distance between the written surface and the exact one: a hundredth of what a probe can resolve.</summary>
    public const double ToleranceMm = 1e-5;

    /// <summary>Largest distance between the outermost points of a fit and the edge. Probes do not reach a place more accurately, and CAD
    /// systems do not write edges more accurately.</summary>
    private const double EdgeMm = RegionTracer.GapMm;

    private const int Dense = 60;

    // Rounding: a foot beyond the outermost points by this share of half their range is still on the edge.
    private const double OnEdge = 1e-9;

    /// <summary>Returns why no surface may be fitted through the compensation points, or null. Such a surface ends at its points and
    /// ignores trimming: it would cut across holes and leave edges uncut.</summary>
    public static Refusal? Refusal(PartSurface nominal, FreeformJob job, IReadOnlyList<ErrorSample> samples, ErrorField field)
    {
        const string instead = "Use \"of\": \"error\" under fit, which keeps the limits of the nominal surface";
        if (!IsThroughPoints(job, field))
        {
            return null;
        }

        if (!nominal.Region.IsWhole)
        {
            return new(
                "limits-lost",
                $"Surface {nominal.Name} is trimmed, and one through the compensation points (\"of\": \"points\") has no limits but its "
                    + $"own ends: holes would be cut over. {instead}.");
        }

        var (sample, shortMm) = Ends(nominal.Spline, samples).MaxBy(e => e.ShortMm);
        return shortMm <= EdgeMm ? null : new("limits-lost", string.Create(
            CultureInfo.InvariantCulture,
            $"Point {sample.Point}, the outermost on its line, lies {shortMm:0.###} mm inside of the edge of the surface, and one "
                + $"through the compensation points (\"of\": \"points\") would end there: the edge would stay uncut. {instead}, or "
                + $"measure up to the edges."));
    }

    public static CompensatedSurface Fit(PartSurface nominal, FreeformJob job, IReadOnlyList<ErrorSample> samples, ErrorField field)
    {
        var gain = job.Compensation.Gain;
        if (IsThroughPoints(job, field))
        {
            return ThroughCompensationPoints(nominal, job, samples, gain);
        }

        var largest = Largest(nominal.Spline, (u, v) => Math.Abs(gain * field.At(u, v)));
        foreach (var sample in samples)
        {
            largest = Math.Max(largest, Math.Abs(gain * field.At(sample.U, sample.V)));
        }

        if (largest == 0)
        {
            return new(nominal, null, 0, 0, []);
        }

        var (breaksU, breaksV) = field is FittedField fitted ? (fitted.BreaksU, fitted.BreaksV) : ([], []);
        var approximation = SplineApproximation.Fit(
            (u, v) =>
            {
                var at = nominal.Spline.At(u, v);
                return MirrorEquations.Compensated(at.Position, nominal.NormalOf(at), field.At(u, v), gain);
            },
            Knots(nominal.Spline.KnotsU, breaksU),
            Knots(nominal.Spline.KnotsV, breaksV),
            ToleranceMm);
        return new(nominal with { Spline = approximation.Surface }, null, approximation.ErrorMm, largest, []);
    }

    private static bool IsThroughPoints(FreeformJob job, ErrorField field) =>
        !job.Fit.OfError && job.Compensation.Mirror && field is not ConstantField;

    // The ends of each curve and all points of the first and last curve, with their distances from the edge.
    private static IEnumerable<(ErrorSample Sample, double ShortMm)> Ends(SplineSurface nominal, IReadOnlyList<ErrorSample> samples)
    {
        var (u, v) = (nominal.KnotsU, nominal.KnotsV);
        foreach (var curve in samples.GroupBy(s => s.J))
        {
            var (first, last) = (curve.MinBy(s => s.I)!, curve.MaxBy(s => s.I)!);
            yield return (first, (nominal.PointAt(u.Start, first.V) - first.Nominal).Length);
            yield return (last, (nominal.PointAt(u.End, last.V) - last.Nominal).Length);
        }

        var (least, most) = (samples.Min(s => s.J), samples.Max(s => s.J));
        foreach (var sample in samples)
        {
            if (sample.J == least)
            {
                yield return (sample, (nominal.PointAt(sample.U, v.Start) - sample.Nominal).Length);
            }

            if (sample.J == most)
            {
                yield return (sample, (nominal.PointAt(sample.U, v.End) - sample.Nominal).Length);
            }
        }
    }

    private static CompensatedSurface ThroughCompensationPoints(
        PartSurface nominal, FreeformJob job, IReadOnlyList<ErrorSample> samples, double gain)
    {
        var grid = new PointGrid([.. samples.GroupBy(s => s.J).OrderBy(g => g.Key).Select(g => (IReadOnlyList<GridPoint>)
            [
                .. g.OrderBy(s => s.I).Select(s => new GridPoint(
                    s.I, s.J, MirrorEquations.Compensated(s.Nominal, s.Normal, s.ErrorMm, gain)))])]);
        var fit = SurfaceFitter.Fit(grid, job.Fit.Method, job.Fit.CurveToleranceMm);
        var middle = fit.Surface.At(
            (fit.Surface.KnotsU.Start + fit.Surface.KnotsU.End) / 2, (fit.Surface.KnotsV.Start + fit.Surface.KnotsV.End) / 2);
        var outside = middle.Normal.Dot(samples[samples.Count / 2].Normal) > 0 ? 1 : -1;
        var (rangeU, rangeV) = (ParameterRange.Of(samples.Select(s => s.U)), ParameterRange.Of(samples.Select(s => s.V)));
        var between = new List<(double U, double V, double MovedMm)>();
        var largest = Largest(fit.Surface, (u, v) =>
        {
            var foot = nominal.Spline.ClosestPoint(fit.Surface.PointAt(u, v));
            if (Math.Abs(rangeU.ToUnit(foot.At.U)) <= 1 + OnEdge
                && Math.Abs(rangeV.ToUnit(foot.At.V)) <= 1 + OnEdge
                && nominal.Region.Contains(foot.At.U, foot.At.V))
            {
                between.Add((foot.At.U, foot.At.V, foot.Height * nominal.Outside));
            }

            return foot.Distance;
        });
        foreach (var sample in samples)
        {
            largest = Math.Max(largest, fit.Surface.ClosestPoint(sample.Nominal).Distance);
        }

        return new(new(nominal.Name, fit.Surface, SurfaceRegion.Whole, outside), fit, 0, largest, between);
    }

    private static double Largest(SplineSurface surface, Func<double, double, double> move)
    {
        var largest = 0.0;
        for (var i = 0; i <= Dense; i++)
        {
            for (var j = 0; j <= Dense; j++)
            {
                largest = Math.Max(largest, move(At(surface.KnotsU, i), At(surface.KnotsV, j)));
            }
        }

        return largest;
    }

    private static double At(KnotVector knots, int i) => knots.Start + ((knots.End - knots.Start) * i / Dense);

    /// <summary>The initial knots. The surface may be less smooth where the nominal normal or the error is.</summary>
    private static KnotVector Knots(KnotVector nominal, IReadOnlyList<double> breaks)
    {
        var degree = Math.Max(3, nominal.Degree);
        var knots = new SortedDictionary<double, int>();
        foreach (var knot in nominal.Breaks.Skip(1).SkipLast(1))
        {
            // The normal has one derivative less than the surface.
            knots[knot] = Math.Clamp(degree - (nominal.Degree - nominal.Multiplicity(knot) - 1), 1, degree);
        }

        foreach (var at in breaks.Where(b => b > nominal.Start && b < nominal.End))
        {
            // Where the curvature of the error breaks, its slope is continuous.
            knots[at] = Math.Max(knots.GetValueOrDefault(at), degree - 1);
        }

        return new(degree, [
            .. Enumerable.Repeat(nominal.Start, degree + 1),
            .. knots.SelectMany(k => Enumerable.Repeat(k.Key, k.Value)),
            .. Enumerable.Repeat(nominal.End, degree + 1),
        ]);
    }
}
