using ErrorMatching.Cell;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>The probing plan of a free-form job that has no measurement yet, as given by <c>errormatch surface plan</c>.</summary>
/// <param name="Drawing">The points on the surface, in the order of measuring.</param>
/// <param name="Caption">Number of points and curves, and the travel of the stylus.</param>
/// <param name="Refusal">Why the plan cannot be used; null if it can.</param>
public sealed record SurfacePlan(SurfaceDrawing Drawing, string Caption, string? Refusal)
{
    /// <summary>Plans the probing. Slow: do not call it on the UI thread.</summary>
    /// <exception cref="InputException">A file of the job cannot be opened.</exception>
    public static SurfacePlan Of(CellJobSettings job)
    {
        ArgumentNullException.ThrowIfNull(job);
        var files = new FreeformFiles(job.File);
        var surface = files.Surface();
        var plan = files.Plan(surface);
        var points = plan.Points.Select(
            p => (Shown.Id(p.Number), SurfaceFigures.Above(p.Position), SurfaceFigures.PlanText(p.Number, p.Position)));
        return new(
            new(SurfaceNet.Of(surface), null, 0, [.. points], ShowsWay: true),
            Texts.Current.With(
                "Freeform.PlanCaption",
                Shown.Count(plan.Points.Count),
                Shown.Count(plan.Curves),
                Shown.Count((long)Math.Round(plan.TravelMm))),
            plan.Refusals.Count > 0 ? CodeText.Of(plan.Refusals[0].Code, plan.Refusals[0].Message) : null);
    }
}
