namespace ErrorMatching.Mating;

/// <summary>Display names of quantities.</summary>
internal static class QuantityName
{
    /// <summary>The name in words; an unknown name is returned unchanged.</summary>
    public static string Words(string name) =>
        FeatureKinds.All.Select(k => k.Quantities.GetValueOrDefault(name)).FirstOrDefault(words => words is not null) ?? name;

    /// <summary>The unit at the end of a name.</summary>
    public static string Unit(string name) =>
        name.EndsWith("Deg", StringComparison.Ordinal) ? "°" : name.EndsWith("Mm", StringComparison.Ordinal) ? "mm" : "";
}
