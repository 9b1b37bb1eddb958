namespace ErrorMatching.Measurement;

/// <summary>Counts line breaks as editors do: \n, \r\n and \r.</summary>
internal static class LineBreaks
{
    public static int Count(ReadOnlySpan<char> text)
    {
        var lastLine = 0;
        return Count(text, ref lastLine);
    }

    /// <summary>Counts the breaks and updates the start of the last line.</summary>
    public static int Count(ReadOnlySpan<char> text, ref int lastLine)
    {
        var count = 0;
        for (var i = 0; i < text.Length; i++)
        {
            if (text[i] == '\n' || (text[i] == '\r' && !(i + 1 < text.Length && text[i + 1] == '\n')))
            {
                count++;
                lastLine = i + 1;
            }
        }

        return count;
    }

    /// <summary>The position after the next line break, or the end of the text.</summary>
    public static int NextLine(string text, int start)
    {
        var end = text.AsSpan(start).IndexOfAny('\n', '\r');
        return end < 0 ? text.Length : start + end + (text.AsSpan(start + end).StartsWith("\r\n") ? 2 : 1);
    }
}
