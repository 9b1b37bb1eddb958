using System.Globalization;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>What is wrong with a field, in the language of the screen.</summary>
internal static class ProblemText
{
    /// <summary>The text of a problem; with the reader's sentence where it says more, or where the station has none of its own.</summary>
    public static string Of(DraftProblem problem) => string.Format(CultureInfo.InvariantCulture, Texts.Current.Or("Problem." + problem.Code, "{0}"), problem.Message);
}
