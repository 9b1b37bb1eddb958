using System.CommandLine;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>The option by which somebody accepts a verdict that says not to cut.</summary>
internal sealed class AcceptOption : Option<string[]>
{
    /// <summary>The option.</summary>
    /// <param name="codes">The codes of the verdicts that may be accepted.</param>
    public AcceptOption(IEnumerable<string> codes)
        : base("--accept")
    {
        Description = "Write the program although the verdict says not to cut it: the code of that verdict, or any. May be given several "
            + "times. The report records it.";
        HelpName = "CODE";
        string[] known = [Acceptance.Any, .. codes];
        CompletionSources.Add(known);
        Validators.Add(result =>
        {
            foreach (var code in result.Tokens.Select(t => t.Value).Where(c => !known.Contains(c, StringComparer.Ordinal)))
            {
                var meant = FailureOfCommandLine.Nearest(code, known)
                    ?? known.Where(k => Begins(k, code) || Begins(code, k)).MinBy(k => k.Length);
                result.AddError(
                    $"--accept is {code}; expected {string.Join(", ", known.SkipLast(1))} or {known[^1]}."
                        + (meant is null ? "" : $" Did you mean {meant}?"));
            }
        });
    }

    private static bool Begins(string word, string start) => word.StartsWith(start, StringComparison.Ordinal);

    /// <summary>The codes that the user accepts.</summary>
    public IReadOnlyList<string> Of(ParseResult arguments) => arguments.GetValue(this) ?? [];
}
