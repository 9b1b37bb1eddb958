using ErrorMatching.Mating;

namespace ErrorMatching.Jobs;

/// <summary>The result of checking a draft.</summary>
/// <param name="Problems">All problems, in the order of the job; empty if it can be saved.</param>
/// <param name="Job">The job; null while its file has problems.</param>
public sealed record DraftCheck(IReadOnlyList<DraftProblem> Problems, MatingJob? Job)
{
    /// <summary>Valid but probably unintended input: questions that do not prevent saving.</summary>
    public IReadOnlyList<DraftProblem> Doubts { get; init; } = [];
}
