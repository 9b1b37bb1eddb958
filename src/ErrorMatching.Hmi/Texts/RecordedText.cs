using ErrorMatching.Cell;
using ErrorMatching.Freeform;
using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>Recorded statements in the display language. Words, such as a person's reason or a sentence of an earlier version, are shown
/// as they were written.</summary>
internal static class RecordedText
{
    private const string WordKey = "RecordedWord.";

    private static readonly Dictionary<string, string> Keys = Recorded.All.Select(f => (f.Name, "Recorded." + f.Name))
        .Concat(WarningForms.All.Select(f => (f.Name, "Warning." + f.Name)))
        .Concat(SurfaceWarningForms.All.Select(f => (f.Name, "Warning." + f.Name)))
        .Concat(RefusalForms.All.Select(f => (f.Name, "Refusal." + f.Name)))
        .ToDictionary(StringComparer.Ordinal);

    /// <summary>A statement in the display language; the English sentence of a code that this station does not know.</summary>
    public static string Of(Statement statement)
    {
        ArgumentNullException.ThrowIfNull(statement);
        return statement.Words
            ?? (statement.Code is "" ? Sentence.Joined(statement.Values.Select(Of))
            : statement.Form is { } form && Keys.TryGetValue(form.Name, out var key)
            ? Texts.Current.With(key, [.. statement.Values.Select((v, i) => Shown(form.Kinds[i], v))])
            : statement.Sentence);
    }

    /// <summary>The basis of a correction's step. A reason in words is shown by its code, if that is known.</summary>
    /// <param name="basis">The recorded basis.</param>
    /// <param name="correction">The current correction; null if it is not available.</param>
    public static string Of(Statement basis, Correction? correction)
    {
        ArgumentNullException.ThrowIfNull(basis);
        return !basis.IsCoded && correction is { Code: { } code, Reason: { } reason } && basis == reason
            ? CodeText.Of(code, basis)
            : Of(basis);
    }

    /// <summary>Who did it: a user's name, or the cell itself.</summary>
    public static string Who(string name) => Texts.Current.Or("RecordedWho." + name, name);

    private static string Shown(string kind, Statement value) =>
        SentenceForm.SeparatorOf(kind) is { } separator
            ? string.Join(Texts.Current[separator == ", " ? "List.Between" : "Recorded.Between"], value.Parts.Select(Of))
        : value.Words is not { } words ? Of(value)
        : kind switch
        {
            SentenceForm.Word => Texts.Current.Or(WordKey + words, words),
            SentenceForm.State =>
                Enum.TryParse<CorrectionState>(words, ignoreCase: true, out var state) ? Texts.Current.Word(state) : words,
            _ => SentenceForm.Formatted(kind, words) ?? words,
        };
}
