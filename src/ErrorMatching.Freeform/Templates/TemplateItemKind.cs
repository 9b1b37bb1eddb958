namespace ErrorMatching.Freeform;

/// <summary>The kind of a template item.</summary>
internal enum TemplateItemKind
{
    /// <summary>A line with placeholders.</summary>
    Line,

    /// <summary>Lines repeated for each point.</summary>
    Each,

    /// <summary>Lines for a true condition and for a false one.</summary>
    If,
}
