namespace ErrorMatching.Reporting;

/// <summary>A warning about a result: an English sentence, and a stable code with values for translations.</summary>
/// <param name="Code">The kind of warning, such as <c>sparse-points</c>; empty in reports older than the codes.</param>
/// <param name="Message">The English sentence.</param>
/// <param name="Values">The values in the sentence, in order: names, and numbers as formatted in the sentence.</param>
public sealed record ReportWarning(string Code, string Message, params IReadOnlyList<string> Values)
{
    /// <summary>The warning of a form.</summary>
    /// <param name="form">The form, which is named by the code.</param>
    /// <param name="values">Its values, as formatted in the sentence.</param>
    public static ReportWarning Of(SentenceForm form, params string[] values)
    {
        ArgumentNullException.ThrowIfNull(form);
        return new(form.Name, form.With([.. values]).Sentence, values);
    }

    /// <inheritdoc/>
    public override string ToString() => Message;
}
