using System.Globalization;
using ErrorMatching.Cell;
using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>Translates recorded texts of the cell to the display language. The record itself stays unchanged. A sentence without
/// a known form, such as a person's reason, is shown as is.</summary>
public static class RecordedText
{
    // No basis has more sentences than this.
    private const int MostSentences = 50;
    private const string WordKey = "RecordedWord.";

    private static readonly (SentenceForm Form, string Key)[] Forms = [
        .. Recorded.All.Select(f => (f, "Recorded." + f.Name)),
        .. WarningForms.All.Select(f => (f, "Warning." + f.Name)),
        .. RefusalForms.All.Select(f => (f, "Refusal." + f.Name))];

    /// <summary>A recorded text in the display language.</summary>
    public static string Of(string recorded)
    {
        ArgumentNullException.ThrowIfNull(recorded);
        return Sentences(recorded) ?? Whole(recorded) ?? recorded;
    }

    /// <summary>The basis of a correction's step. A reason without a known form is shown by its code, if that is known.</summary>
    /// <param name="basis">The recorded basis.</param>
    /// <param name="correction">The current correction; null if it is not available.</param>
    public static string Of(string basis, Correction? correction)
    {
        var shown = Of(basis);
        return shown == basis && correction is { Code: { } code, Reason: { } reason } && basis == reason ? CodeText.Of(code, basis) : shown;
    }

    /// <summary>Who did it: a user's name, or the cell itself.</summary>
    public static string Who(string name) => Texts.Current.Or("RecordedWho." + name, name);

    // The first form, in their order, whose values all have the right kind.
    private static string? Whole(string recorded, string? prefix = null)
    {
        foreach (var (form, key) in Forms)
        {
            if ((prefix is null || form.Name.StartsWith(prefix, StringComparison.Ordinal))
                && form.Read(recorded) is { } values
                && Shown(form, values) is { } shown)
            {
                return Texts.Current.With(key, shown);
            }
        }

        return null;
    }

    // Several sentences in a row: known ones are translated, the rest stays. Tried before the whole text, because the last name
    // of the first sentence would otherwise match all the others.
    private static string? Sentences(string recorded)
    {
        var end = recorded.IndexOf(". ", StringComparison.Ordinal);
        for (var i = 0; i < MostSentences && end >= 0; i++, end = recorded.IndexOf(". ", end + 1, StringComparison.Ordinal))
        {
            if (Whole(recorded[..(end + 1)]) is { } first)
            {
                return Sentence.Joined(first, Of(recorded[(end + 2)..]));
            }
        }

        return null;
    }

    private static object[]? Shown(SentenceForm form, IReadOnlyList<string> values)
    {
        var shown = new object[values.Count];
        for (var i = 0; i < shown.Length; i++)
        {
            if (Shown(form.Kinds[i], values[i]) is not { } value)
            {
                return null;
            }

            shown[i] = value;
        }

        return shown;
    }

    // Null: the value is not of this kind, so the sentence has another form.
    private static string? Shown(string kind, string value) => kind switch
    {
        "" => value,
        "any" => Of(value),
        "word" => Texts.Current.Or(WordKey + value, "") is { Length: > 0 } word ? word : null,
        "amount" => Texts.Current.Or(WordKey + value, value),
        "state" => Enum.TryParse<CorrectionState>(value, ignoreCase: true, out var state) ? Texts.Current.Word(state) : null,
        ['0', ..] => double.TryParse(value, NumberStyles.Float, CultureInfo.InvariantCulture, out _) ? value : null,
        ['y', 'y', ..] => value,
        _ => Several(kind + "-", value),
    };

    private static string? Several(string prefix, string value)
    {
        var parts = value.Split("; ").Select(p => Whole(p, prefix)).ToArray();
        return parts.All(p => p is not null) ? string.Join(Texts.Current["Recorded.Between"], parts) : Whole(value, prefix);
    }
}
