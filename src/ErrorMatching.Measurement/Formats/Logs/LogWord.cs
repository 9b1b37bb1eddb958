namespace ErrorMatching.Measurement;

/// <summary>A number in a log, with the letters before it and its position in the line.</summary>
/// <param name="Letters">The letters before it in upper case; empty if there are none.</param>
/// <param name="Number">The number, with its sign directly before it.</param>
/// <param name="Position">Which number of the line it is, from 1.</param>
internal readonly record struct LogWord(string Letters, string Number, int Position)
{
    /// <summary>Number of digits behind the decimal point; -1 if it has none.</summary>
    public int Decimals => Number.IndexOf('.', StringComparison.Ordinal) is var point && point < 0 ? -1 : Number.Length - point - 1;

    /// <summary>The words of a line: numbers with or without letters before them, separated by blanks or single commas. Blanks may pad a
    /// number, also behind its letters and behind its sign. Null if the line has anything else.</summary>
    public static List<LogWord>? Read(string line)
    {
        var words = new List<LogWord>();
        for (var i = 0; ;)
        {
            Skip(line, ref i);
            if (i == line.Length)
            {
                return words.Count > 0 ? words : null;
            }

            if (line[i] == ',' && words.Count > 0)
            {
                i++;
                Skip(line, ref i);
            }

            var letters = Take(line, ref i, char.IsAsciiLetter);
            Skip(line, ref i);
            var sign = i < line.Length && line[i] is '+' or '-' ? line[i++].ToString() : "";
            Skip(line, ref i);
            var start = i;
            var digits = Take(line, ref i, char.IsAsciiDigit).Length;
            if (i < line.Length && line[i] == '.')
            {
                i++;
                digits += Take(line, ref i, char.IsAsciiDigit).Length;
            }

            // A second point, or letters directly behind a number without a blank, are read as the next word or refused there.
            if (digits == 0 || (i < line.Length && line[i] == '.'))
            {
                return null;
            }

            words.Add(new(letters.ToUpperInvariant(), sign + line[start..i], words.Count + 1));
        }
    }

    private static void Skip(string line, ref int i) => _ = Take(line, ref i, c => c is ' ' or '\t');

    private static string Take(string line, ref int i, Func<char, bool> isPart)
    {
        var start = i;
        while (i < line.Length && isPart(line[i]))
        {
            i++;
        }

        return line[start..i];
    }
}
