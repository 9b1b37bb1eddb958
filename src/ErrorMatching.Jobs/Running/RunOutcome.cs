namespace ErrorMatching.Jobs;

/// <summary>Outcome of a job with readable inputs: a usable result, or the reasons why there is none.</summary>
/// <typeparam name="T">Type of the result.</typeparam>
/// <param name="Result">The result; null if refused.</param>
/// <param name="Refusals">The reasons; empty if there is a result.</param>
public sealed record RunOutcome<T>(T? Result, IReadOnlyList<ErrorItem> Refusals)
    where T : class
{
    internal RunOutcome(T result)
        : this(result, [])
    {
    }

    internal RunOutcome(IReadOnlyList<ErrorItem> refusals)
        : this(null, refusals)
    {
    }
}
