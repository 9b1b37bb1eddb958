using System.Globalization;
using System.Text.RegularExpressions;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>Texts of problems in the display language.</summary>
internal static partial class ProblemText
{
    private static readonly string[] OfNumbers = ["wrong-type", "text-for-number", "not-a-number"];

    /// <summary>The text of a problem: the field's own, otherwise that of the code with its details, otherwise the reader's
    /// sentence.</summary>
    /// <param name="problem">The problem.</param>
    /// <param name="isEmpty">True if the field is empty: then the number is missing, not wrong.</param>
    public static string Of(DraftProblem problem, bool isEmpty = false)
    {
        var key = "Problem." + (isEmpty && OfNumbers.Contains(problem.Code) ? "too-short" : problem.Code);
        var field = Index().Replace(problem.Field[(problem.Field.LastIndexOf('.') + 1)..], "");
        var text = Texts.Current.Or($"{key}.{field}", Texts.Current.Or(key, ""));
        return text.Length > 0
            ? string.Format(CultureInfo.InvariantCulture, text, About(problem), problem.Amount)
            : CodeText.Of(problem.Code, problem.Message);
    }

    // Numbers and names need no translation; of the reader's words, only those of a bound are translated.
    private static string About(DraftProblem problem) =>
        Bound().Match(problem.Expected) is { Success: true } bound
            ? Texts.Current.With("Problem.Bound." + bound.Groups["word"].Value.Replace(' ', '-'), bound.Groups["number"].Value)
        : problem.Expected.Length > 0 ? problem.Expected : problem.Found.Length > 0 ? problem.Found : problem.Message;

    [GeneratedRegex(
        @"^(?<word>at least|more than|at most|less than) (?<number>[-+0-9.eE]+)$",
        RegexOptions.ExplicitCapture | RegexOptions.CultureInvariant,
        Timeout.Infinite)]
    private static partial Regex Bound();

    [GeneratedRegex(@"[\[/].*$", RegexOptions.CultureInvariant, Timeout.Infinite)]
    private static partial Regex Index();
}
