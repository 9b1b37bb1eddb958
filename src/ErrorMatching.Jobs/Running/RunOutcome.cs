namespace ErrorMatching.Jobs;

/// <summary>What came of a job whose inputs could be read: a result that may be used, or the reasons why there is none.</summary>
/// <typeparam name="T">What a result is.</typeparam>
/// <param name="Result">The result; null where refused.</param>
/// <param name="Refusals">The reasons; empty where there is a result.</param>
public sealed record RunOutcome<T>(T? Result, IReadOnlyList<ErrorItem> Refusals)
    where T : class
{
    /// <summary>A result.</summary>
    internal RunOutcome(T result)
        : this(result, [])
    {
    }

    /// <summary>A refusal.</summary>
    internal RunOutcome(IReadOnlyList<ErrorItem> refusals)
        : this(null, refusals)
    {
    }
}
