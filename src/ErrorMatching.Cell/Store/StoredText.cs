using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Texts as both kinds of store keep them. They come from files and people: none of them may make a row that one kind of store takes and the other does not.</summary>
internal static class StoredText
{
    /// <summary>The most characters of a text that an index looks up: PostgreSQL takes 2704 bytes there, and a character has at most 3.</summary>
    public const int MostOfName = 800;

    /// <summary>The most characters of any other text.</summary>
    public const int MostOfSentence = 8000;

    /// <summary>A name as it is kept: half characters and the character 0 replaced, a longer one cut.</summary>
    public static string Name(string text) => Kept(text, MostOfName);

    /// <summary>A name or nothing as it is kept.</summary>
    public static string? NameOrNull(string? text) => text is null ? null : Kept(text, MostOfName);

    /// <summary>A sentence as it is kept.</summary>
    public static string Sentence(string text) => Kept(text, MostOfSentence);

    /// <summary>A sentence or nothing as it is kept.</summary>
    public static string? SentenceOrNull(string? text) => text is null ? null : Kept(text, MostOfSentence);

    private static string Kept(string text, int most)
    {
        if (text.Length > most) text = text[..(most - 1)] + "…";
        if (!text.AsSpan().ContainsAnyInRange('\uD800', '\uDFFF') && !text.Contains('\0')) return text;

        var kept = new StringBuilder(text.Length);
        foreach (var rune in text.EnumerateRunes())
        {
            kept.Append(rune.Value == 0 ? Rune.ReplacementChar.ToString() : rune.ToString());
        }

        return kept.ToString();
    }
}
