namespace ErrorMatching.Hmi;

/// <summary>Sentences one behind the other.</summary>
public static class Sentence
{
    // The full stop of Chinese has its room in itself.
    private const char WideStop = '。';

    /// <summary>The first of the sentences of a text.</summary>
    /// <param name="text">The text.</param>
    public static string First(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var (stop, wide) = (text.IndexOf(". ", StringComparison.Ordinal), text.IndexOf(WideStop, StringComparison.Ordinal));
        var end = stop < 0 || (wide >= 0 && wide < stop) ? wide : stop;
        return end < 0 ? text : text[..(end + 1)];
    }

    /// <summary>The sentences in a row, with a space between two of them unless the first ends with the full stop of Chinese; empty ones are left out.</summary>
    /// <param name="sentences">The sentences in their order.</param>
    public static string Joined(params IEnumerable<string> sentences)
    {
        ArgumentNullException.ThrowIfNull(sentences);
        return sentences.Where(s => s.Length > 0).Aggregate("", (before, s) => before.Length == 0 || before[^1] == WideStop ? before + s : before + " " + s);
    }
}
