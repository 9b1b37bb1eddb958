namespace ErrorMatching.Freeform;

/// <summary>The stock that each stage leaves for the next one, along the normal. Finishing leaves none.</summary>
/// <param name="RoughingMm">Stock after roughing.</param>
/// <param name="SemiFinishingMm">Stock after semi-finishing, with which the measured surface is compared.</param>
public sealed record JobStock(double RoughingMm, double SemiFinishingMm)
{
    /// <summary>The paper's 0.4 and 0.2 mm (Lee 2019, section 2.6).</summary>
    public static JobStock Default { get; } = new(0.4, 0.2);

    /// <summary>The stock left by a stage, in millimeters.</summary>
    public double Of(CuttingStage stage) => stage switch
    {
        CuttingStage.Roughing => RoughingMm,
        CuttingStage.SemiFinishing => SemiFinishingMm,
        _ => 0,
    };
}

/// <summary>A pass over the whole surface.</summary>
public enum CuttingStage
{
    /// <summary>Leaves the roughing stock.</summary>
    Roughing,

    /// <summary>Leaves the semi-finishing stock.</summary>
    SemiFinishing,

    /// <summary>Leaves no stock.</summary>
    Finishing,
}
