using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary>Why there is no result.</summary>
/// <param name="exit">The exit code of the process.</param>
/// <param name="errors">What is wrong; at least one item.</param>
internal sealed class Failure(ExitCode exit, params IReadOnlyList<ErrorItem> errors) : Outcome
{
    /// <summary>The exit code of the process.</summary>
    public ExitCode Exit => exit;

    /// <summary>What is wrong; at least one item.</summary>
    public IReadOnlyList<ErrorItem> Errors => errors;
}
