namespace ErrorMatching.Hmi;

/// <summary>Sentences one behind the other.</summary>
public static class Sentence
{
    // The full stop of Chinese has its room in itself.
    private const char WideStop = '。';

    /// <summary>The sentences in a row, with a space between two of them unless the first ends with the full stop of Chinese; empty ones are left out.</summary>
    /// <param name="sentences">The sentences in their order.</param>
    public static string Joined(params IEnumerable<string> sentences)
    {
        ArgumentNullException.ThrowIfNull(sentences);
        return sentences.Where(s => s.Length > 0).Aggregate("", (before, s) => before.Length == 0 || before[^1] == WideStop ? before + s : before + " " + s);
    }
}
