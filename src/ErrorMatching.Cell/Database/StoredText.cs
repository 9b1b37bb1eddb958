using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Texts in the form that both kinds of store accept. They come from files and people: none may create a row that one kind of
/// store accepts and the other rejects.</summary>
internal static class StoredText
{
    /// <summary>Maximum characters of an indexed text: PostgreSQL indexes 2704 bytes, and a character has at most 3.</summary>
    public const int MostOfName = 800;

    /// <summary>Maximum characters of any other text.</summary>
    public const int MostOfSentence = 8000;

    /// <summary>A name in stored form: unpaired surrogates and the character 0 are replaced, excess length is cut off.</summary>
    public static string Name(string text) => Kept(text, MostOfName);

    /// <summary>A name in stored form, or null.</summary>
    public static string? NameOrNull(string? text) => text is null ? null : Kept(text, MostOfName);

    /// <summary>A sentence in stored form.</summary>
    public static string Sentence(string text) => Kept(text, MostOfSentence);

    /// <summary>A sentence in stored form, or null.</summary>
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
