namespace ErrorMatching.Freeform;

/// <summary>What each stage leaves on the surface for the next one, along the normal. Finishing leaves nothing.</summary>
/// <param name="RoughingMm">Stock after roughing.</param>
/// <param name="SemiFinishingMm">Stock after semi-finishing: what the measured surface is compared with.</param>
public sealed record JobStock(double RoughingMm, double SemiFinishingMm)
{
    /// <summary>The paper's 0.4 and 0.2 mm (Lee 2019, section 2.6).</summary>
    public static JobStock Default { get; } = new(0.4, 0.2);

    /// <summary>The stock that a stage leaves, in millimetres.</summary>
    public double Of(CuttingStage stage) => stage switch
    {
        CuttingStage.Roughing => RoughingMm,
        CuttingStage.SemiFinishing => SemiFinishingMm,
        _ => 0,
    };
}
