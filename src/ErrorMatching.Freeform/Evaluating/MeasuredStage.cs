namespace ErrorMatching.Freeform;

/// <summary>Determines the stage after which a surface was measured. A fifth of a millimeter cannot be the error of a surface that is
/// accurate to micrometers.</summary>
internal static class MeasuredStage
{
    /// <summary>Returns the stage whose surface the points are on, if that is clear; otherwise the job's stage.</summary>
    /// <param name="job">The job.</param>
    /// <param name="meanMm">Mean distance of the points from the nominal surface, without any stock.</param>
    public static CuttingStage Of(FreeformJob job, double meanMm)
    {
        var semi = job.Stock.SemiFinishingMm;
        var found = Math.Abs(meanMm - semi) < Math.Abs(meanMm) ? CuttingStage.SemiFinishing : CuttingStage.Finishing;
        return semi > 0 && found != job.Measuring.After && Math.Abs(meanMm - job.Stock.Of(found)) < semi / 4 ? found : job.Measuring.After;
    }

    public static string Name(CuttingStage stage) => stage == CuttingStage.Finishing ? "finishing" : "semi-finishing";
}
