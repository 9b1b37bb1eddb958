namespace ErrorMatching.Cell;

/// <summary>Matches file names against patterns: <c>*</c> is any characters, <c>?</c> is one. Case is ignored.</summary>
internal static class FileNamePattern
{
    /// <summary>True if a name matches the pattern. Time grows at most with the product of both lengths.</summary>
    public static bool Fits(string pattern, string name) =>
        System.IO.Enumeration.FileSystemName.MatchesSimpleExpression(Literal(pattern), name, ignoreCase: true);

    /// <summary>True if any name can match both patterns.</summary>
    public static bool Overlap(string a, string b)
    {
        // row[j]: some name matches both the rest of a from i and the rest of b from j.
        var below = new bool[b.Length + 1];
        for (var i = a.Length; i >= 0; i--)
        {
            var row = new bool[b.Length + 1];
            for (var j = b.Length; j >= 0; j--)
            {
                row[j] = (i == a.Length && j == b.Length)
                    || (i < a.Length && a[i] == '*' && (below[j] || (j < b.Length && row[j + 1])))
                    || (j < b.Length && b[j] == '*' && (row[j + 1] || (i < a.Length && below[j])))
                    || (i < a.Length && j < b.Length && a[i] != '*' && b[j] != '*' && IsOne(a[i], b[j]) && below[j + 1]);
            }

            below = row;
        }

        return below[0];
    }

    // A backslash is an escape in simple expressions; no name here contains one.
    private static string Literal(string pattern) => pattern.Replace("\\", "\\\\", StringComparison.Ordinal);

    private static bool IsOne(char a, char b) => a == '?' || b == '?' || char.ToUpperInvariant(a) == char.ToUpperInvariant(b);
}
