namespace ErrorMatching.Freeform;

/// <summary>What is fitted to measured points.</summary>
/// <param name="Method">The way of fitting.</param>
/// <param name="OfError">True: the error over (u, v) is fitted and added to the exact nominal surface. False: a surface is fitted through the compensation points, as in the paper.</param>
/// <param name="CurveToleranceMm">Mean distance from points to a fitted curve that decides on its degree (1 um in the paper).</param>
public sealed record JobFit(FitMethod Method, bool OfError, double CurveToleranceMm)
{
    /// <summary>The error field, by the best method, at 1 um.</summary>
    public static JobFit Default { get; } = new(FitMethod.Best, true, 0.001);
}
