namespace ErrorMatching.Freeform;

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
