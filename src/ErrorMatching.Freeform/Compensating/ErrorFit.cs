namespace ErrorMatching.Freeform;

/// <summary>The field that a job wants fitted to the errors.</summary>
internal static class ErrorFit
{
    /// <summary>The field by the best rule, or the error laid over (u, v) by one of the paper's ways of fitting surfaces.</summary>
    public static ErrorField Of(FreeformJob job, IReadOnlyList<ErrorSample> samples)
    {
        var best = FieldFit.Fit(samples, job.Measuring.UncertaintyMm);
        if (job.Fit.Method == FitMethod.Best || !job.Fit.OfError)
        {
            return best;
        }

        var (scaleU, scaleV) = (Scale(samples, s => s.U, along: true), Scale(samples, s => s.V, along: false));
        var grid = new PointGrid([.. samples.GroupBy(s => s.J).OrderBy(g => g.Key).Select(g => (IReadOnlyList<GridPoint>)[.. g.OrderBy(s => s.I).Select(s => new GridPoint(s.I, s.J, new(s.U * scaleU, s.V * scaleV, s.ErrorMm)))])]);
        var fit = SurfaceFitter.Fit(grid, job.Fit.Method, job.Fit.CurveToleranceMm);
        return new SurfaceHeightField(fit, scaleU, scaleV, Math.Max(job.Measuring.UncertaintyMm, double.IsNaN(fit.LeaveLineOutMm) ? 0 : fit.LeaveLineOutMm));
    }

    /// <summary>Millimetres on the surface that one of a parameter stands for, on average over the points.</summary>
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
