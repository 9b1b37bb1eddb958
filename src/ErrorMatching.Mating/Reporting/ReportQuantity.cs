namespace ErrorMatching.Mating;

/// <summary>A length or an angle of a feature: ideal, actual and corrected, as in figure 9 of Wang 2021.</summary>
/// <param name="Quantity">The quantity as designed and as measured, with its uncertainty.</param>
/// <param name="Corrected">Its predicted value on the counterpart cut by the corrected program; null if it has none.</param>
public sealed record ReportQuantity(FeatureQuantity Quantity, double? Corrected);
