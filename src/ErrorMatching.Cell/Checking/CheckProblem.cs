using ErrorMatching.Jobs;

namespace ErrorMatching.Cell;

/// <summary>What a check found wrong.</summary>
/// <param name="Errors">Each with its code and a sentence; at least one.</param>
public sealed record CheckProblem(IReadOnlyList<ErrorItem> Errors)
{
    internal static CheckProblem Of(string code, string message) => new([new(code, message)]);
}
