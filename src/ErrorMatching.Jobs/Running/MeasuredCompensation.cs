using ErrorMatching.Freeform;

namespace ErrorMatching.Jobs;

/// <summary>From a job and files of measured points to the compensation, for the verbs that need one.</summary>
public static class MeasuredCompensation
{
    /// <summary>The compensation, or why there is none.</summary>
    /// <param name="files">The job's files.</param>
    /// <param name="measured">Files of measured points: several are measurements of one piece.</param>
    /// <param name="cancellation">Looked at before the calculation.</param>
    /// <exception cref="InputException">A file cannot be opened.</exception>
    /// <exception cref="FreeformException">A file cannot be used.</exception>
    /// <exception cref="Geometry.GeometryException">The points determine no fit.</exception>
    /// <exception cref="OperationCanceledException">Cancelled.</exception>
    public static CompensationOutcome Of(FreeformFiles files, IReadOnlyList<string> measured, CancellationToken cancellation)
    {
        var surface = files.Surface();
        var plan = files.Plan(surface);

        // What was measured was touched somehow: only a plan without points stops here, not one that this stylus does not reach.
        if (plan.Points.Count == 0 || plan.FacesDown)
        {
            return new(null, plan.Refusals);
        }

        var points = measured.Select(f => files.Measured("measured", f, plan)).ToArray();
        cancellation.ThrowIfCancellationRequested();
        return Compensator.Compensate(new(files.Job, surface, plan, points));
    }
}
