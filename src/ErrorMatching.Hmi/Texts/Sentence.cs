namespace ErrorMatching.Hmi;

/// <summary>Splits and joins sentences.</summary>
public static class Sentence
{
    // The Chinese full stop includes its own space.
    private const char WideStop = '。';

    /// <summary>The first sentence of a text.</summary>
    /// <param name="text">The text.</param>
    public static string First(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var (stop, wide) = (text.IndexOf(". ", StringComparison.Ordinal), text.IndexOf(WideStop, StringComparison.Ordinal));
        var end = stop < 0 || (wide >= 0 && wide < stop) ? wide : stop;
        return end < 0 ? text : text[..(end + 1)];
    }

    /// <summary>Joins sentences with a space, unless the first one ends with a Chinese full stop; empty ones are skipped.</summary>
    /// <param name="sentences">The sentences in order.</param>
    public static string Joined(params IEnumerable<string> sentences)
    {
        ArgumentNullException.ThrowIfNull(sentences);
        return sentences.Where(s => s.Length > 0).Aggregate(
            "", (before, s) => before.Length == 0 || before[^1] == WideStop ? before + s : before + " " + s);
    }
}
