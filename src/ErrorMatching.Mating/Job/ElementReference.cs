using System.Globalization;

namespace ErrorMatching.Mating;

/// <summary>A straight element of the boundary: a line feature, or a flank of a triangle.</summary>
/// <param name="Feature">Name of the feature.</param>
/// <param name="Flank">1 or 2 for a flank in the order of cutting; null for a line.</param>
public readonly record struct ElementReference(string Feature, int? Flank)
{
    /// <summary>As the job writes it: <c>L1</c> or <c>L2L3/1</c>.</summary>
    public override string ToString() => Flank is null ? Feature : string.Create(CultureInfo.InvariantCulture, $"{Feature}/{Flank}");
}
