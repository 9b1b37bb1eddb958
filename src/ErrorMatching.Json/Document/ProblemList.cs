using ErrorMatching.Refusals;

namespace ErrorMatching.Json;

/// <summary>Limits the problems of a document to a useful number. A hostile or wrong file could have millions.</summary>
internal static class ProblemList
{
    /// <summary>Maximum number of reported problems.</summary>
    public const int Most = 100;

    /// <summary>The first problems, followed by one that states if there are more.</summary>
    public static IReadOnlyList<Refusal> Shortened(IReadOnlyList<Refusal> problems)
    {
        if (problems.Count <= Most)
        {
            return problems;
        }

        var next = problems[Most];
        var (found, expected) = ($"more than {Most} problems", "a document of the right kind, or these corrected first");
        return [.. problems.Take(Most), Refusal.Of("too-many-problems", found, expected, next.Place)];
    }
}
