namespace ErrorMatching.Freeform;

/// <summary>After which stage a surface was measured, told by its points: a fifth of a millimetre is no error of a surface that is to be good to micrometres.</summary>
internal static class MeasuredStage
{
    /// <summary>The stage that points lie at, if it is clear; else the one that the job names.</summary>
    /// <param name="job">The job.</param>
    /// <param name="meanMm">Mean distance of the points from the nominal surface, without any stock.</param>
    public static CuttingStage Of(FreeformJob job, double meanMm)
    {
        var semi = job.Stock.SemiFinishingMm;
        var found = Math.Abs(meanMm - semi) < Math.Abs(meanMm) ? CuttingStage.SemiFinishing : CuttingStage.Finishing;
        return semi > 0 && found != job.Measuring.After && Math.Abs(meanMm - job.Stock.Of(found)) < semi / 4 ? found : job.Measuring.After;
    }

    /// <summary>What people call a stage.</summary>
    public static string Name(CuttingStage stage) => stage == CuttingStage.Finishing ? "finishing" : "semi-finishing";
}
