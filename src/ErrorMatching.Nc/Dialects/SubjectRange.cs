using System.Globalization;

namespace ErrorMatching.Nc;

/// <summary>One subject of a statement as spelled in a dialect's file: <c>G1</c>, <c>G54..G59</c>, <c>TRANS</c>, <c>CYCLE81..CYCLE89</c>,
/// <c>X</c>, <c>M98</c>, <c>9810</c>.</summary>
/// <param name="Spelling">Its spelling in the file.</param>
/// <param name="Word">The word, or the part before the numbers of a range.</param>
/// <param name="First">First number, for G codes in tenths; -1 if there are no numbers.</param>
/// <param name="Last">Last number.</param>
/// <param name="Step">Difference between consecutive numbers: whole G codes are 10 apart.</param>
internal sealed record SubjectRange(string Spelling, string Word, int First, int Last, int Step)
{
    private const int MostNumber = 99_999_999;
    private const int LongestWord = 32;
    private const int LongestWordRange = 1000;
    private const int LongestNumberRange = 10_000;

    public bool HasNumbers => First >= 0;

    /// <summary>True if it names several subjects; a single one has priority over it.</summary>
    public bool IsRange => Last > First;

    /// <summary>A name for each of its subjects; equal for equal subjects, regardless of spelling.</summary>
    public IEnumerable<string> Names()
    {
        if (!HasNumbers)
        {
            yield return Word;
        }

        for (var number = First; HasNumbers && number <= Last; number += Step)
        {
            yield return Word + number.ToString(CultureInfo.InvariantCulture);
        }
    }

    /// <summary>Reads the subjects of a statement; returns the spelling of an invalid one.</summary>
    public static bool TryRead(string text, DialectTopic topic, List<SubjectRange> subjects, out string bad)
    {
        bad = text;
        foreach (var spelling in text.Split(' ', StringSplitOptions.RemoveEmptyEntries))
        {
            bad = spelling;
            var dots = spelling.IndexOf("..", StringComparison.Ordinal);
            var (first, last) = dots < 0 ? (spelling, spelling) : (spelling[..dots], spelling[(dots + 2)..]);
            var subject = topic switch
            {
                DialectTopic.Code when spelling.Length == 1 => Letter(spelling),
                DialectTopic.Code => Code(spelling, first, last) ?? Words(spelling, first, last),
                DialectTopic.OffsetTable => Numbered(spelling, "L", first, last, DialectTables.Functions - 1),
                DialectTopic.Function => Numbered(spelling, "M", first, last, DialectTables.Functions - 1),
                DialectTopic.MachineProgram =>
                    Numbered(spelling, "", first.TrimStart('O'), last.TrimStart('O'), MostNumber) ?? Words(spelling, first, last),
                DialectTopic.Letter when spelling.Length == 1 => Letter(spelling),
                _ => Words(spelling, first, last),
            };
            if (subject is not { } read)
            {
                return false;
            }

            subjects.Add(read);
        }

        return subjects.Count > 0;
    }

    /// <summary>Numbers with a letter before each: <c>P1..P99</c>; null if it is something else.</summary>
    public static SubjectRange? Numbers(string spelling, string letter)
    {
        var dots = spelling.IndexOf("..", StringComparison.Ordinal);
        return dots < 0 ? Numbered(spelling, letter, spelling, spelling, DialectTables.Functions - 1)
            : Numbered(spelling, letter, spelling[..dots], spelling[(dots + 2)..], DialectTables.Functions - 1);
    }

    private static SubjectRange? Letter(string spelling) =>
        char.IsAsciiLetterUpper(spelling[0]) ? new(spelling, spelling, -1, -1, 1) : null;

    private static SubjectRange? Code(string spelling, string first, string last)
    {
        var (from, to) = (Tenths(first), Tenths(last));
        return from >= 0 && to >= from && (first == last || (from % 10 == 0 && to % 10 == 0 && to > from))
            ? new(spelling, "G", from, to, 10)
            : null;
    }

    // G54.1 is 541; -1 if it is not a G code.
    private static int Tenths(string code)
    {
        if (!code.StartsWith('G'))
        {
            return -1;
        }

        var point = code.IndexOf('.', StringComparison.Ordinal);
        var whole = Number(point < 0 ? code.AsSpan(1) : code.AsSpan(1, point - 1), (DialectTables.Codes / 10) - 1);
        var tenth = point < 0 ? 0 : Number(code.AsSpan(point + 1), 9);
        return whole < 0 || tenth < 0 ? -1 : (whole * 10) + tenth;
    }

    private static SubjectRange? Numbered(string spelling, string prefix, string first, string last, int most)
    {
        if (!first.StartsWith(prefix, StringComparison.Ordinal) || !last.StartsWith(prefix, StringComparison.Ordinal))
        {
            return null;
        }

        var (from, to) = (Number(first.AsSpan(prefix.Length), most), Number(last.AsSpan(prefix.Length), most));
        return from >= 0 && (first == last || (to > from && to - from < LongestNumberRange)) ? new(spelling, prefix, from, to, 1) : null;
    }

    private static SubjectRange? Words(string spelling, string first, string last)
    {
        if (!IsWord(first) || !IsWord(last))
        {
            return null;
        }

        if (first == last)
        {
            return spelling == first ? new(spelling, first, -1, -1, 1) : null;
        }

        var stem = first.AsSpan().TrimEnd("0123456789");
        var (from, to) = (
            Number(first.AsSpan(stem.Length), MostNumber), Number(last.AsSpan(Math.Min(stem.Length, last.Length)), MostNumber));

        // Numbers with leading zeros would become other words.
        var isPlain = first[stem.Length..].StartsWith('0') || last.Length == stem.Length;
        return last.AsSpan().StartsWith(stem, StringComparison.Ordinal)
            && from >= 0
            && to > from
            && to - from < LongestWordRange
            && !isPlain
            ? new(spelling, stem.ToString(), from, to, 1)
            : null;
    }

    private static bool IsWord(string word) =>
        word.Length is >= 2 and <= LongestWord
            && !char.IsAsciiDigit(word[0])
            && word.All(c => char.IsAsciiLetterUpper(c) || char.IsAsciiDigit(c) || c is '_' or '$')
            && !IsCode(word);

    // A G with digits is a code, even out of range, and never a word.
    private static bool IsCode(string word) => word[0] == 'G' && !word.AsSpan(1).ContainsAnyExceptInRange('0', '9');

    private static int Number(ReadOnlySpan<char> digits, int most) =>
        digits.Length is > 0 and <= 8
            && !digits.ContainsAnyExceptInRange('0', '9')
            && int.Parse(digits, CultureInfo.InvariantCulture) is var number
            && number <= most
            ? number
            : -1;
}
