namespace ErrorMatching.Json;

/// <summary>How large a document may be: whoever writes a bigger one by hand has chosen the wrong file.</summary>
/// <param name="MaxBytes">Largest size in bytes.</param>
/// <param name="MaxDepth">Deepest nesting of lists and objects.</param>
public sealed record JsonLimits(int MaxBytes, int MaxDepth)
{
    /// <summary>4 MiB and 64 levels.</summary>
    public static JsonLimits Default { get; } = new(4 * 1024 * 1024, 64);
}
