namespace ErrorMatching.Json;

/// <summary>How large a document may be: nobody writes a larger one by hand, so a larger one is the wrong file.</summary>
/// <param name="MaxBytes">Largest size in bytes.</param>
/// <param name="MaxDepth">Deepest nesting of lists and objects.</param>
/// <param name="MaxValues">Most values, lists and objects included. A value of two bytes becomes an item of more than a hundred.</param>
public sealed record JsonLimits(int MaxBytes, int MaxDepth, int MaxValues = 500_000)
{
    /// <summary>4 MiB, 64 levels and 500,000 values.</summary>
    public static JsonLimits Default { get; } = new(4 * 1024 * 1024, 64);
}
