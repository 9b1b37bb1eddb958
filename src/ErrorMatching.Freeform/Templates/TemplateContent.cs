namespace ErrorMatching.Freeform;

/// <summary>What was read of a template.</summary>
/// <param name="File">The file as the caller named it, or the name of a built-in template.</param>
/// <param name="About">What it is for.</param>
/// <param name="Sections">The lines of its sections.</param>
internal sealed record TemplateContent(string File, string About, IReadOnlyDictionary<string, IReadOnlyList<TemplateItem>> Sections)
{
    /// <summary>True if it is built in, and so tested.</summary>
    public bool IsBuiltIn { get; init; }
}
