namespace ErrorMatching.Mating;

/// <summary>Names of quantities as people say them.</summary>
internal static class QuantityName
{
    /// <summary>The name in words; a name that is not known stays as it is.</summary>
    public static string Words(string name) => name switch
    {
        FeatureQuantity.Length => "length",
        FeatureQuantity.Direction => "direction",
        FeatureQuantity.ApexX => "apex, X",
        FeatureQuantity.ApexY => "apex, Y",
        FeatureQuantity.IncludedAngle => "included angle",
        FeatureQuantity.FirstFlank => "first flank",
        FeatureQuantity.SecondFlank => "second flank",
        FeatureQuantity.Chord => "chord",
        FeatureQuantity.ArcLength => "length along the curve",
        _ => name,
    };

    /// <summary>The unit, which the name ends with.</summary>
    public static string Unit(string name) => name.EndsWith("Deg", StringComparison.Ordinal) ? "°" : name.EndsWith("Mm", StringComparison.Ordinal) ? "mm" : "";
}
