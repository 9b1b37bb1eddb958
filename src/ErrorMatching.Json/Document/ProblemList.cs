namespace ErrorMatching.Json;

/// <summary>The problems of a document, up to a number that a person can use: a hostile or wrong file could have millions.</summary>
internal static class ProblemList
{
    /// <summary>The most that are reported.</summary>
    public const int Most = 100;

    /// <summary>The first problems, with a last one that says so if there are more.</summary>
    public static IReadOnlyList<JsonProblem> Shortened(IReadOnlyList<JsonProblem> problems)
    {
        if (problems.Count <= Most)
        {
            return problems;
        }

        var next = problems[Most];
        var (found, expected) = ($"more than {Most} problems", "a document of the right kind, or these corrected first");
        return [.. problems.Take(Most), new("too-many-problems", next.Path, next.Place, found, expected, $"found {found}; expected {expected}")];
    }
}
