namespace ErrorMatching.Freeform;

/// <summary>The outcome of a compensation: a result, or the reasons for refusing it.</summary>
/// <param name="Result">The result; null if refused.</param>
/// <param name="Refusals">The reasons; empty if there is a result.</param>
public sealed record CompensationOutcome(CompensationResult? Result, IReadOnlyList<FreeformRefusal> Refusals)
{
    internal static CompensationOutcome Refused(string code, string message) => new(null, [new(code, message)]);
}
