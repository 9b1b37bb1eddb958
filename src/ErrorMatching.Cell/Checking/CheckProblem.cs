using ErrorMatching.Jobs;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>A problem that a check found.</summary>
/// <param name="Errors">The errors, each with its code and a sentence; at least one.</param>
public sealed record CheckProblem(IReadOnlyList<Refusal> Errors)
{
    internal static CheckProblem Of(string code, string message) => new([new(code, message)]);
}
