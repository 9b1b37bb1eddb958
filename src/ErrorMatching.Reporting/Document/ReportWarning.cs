namespace ErrorMatching.Reporting;

/// <summary>What a person should know before using a result: as a sentence, and by a stable code with its values, for those who say it in another language.</summary>
/// <param name="Code">Which warning it is, such as <c>sparse-points</c>.</param>
/// <param name="Message">The English sentence.</param>
/// <param name="Values">What the sentence says about this case, in its order: names, and figures as the sentence shows them.</param>
public sealed record ReportWarning(string Code, string Message, params IReadOnlyList<string> Values)
{
    /// <summary>The sentence.</summary>
    public override string ToString() => Message;
}
