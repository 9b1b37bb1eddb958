namespace ErrorMatching.Freeform;

/// <summary>What a part of a template is.</summary>
internal enum TemplateItemKind
{
    /// <summary>A line with places for values.</summary>
    Line,

    /// <summary>Lines for each point.</summary>
    Each,

    /// <summary>Lines for where a condition holds, and for where it does not.</summary>
    If,
}
