using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Plans the measuring points of a surface: on curves along u, denser where their slope changes, always at ends and curvature
/// breaks.</summary>
public static class MeasuringPlanner
{
    /// <summary>Maximum number of points of a plan.</summary>
    public const int MaxPoints = 20_000;

    /// <summary>Maximum number of points for a required error: at several seconds per point, they take a shift.</summary>
    private const int MostForError = 5_000;

    /// <summary>Number of points and curves with which the search for a required error starts.</summary>
    private const int FirstCount = 4;

    /// <summary>Returns the plan for a job's surface. Travel and approach are also checked against what the stage before measuring may
    /// leave over its stock, and against the error that the job holds for plausible: too low ones are in
    /// <see cref="MeasuringPlan.Refusals"/> (<c>clearance-too-low</c>, <c>approach-too-short</c>).</summary>
    /// <param name="surface">The nominal finished surface.</param>
    /// <param name="job">The job.</param>
    public static MeasuringPlan Plan(PartSurface surface, FreeformJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        var after = job.Measuring.After;
        return Plan(surface, job.Measuring, job.Stock.Of(after)) with
        {
            Material = StageMaterial.After(job, after).And(
                job.Compensation.LimitMm, "by which the piece may be off (compensation.limitMm)"),
        };
    }

    /// <summary>Returns the plan for a surface.</summary>
    /// <remarks>Points get equal shares of a curve's turning angle, blended with its length (Lee 2019, section 2.3). If
    /// <see cref="JobMeasuring.ReconstructionErrorMm"/> is given, points are added along the parameter that needs them until
    /// <see cref="MeasuringPlan.ReconstructionErrorMm"/> reaches it. Points are numbered along a short path of the probe (2-opt
    /// and or-opt). Each point is checked for collisions of ball and shank; unreachable points are in
    /// <see cref="MeasuringPlan.Refusals"/>.</remarks>
    /// <param name="surface">The nominal finished surface.</param>
    /// <param name="measuring">The number of points and the stylus.</param>
    /// <param name="stockMm">Stock on the nominal surface along its normal during measurement.</param>
    /// <param name="rimSetInMm">Distance of points from the ends of the surface; 0 measures the ends themselves. The distance from trimmed
    /// edges is at least half a millimeter.</param>
    /// <exception cref="ArgumentOutOfRangeException">A length is negative or not a finite number.</exception>
    public static MeasuringPlan Plan(PartSurface surface, JobMeasuring measuring, double stockMm = 0, double rimSetInMm = 0)
    {
        ArgumentNullException.ThrowIfNull(surface);
        ArgumentNullException.ThrowIfNull(measuring);
        ArgumentOutOfRangeException.ThrowIfNegative(stockMm);
        ArgumentOutOfRangeException.ThrowIfNegative(rimSetInMm);
        var empty = new MeasuringPlan
        {
            Surface = surface,
            Measuring = measuring,
            StockMm = stockMm,
            Points = [],
            Curves = 0,
            BreaksU = [],
            BreaksV = [],
            RimSetInMm = rimSetInMm,
            TrimSetInMm = surface.Region.IsWhole ? 0 : Math.Max(rimSetInMm, PlanLayout.TrimSetInMm),
        };
        try
        {
            var layout = new PlanLayout(surface, rimSetInMm);
            var curves = measuring.ReconstructionErrorMm is { } wanted ? Enough(surface, layout, wanted) : Given(layout, measuring);
            return Ordered(empty with { Curves = curves.Count, BreaksU = layout.BreaksU, BreaksV = layout.BreaksV, Lines = curves });
        }
        catch (PlanRefusedException e)
        {
            return empty with { Refusal = e.Refusal };
        }
    }

    private static IReadOnlyList<PlanCurve> Given(PlanLayout layout, JobMeasuring measuring)
    {
        var curves = measuring.Curves
            ?? throw new ArgumentException("The job gives neither a number of curves nor a wanted error.", nameof(measuring));
        var points = measuring.Points
            ?? (
                curves * (
                    measuring.PointsPerCurve ?? throw new ArgumentException("The job gives no number of points.", nameof(measuring))));
        return points > MaxPoints
            ? throw new PlanRefusedException(new(
                "too-many-points",
                string.Create(
                    CultureInfo.InvariantCulture, $"{points} points are asked for; at most {MaxPoints} are planned. Ask for fewer.")))
            : measuring.PointsPerCurve is { } each ? layout.Even(curves, each) : layout.Spread(curves, points);
    }

    // Adds one along the parameter that needs points, or more if there are many already.
    private static IReadOnlyList<PlanCurve> Enough(PartSurface surface, PlanLayout layout, double wanted)
    {
        var (curves, each) = (Math.Max(FirstCount, layout.BreaksV.Count + 2), Math.Max(FirstCount, layout.BreaksU.Count + 2));
        for (var reached = double.PositiveInfinity; curves * each <= MostForError;)
        {
            var plan = layout.Even(curves, each);
            (var onCurves, reached) = new PlanReconstruction(surface, plan).ErrorMm();
            if (reached <= wanted)
            {
                return plan;
            }

            (curves, each) = onCurves > reached / 2 ? (curves, each + 1 + (each / 8)) : (curves + 1 + (curves / 8), each);
        }

        throw new PlanRefusedException(new(
            "error-not-reached",
            string.Create(
                CultureInfo.InvariantCulture,
                $"{MostForError} points do not know the nominal surface to {wanted} mm: it has a feature too sharp for points. Raise "
                    + $"reconstructionErrorMm, or give numbers of curves and points.")));
    }

    private static MeasuringPlan Ordered(MeasuringPlan plan)
    {
        var (curves, points) = (plan.Lines, new List<PlanPoint>());
        for (var j = 0; j < curves.Count; j++)
        {
            for (var i = 0; i < curves[j].Nodes.Count; i++)
            {
                var (u, reason) = curves[j].Nodes[i];
                var at = plan.Surface.Spline.At(u, curves[j].V);
                points.Add(new(
                    0,
                    i,
                    j,
                    u,
                    curves[j].V,
                    at.Position,
                    plan.Surface.NormalOf(at),
                    reason == PlanReason.Slope && curves[j].Reason == PlanReason.Break ? PlanReason.Break : reason));
            }
        }

        Point2[] above = [.. points.Select(plan.AboveOf)];
        var order = MeasuringOrder.Find(above, [.. points.Select(p => p.J)]);
        return plan with { Points = [.. order.Select((index, k) => points[index] with { Number = k + 1 })] };
    }
}
