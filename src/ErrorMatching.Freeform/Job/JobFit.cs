namespace ErrorMatching.Freeform;

/// <summary>How measured points are fitted.</summary>
/// <param name="Method">The method of fitting.</param>
/// <param name="OfError">True: the error over (u, v) is fitted and added to the exact nominal surface. False: a surface is fitted to the
/// compensation points, as in the paper.</param>
/// <param name="CurveToleranceMm">Mean distance from points to a fitted curve that determines its degree (1 um in the paper).</param>
public sealed record JobFit(FitMethod Method, bool OfError, double CurveToleranceMm)
{
    /// <summary>The best method for the error field, with 1 um.</summary>
    public static JobFit Default { get; } = new(FitMethod.Best, true, 0.001);
}
