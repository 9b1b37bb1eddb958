namespace ErrorMatching.Freeform;

/// <summary>A line of a template, or a loop or condition with the lines that belong to it.</summary>
/// <param name="Line">Line of the file, from 1.</param>
/// <param name="Text">The line, or the word of the condition.</param>
/// <param name="Kind">What it is.</param>
internal sealed record TemplateItem(int Line, string Text, TemplateItemKind Kind)
{
    /// <summary>The lines of a loop, or of a condition that holds.</summary>
    public List<TemplateItem> Body { get; } = [];

    /// <summary>The lines of a condition that does not hold.</summary>
    public List<TemplateItem> Else { get; } = [];
}
