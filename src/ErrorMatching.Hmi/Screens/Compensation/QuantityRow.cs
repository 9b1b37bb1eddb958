namespace ErrorMatching.Hmi;

/// <summary>A length or an angle of a feature in a table, as it is shown.</summary>
/// <param name="Feature">The feature.</param>
/// <param name="Quantity">What it is, in words.</param>
/// <param name="Ideal">As designed.</param>
/// <param name="Actual">As measured on the part.</param>
/// <param name="Corrected">As the corrected counterpart is predicted to have it: near the actual value, but for what is left over at its points and what lies along the boundary.</param>
/// <param name="Unit">mm or degrees.</param>
public sealed record QuantityRow(string Feature, string Quantity, string Ideal, string Actual, string Corrected, string Unit)
{
    /// <summary>What it is called aloud: a feature has several.</summary>
    public string Name => $"{Feature} · {Quantity}";
}
