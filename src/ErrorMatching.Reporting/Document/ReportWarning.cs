namespace ErrorMatching.Reporting;

/// <summary>A warning about a result: an English sentence, and a stable code with values for translations.</summary>
/// <param name="Code">The kind of warning, such as <c>sparse-points</c>; empty in reports older than the codes.</param>
/// <param name="Message">The English sentence.</param>
/// <param name="Values">The values in the sentence, in order: names, and numbers as formatted in the sentence.</param>
public sealed record ReportWarning(string Code, string Message, params IReadOnlyList<string> Values)
{
    /// <inheritdoc/>
    public override string ToString() => Message;
}
