namespace ErrorMatching.Json;

/// <summary>The size limits of a document. A handwritten document is smaller, so a larger one is the wrong file.</summary>
/// <param name="MaxBytes">Largest size in bytes.</param>
/// <param name="MaxDepth">Maximum nesting of lists and objects.</param>
/// <param name="MaxValues">Maximum number of values, including lists and objects. Two bytes may become an item of over a hundred.</param>
public sealed record JsonLimits(int MaxBytes, int MaxDepth, int MaxValues = 500_000)
{
    /// <summary>4 MiB, 64 levels and 500,000 values.</summary>
    public static JsonLimits Default { get; } = new(4 * 1024 * 1024, 64);
}
