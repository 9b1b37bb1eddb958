namespace ErrorMatching.Jobs;

/// <summary>Something that is wrong in a draft, at the field where it is.</summary>
/// <param name="Field">Where: a path of <see cref="DraftPaths"/> or of the job.</param>
/// <param name="Code">Stable word of the reader that says so.</param>
/// <param name="Found">What was found, as the middle of a sentence; empty where <paramref name="Message"/> says all.</param>
/// <param name="Message">What was found and what is expected, as a sentence.</param>
/// <param name="Expected">What is expected instead, as the middle of a sentence; empty where <paramref name="Message"/> says all.</param>
public sealed record DraftProblem(string Field, string Code, string Found, string Message, string Expected = "")
{
    /// <summary>True if nothing is wrong there, but something is still to be filled in.</summary>
    public bool IsMissing { get; init; }

    /// <summary>How far off it is, with its unit; empty where that is not measured.</summary>
    public string Amount { get; init; } = "";
}
