using ErrorMatching.Mating;

namespace ErrorMatching.Jobs;

/// <summary>What a draft comes to.</summary>
/// <param name="Problems">Everything that is wrong, in the order of the job; empty if it can be saved.</param>
/// <param name="Job">The job; null while something is wrong with its file.</param>
public sealed record DraftCheck(IReadOnlyList<DraftProblem> Problems, MatingJob? Job)
{
    /// <summary>What can be used and is hardly meant: questions that keep nothing from being saved.</summary>
    public IReadOnlyList<DraftProblem> Doubts { get; init; } = [];
}
