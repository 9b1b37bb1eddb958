namespace ErrorMatching.Hmi;

/// <summary>A length or an angle of a feature in a table.</summary>
/// <param name="Feature">The feature.</param>
/// <param name="Quantity">Its name.</param>
/// <param name="Ideal">Nominal value.</param>
/// <param name="Actual">Measured value of the part.</param>
/// <param name="Corrected">Predicted value of the corrected counterpart: close to the measured value, except for the errors
/// remaining at its points and deviations along the boundary.</param>
/// <param name="Unit">mm or degrees.</param>
internal sealed record QuantityRow(string Feature, string Quantity, string Ideal, string Actual, string Corrected, string Unit)
{
    /// <summary>Its name for screen readers: a feature has several quantities.</summary>
    public string Name => $"{Feature} · {Quantity}";
}
