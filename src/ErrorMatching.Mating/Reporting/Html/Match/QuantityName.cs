namespace ErrorMatching.Mating;

/// <summary>Names of quantities as people say them.</summary>
internal static class QuantityName
{
    /// <summary>The name in words; a name that is not known stays as it is.</summary>
    public static string Words(string name) =>
        FeatureKinds.All.Select(k => k.Quantities.GetValueOrDefault(name)).FirstOrDefault(words => words is not null) ?? name;

    /// <summary>The unit, which the name ends with.</summary>
    public static string Unit(string name) =>
        name.EndsWith("Deg", StringComparison.Ordinal) ? "°" : name.EndsWith("Mm", StringComparison.Ordinal) ? "mm" : "";
}
