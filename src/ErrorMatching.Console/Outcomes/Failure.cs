using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>Why there is no result.</summary>
/// <param name="exit">The exit code of the process.</param>
/// <param name="errors">The errors; at least one.</param>
internal sealed class Failure(ExitCode exit, params IReadOnlyList<Refusal> errors) : VerbResult
{
    /// <summary>The exit code of the process.</summary>
    public ExitCode Exit => exit;

    /// <summary>The errors; at least one.</summary>
    public IReadOnlyList<Refusal> Errors => errors;
}
