namespace ErrorMatching.Jobs;

/// <summary>Lists entered in one field.</summary>
internal static class DraftList
{
    /// <summary>The items of a list of the job.</summary>
    /// <param name="key">The key of the list.</param>
    /// <param name="text">The text as typed.</param>
    public static IReadOnlyList<string> Items(string key, string text) => key == FeatureDraft.BlocksKey ? Blocks(text) : Names(text);

    /// <summary>Block selectors separated by commas or spaces; a regular expression between slashes may contain both.</summary>
    public static IReadOnlyList<string> Blocks(string text)
    {
        var selectors = new List<string>();
        var (at, mayClose) = (0, true);
        while (at < text.Length)
        {
            if (IsSeparator(text[at]))
            {
                at++;
                continue;
            }

            var end = -1;
            if (text[at] == '/' && mayClose)
            {
                var close = Closing(text, at + 1);

                // Once no closing slash is left, do not search for one again.
                (mayClose, end) = (close >= 0, close > at + 1 ? close + 1 : -1);
            }

            if (end < 0)
            {
                end = at + 1;
                while (end < text.Length && !IsSeparator(text[end]))
                {
                    end++;
                }
            }

            selectors.Add(text[at..end]);
            at = end;
        }

        return selectors;
    }

    /// <summary>Names or labels, separated by commas.</summary>
    public static IReadOnlyList<string> Names(string text) =>
        text.Split([',', ';'], StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries);

    /// <summary>The field text for some items.</summary>
    public static string Join(IEnumerable<string> items) => string.Join(", ", items);

    // The first slash followed by a comma, a semicolon or the end closes an expression; -1 if there is none.
    private static int Closing(string text, int from)
    {
        for (var at = text.IndexOf('/', from); at >= 0; at = text.IndexOf('/', at + 1))
        {
            var rest = text.AsSpan(at + 1).TrimStart();
            if (rest.IsEmpty || rest[0] is ',' or ';')
            {
                return at;
            }
        }

        return -1;
    }

    private static bool IsSeparator(char c) => char.IsWhiteSpace(c) || c is ',' or ';';
}
