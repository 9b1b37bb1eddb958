namespace ErrorMatching.Mating;

/// <summary>A length or an angle of a feature: ideal, actual and corrected, as figure 9 of Wang 2021 shows them.</summary>
/// <param name="Quantity">The quantity as designed and as measured, with its uncertainty.</param>
/// <param name="Corrected">Its value on the counterpart that the corrected program is predicted to cut; null where it has none.</param>
public sealed record ReportQuantity(FeatureQuantity Quantity, double? Corrected);
