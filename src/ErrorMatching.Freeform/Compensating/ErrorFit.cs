namespace ErrorMatching.Freeform;

/// <summary>Fits the error field that the job selects.</summary>
internal static class ErrorFit
{
    /// <summary>Fits the field by the best method, or fits the error over (u, v) by one of the paper's surface methods.</summary>
    /// <param name="job">The job.</param>
    /// <param name="samples">The errors.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of one of them.</param>
    public static ErrorField Fit(FreeformJob job, IReadOnlyList<ErrorSample> samples, double uncertaintyMm)
    {
        var best = FieldFit.Fit(samples, uncertaintyMm);
        if (job.Fit.Method == FitMethod.Best || !job.Fit.OfError)
        {
            return best;
        }

        var (scaleU, scaleV) = (Scale(samples, s => s.U, along: true), Scale(samples, s => s.V, along: false));
        var grid = new PointGrid(
            [
                .. samples.GroupBy(s => s.J)
                    .OrderBy(g => g.Key)
                    .Select(
                        g => (IReadOnlyList<GridPoint>)[
                            .. g.OrderBy(s => s.I).Select(s => new GridPoint(s.I, s.J, new(s.U * scaleU, s.V * scaleV, s.ErrorMm)))])]);
        var fit = SurfaceFitter.Fit(grid, job.Fit.Method, job.Fit.CurveToleranceMm);
        return new SurfaceHeightField(
            fit, scaleU, scaleV, Math.Max(job.Measuring.UncertaintyMm, double.IsNaN(fit.LeaveLineOutMm) ? 0 : fit.LeaveLineOutMm));
    }

    /// <summary>Millimeters on the surface per unit of a parameter, averaged over the points.</summary>
    private static double Scale(IReadOnlyList<ErrorSample> samples, Func<ErrorSample, double> parameter, bool along)
    {
        var (length, change) = (0.0, 0.0);
        foreach (var line in samples.GroupBy(s => along ? s.J : s.I))
        {
            var points = line.OrderBy(parameter).ToArray();
            for (var k = 1; k < points.Length; k++)
            {
                length += (points[k].Nominal - points[k - 1].Nominal).Length;
                change += parameter(points[k]) - parameter(points[k - 1]);
            }
        }

        return change > 0 ? length / change : 1;
    }
}
