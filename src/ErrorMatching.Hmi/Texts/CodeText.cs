using ErrorMatching.Cell;
using ErrorMatching.Mating;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>Texts in the display language for the stable codes of the cell and of file readers.</summary>
/// <remarks>A new code needs one text in each language: <c>Code.CODE</c> if the text is complete, or <c>Meaning.CODE</c> if the
/// accompanying sentence says more (it names blocks, points, files and numbers).</remarks>
internal static class CodeText
{
    // Errors of a store, a machine or a broker already have texts.
    private static readonly Dictionary<string, string> Outside = Enum.GetValues<StoreError>()
        .Select(e => (Code: CellCodes.Of(e), Key: $"StoreError.{e}"))
        .Concat(Enum.GetValues<TransportError>().Select(e => (Code: CellCodes.Of(e), Key: $"TransportError.{e}")))
        .Concat(Enum.GetValues<BrokerError>().Select(e => (Code: CellCodes.Of(e), Key: $"BrokerError.{e}")))
        .ToDictionary(c => c.Code, c => c.Key, StringComparer.Ordinal);

    /// <summary>The text of a code; never the code itself.</summary>
    /// <param name="code">The code.</param>
    /// <param name="otherwise">What came with the code, used if the station has no complete text for it. Words are quoted after
    /// the meaning of the code. Null for none.</param>
    public static string Of(string code, Statement? otherwise) =>
        Whole(code) ?? (
            otherwise is null ? Meaning(code)
            : otherwise.IsCoded || Texts.Current.Language == Language.English ? RecordedText.Of(otherwise)
            : Texts.Current.With("Meaning.WithSentence", Meaning(code), otherwise.Sentence));

    /// <summary>The text of a refusal.</summary>
    /// <param name="refusal">The refusal.</param>
    public static string Of(Refusal refusal)
    {
        ArgumentNullException.ThrowIfNull(refusal);
        return Of(refusal.Code, RefusalForms.StatementOf(refusal));
    }

    /// <summary>The complete text of a code; null if there is none.</summary>
    /// <param name="code">The code.</param>
    public static string? Whole(string code) => Texts.Current.Or("Code." + code, "") is { Length: > 0 } text ? text : null;

    /// <summary>The part of a cell that does not work (<see cref="CellTrouble.Where"/>), in the display language.</summary>
    /// <param name="where">The cell's name for it.</param>
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
}
