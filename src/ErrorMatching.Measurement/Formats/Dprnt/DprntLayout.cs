namespace ErrorMatching.Measurement;

/// <summary>Which number of a line is which: positions from 0, -1 where there is none.</summary>
/// <param name="Label">The number that names the point.</param>
/// <param name="X">The first coordinate.</param>
/// <param name="Y">The second coordinate.</param>
/// <param name="Z">The third coordinate.</param>
/// <param name="HasLetters">True if the coordinates have their letters before them.</param>
internal sealed record DprntLayout(int Label, int X, int Y, int Z, bool HasLetters)
{
    /// <summary>The layout that a line shows; null if it shows none.</summary>
    public static DprntLayout? Of(List<LogWord> words) =>
        words.Exists(w => w.Letters.Length > 0) ? OfLetters(words) : OfPositions(words);

    // With letters: X and Y, Z if there is one, and one word before them for the point.
    private static DprntLayout? OfLetters(List<LogWord> words)
    {
        var (x, y, z) = (Find("X"), Find("Y"), Find("Z"));
        var label = words[0].Letters is "X" or "Y" or "Z" ? -1 : 0;
        var count = (label < 0 ? 0 : 1) + (z < 0 ? 2 : 3);
        return x >= 0 && y >= 0 && words.Count == count && words.DistinctBy(w => w.Letters).Count() == count
            && (label < 0 || IsWhole(words[0]))
            ? new(label, x, y, z, true)
            : null;

        int Find(string letter) => words.FindIndex(w => w.Letters == letter);
    }

    // Without letters: coordinates have a decimal point, and the number of a point has none.
    private static DprntLayout? OfPositions(List<LogWord> words)
    {
        var label = IsWhole(words[0]) ? 1 : 0;
        return words.Skip(label).All(w => w.Decimals >= 0) && words.Count - label is 2 or 3
            ? new(label - 1, label, label + 1, words.Count - label == 3 ? label + 2 : -1, false)
            : null;
    }

    private static bool IsWhole(LogWord word) => word.Decimals < 0 && char.IsAsciiDigit(word.Number[0]);
}
