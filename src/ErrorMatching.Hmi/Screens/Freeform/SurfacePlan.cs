using ErrorMatching.Cell;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>Where a free-form job is to be touched, while nothing of it is measured: what <c>errormatch surface plan</c> says of the same job.</summary>
/// <param name="Drawing">The points on the surface, in the order of measuring.</param>
/// <param name="Caption">How many points on how many curves, and how far the stylus travels.</param>
/// <param name="Refusal">Why the plan cannot be used as it is; null if it can.</param>
public sealed record SurfacePlan(SurfaceDrawing Drawing, string Caption, string? Refusal)
{
    /// <summary>Plans it. This takes its time: not to be called on the screen's thread.</summary>
    /// <exception cref="InputException">A file of the job cannot be opened.</exception>
    public static SurfacePlan Of(CellJobSettings job)
    {
        ArgumentNullException.ThrowIfNull(job);
        var files = new FreeformFiles(job.File);
        var surface = files.Surface();
        var plan = files.Plan(surface);
        var points = plan.Points.Select(p => (Shown.Id(p.Number), SurfaceFigures.Above(p.Position), SurfaceFigures.PlanText(p.Number, p.Position)));
        return new(
            new(SurfaceNet.Of(surface), null, 0, [.. points], ShowsWay: true),
            Texts.Current.With("Freeform.PlanCaption", Shown.Count(plan.Points.Count), Shown.Count(plan.Curves), Shown.Count((long)Math.Round(plan.TravelMm))),
            plan.Refusals.Count > 0 ? CodeText.Of(plan.Refusals[0].Code, plan.Refusals[0].Message) : null);
    }
}
