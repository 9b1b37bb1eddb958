namespace ErrorMatching.Freeform;

/// <summary>What came of a compensation: a result, or the reasons why there is none.</summary>
/// <param name="Result">The result; null if it was refused.</param>
/// <param name="Refusals">Why not; empty if there is a result.</param>
public sealed record CompensationOutcome(CompensationResult? Result, IReadOnlyList<FreeformRefusal> Refusals)
{
    internal static CompensationOutcome Refused(string code, string message) => new(null, [new(code, message)]);
}
