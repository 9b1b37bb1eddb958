namespace ErrorMatching.Freeform;

/// <summary>The content of a template.</summary>
/// <param name="File">The file name, as given by the caller, or the name of a built-in template.</param>
/// <param name="About">Its purpose.</param>
/// <param name="Sections">The lines of its sections.</param>
internal sealed record TemplateContent(string File, string About, IReadOnlyDictionary<string, IReadOnlyList<TemplateItem>> Sections)
{
    /// <summary>True if it is built in, and therefore tested.</summary>
    public bool IsBuiltIn { get; init; }

    /// <summary>What it takes for granted of the control, in a few words each.</summary>
    public IReadOnlyList<string> Assumes { get; init; } = [];

    /// <summary>Name of the file beside the program; null if there is none.</summary>
    public string? Beside { get; init; }
}
