namespace ErrorMatching.Freeform;

/// <summary>The most material that may lie over a surface at some time, along its normal.</summary>
/// <param name="Mm">Its height.</param>
/// <param name="Words">What it consists of, for messages.</param>
internal sealed record StageMaterial(double Mm, string Words)
{
    /// <summary>What lies over the surface before a stage.</summary>
    // Roughing follows the surface as one layer, so what is above it was removed by other means.
    public static StageMaterial Before(FreeformJob job, CuttingStage stage) => stage switch
    {
        CuttingStage.Finishing => After(job, CuttingStage.SemiFinishing),
        CuttingStage.SemiFinishing => After(job, CuttingStage.Roughing),
        _ => new(
            Math.Max(job.Stock.RoughingMm, job.Tool.RadiusMm),
            $"one radius of the ball of {Text(job.Tool.DiameterMm)} mm, above which all is removed before roughing"),
    };

    /// <summary>What a stage leaves: its stock, and where its ball did not fit, as much again or the height of its ridges.</summary>
    public static StageMaterial After(FreeformJob job, CuttingStage stage)
    {
        var (stock, ridges) = (job.Stock.Of(stage), job.Toolpath.ScallopMm);
        var key = stage == CuttingStage.Roughing ? "stockMm.roughing" : "stockMm.semiFinishing";
        return stock == 0 ? new(ridges, $"ridges of {Text(ridges)} mm (toolpath.scallopMm)")
            : ridges > stock ? new(
                stock + ridges, $"{Text(stock)} mm of stock ({key}) with ridges of {Text(ridges)} mm (toolpath.scallopMm)")
            : new(2 * stock, $"{Text(stock)} mm of stock ({key}), and as much again where the ball of that stage did not fit");
    }

    /// <summary>The same with more material.</summary>
    public StageMaterial And(double mm, string words) => mm > 0 ? new(Mm + mm, $"{Words}, and {Text(mm)} mm {words}") : this;

    /// <summary>A length as a message states it, rounded up, so that what it says is enough.</summary>
    // A billionth is the error of sums of decimals.
    public static string Text(double mm) => PlaceText.Mm(Math.Ceiling((mm - 1e-9) * 1e4) / 1e4, 4);
}
