using System.Text;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Texts in the form that both kinds of store accept. They come from files and people: none may create a row that one kind of
/// store accepts and the other rejects.</summary>
internal static class StoredText
{
    /// <summary>Maximum characters of an indexed text: PostgreSQL indexes 2704 bytes, and a character has at most 3.</summary>
    public const int MostOfName = 800;

    /// <summary>Maximum characters of any other text.</summary>
    public const int MostOfStatement = StatementText.MostCharacters;

    /// <summary>A name in stored form: unpaired surrogates and the character 0 are replaced, excess length is cut off.</summary>
    public static string Name(string text) => Stored(text, MostOfName);

    /// <summary>A name in stored form, or null.</summary>
    public static string? NameOrNull(string? text) => text is null ? null : Stored(text, MostOfName);

    /// <summary>A statement in stored form.</summary>
    public static Statement Of(Statement statement) => Stored(statement, MostOfStatement);

    /// <summary>A statement in stored form, or null.</summary>
    public static Statement? OfOrNull(Statement? statement) => statement is null ? null : Stored(statement, MostOfStatement);

    /// <summary>A statement in an indexed column, or null.</summary>
    public static Statement? NameOrNull(Statement? statement) => statement is null ? null : Stored(statement, MostOfName);

    private static Statement Stored(Statement statement, int most) =>
        statement.Words is { } words && !StatementText.IsMarked(words) ? Stored(words, most)
        : statement.Fitted(most) is { Words: { } cut } shorter && !StatementText.IsMarked(cut) ? Stored(cut, most)
        : statement.Fitted(most);

    private static string Stored(string text, int most)
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
