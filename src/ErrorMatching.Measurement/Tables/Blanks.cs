using System.Text;

namespace ErrorMatching.Measurement;

/// <summary>Tables whose cells are separated by blanks, as many as align the columns.</summary>
internal static class Blanks
{
    /// <summary>The text with one tab for each run of blanks and tabs, and none at the ends of lines. Blanks between quotation marks
    /// stay.</summary>
    public static string ToTabs(string text)
    {
        var single = new StringBuilder(text.Length);
        var (isQuoted, isStart, hasBlank) = (false, true, false);
        foreach (var c in text)
        {
            if (!isQuoted && (c is ' ' or '\t'))
            {
                hasBlank = true;
                continue;
            }

            var isEnd = !isQuoted && (c is '\n' or '\r');
            if (hasBlank && !isStart && !isEnd)
            {
                single.Append('\t');
            }

            single.Append(c);
            (isStart, hasBlank) = (isEnd, false);
            isQuoted ^= c == '"';
        }

        return single.ToString();
    }
}
