using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>What a stable code of the cell or of a reader means, in the language of the screen.</summary>
/// <remarks>
/// A new code needs one text in each language: <c>Code.CODE</c> where that says all, <c>Meaning.CODE</c> where the sentence that comes with it
/// says more (it names blocks, points, files and numbers).
/// </remarks>
public static class CodeText
{
    // What a store or a machine could not do has its words already.
    private static readonly Dictionary<string, string> Outside = Enum.GetValues<StoreError>()
        .Select(e => (Code: CellCodes.Of(e), Key: $"StoreError.{e}"))
        .Concat(Enum.GetValues<TransportError>().Select(e => (Code: CellCodes.Of(e), Key: $"TransportError.{e}")))
        .ToDictionary(c => c.Code, c => c.Key, StringComparer.Ordinal);

    /// <summary>The text of a code: never the code itself.</summary>
    /// <param name="code">The code.</param>
    /// <param name="otherwise">
    /// The sentence that came with it, said where the station has no text that says all. One that it cannot say in the language of the screen
    /// is quoted after what the code means. Null for none.
    /// </param>
    public static string Of(string code, string? otherwise) =>
        Whole(code) ?? (otherwise is null ? Meaning(code) : Sentence(code, otherwise));

    /// <summary>The text that says all about a code; null if there is none.</summary>
    /// <param name="code">The code.</param>
    public static string? Whole(string code) => Texts.Current.Or("Code." + code, "") is { Length: > 0 } text ? text : null;

    /// <summary>Which part of a cell does not work (<see cref="CellTrouble.Where"/>), in the language of the screen.</summary>
    /// <param name="where">As the cell names it.</param>
    public static string Where(string where)
    {
        ArgumentNullException.ThrowIfNull(where);
        var texts = Texts.Current;
        return where.Split(' ', 2) is [var kind, var name] && texts.Or("Where." + kind, "").Contains("{0}", StringComparison.Ordinal)
            ? texts.With("Where." + kind, name)
            : texts.Or("Where." + where, where);
    }

    private static string Meaning(string code) =>
        Texts.Current.Or(Outside.GetValueOrDefault(code, "Meaning." + code), Texts.Current["Meaning.Other"]);

    private static string Sentence(string code, string sentence)
    {
        var said = RecordedText.Of(sentence);
        return said != sentence || Texts.Current.Language == Language.English
            ? said
            : Texts.Current.With("Meaning.WithSentence", Meaning(code), sentence);
    }
}
