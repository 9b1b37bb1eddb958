namespace ErrorMatching.Freeform;

/// <summary>The content of a template.</summary>
/// <param name="File">The file name, as given by the caller, or the name of a built-in template.</param>
/// <param name="About">Its purpose.</param>
/// <param name="Sections">The lines of its sections.</param>
internal sealed record TemplateContent(string File, string About, IReadOnlyDictionary<string, IReadOnlyList<TemplateItem>> Sections)
{
    /// <summary>True if it is built in, and therefore tested.</summary>
    public bool IsBuiltIn { get; init; }
}
