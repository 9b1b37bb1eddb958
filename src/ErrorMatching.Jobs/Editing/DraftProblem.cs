namespace ErrorMatching.Jobs;

/// <summary>A problem in a draft, and its field.</summary>
/// <param name="Field">The field: a path of <see cref="DraftPaths"/> or of the job.</param>
/// <param name="Code">Stable code of the reader that reports it.</param>
/// <param name="Found">What was found, as the middle of a sentence; empty if <paramref name="Message"/> is complete.</param>
/// <param name="Message">What was found and what is expected, as a sentence.</param>
/// <param name="Expected">What is expected instead, as the middle of a sentence; empty if <paramref name="Message"/> is complete.</param>
public sealed record DraftProblem(string Field, string Code, string Found, string Message, string Expected = "")
{
    /// <summary>True if the field is not wrong, but not filled in yet.</summary>
    public bool IsMissing { get; init; }

    /// <summary>The size of the error, with its unit; empty if it is not measured.</summary>
    public string Amount { get; init; } = "";
}
