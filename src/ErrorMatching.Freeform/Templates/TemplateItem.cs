namespace ErrorMatching.Freeform;

/// <summary>A line of a template, or a loop or condition with its lines.</summary>
/// <param name="Line">Line of the file, from 1.</param>
/// <param name="Text">The line, or the name of the condition.</param>
/// <param name="Kind">Its kind.</param>
internal sealed record TemplateItem(int Line, string Text, TemplateItemKind Kind)
{
    /// <summary>The lines of a loop, or of a true condition.</summary>
    public List<TemplateItem> Body { get; } = [];

    /// <summary>The lines of a false condition.</summary>
    public List<TemplateItem> Else { get; } = [];
}

/// <summary>The kind of a template item.</summary>
internal enum TemplateItemKind
{
    /// <summary>A line with placeholders.</summary>
    Line,

    /// <summary>Lines repeated for each point.</summary>
    Each,

    /// <summary>Lines for a true condition and for a false one.</summary>
    If,

    /// <summary>Why the template cannot touch a point.</summary>
    Refuse,
}
