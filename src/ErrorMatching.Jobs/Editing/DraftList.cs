using System.Text.RegularExpressions;

namespace ErrorMatching.Jobs;

/// <summary>Lists in one field.</summary>
internal static partial class DraftList
{
    /// <summary>Selectors of blocks, with commas or spaces between them; a regular expression between slashes may hold both.</summary>
    public static IReadOnlyList<string> Blocks(string text) => [.. Selectors().Matches(text).Select(m => m.Value)];

    /// <summary>Names or labels, with commas between them.</summary>
    public static IReadOnlyList<string> Names(string text) => text.Split([',', ';'], StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries);

    /// <summary>The field of some items.</summary>
    public static string Join(IEnumerable<string> items) => string.Join(", ", items);

    // A slash that a separator or the end follows ends an expression.
    [GeneratedRegex(@"/([^/]|/(?!\s*([,;]|$)))+/(?=\s*([,;]|$))|[^\s,;]+", RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Selectors();
}
