using System.Text.RegularExpressions;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>A pattern that identifies the source of a measurement by its file name, a header field or a column.</summary>
public sealed class SourceRule
{
    private readonly Func<MeasurementFile, IReadOnlyList<string>> _texts;
    private readonly string _subject;
    private readonly Regex _regex;

    private SourceRule(string subject, string pattern, Func<MeasurementFile, IReadOnlyList<string>> texts)
    {
        (_subject, _texts) = (subject, texts);
        try
        {
            _regex = new(pattern, RegexOptions.NonBacktracking | RegexOptions.CultureInvariant, Regex.InfiniteMatchTimeout);
        }
        catch (Exception e) when (e is ArgumentException or NotSupportedException)
        {
            throw MeasurementRefusal.Of(
                MeasurementError.BadPattern,
                $"the pattern {MeasurementRefusal.Quote(pattern)} of a rule about {subject}",
                "a regular expression without look-around and back references: " + e.Message.TrimEnd('.'),
                cause: e);
        }
    }

    /// <summary>A rule for the file name without folders.</summary>
    /// <param name="pattern">A regular expression without lookaround and backreferences, searched anywhere in the name.</param>
    /// <exception cref="InputException">The pattern is not such an expression
    /// (<see cref="MeasurementError.BadPattern"/>).</exception>
    public static SourceRule OfFileName(string pattern) => new("the file name", pattern, f => [NameOf(f.File)]);

    /// <summary>A rule for the value of a header field. A file without the field does not match.</summary>
    /// <param name="name">Name of the field; case is ignored.</param>
    /// <param name="pattern">A regular expression without lookaround and backreferences, searched anywhere in the value.</param>
    /// <exception cref="InputException">The pattern is not such an expression
    /// (<see cref="MeasurementError.BadPattern"/>).</exception>
    public static SourceRule OfHeaderField(string name, string pattern) =>
        new(
            $"the header field {name}",
            pattern,
            f => [.. f.HeaderFields.Where(h => string.Equals(h.Name, name, StringComparison.OrdinalIgnoreCase)).Select(h => h.Value)]);

    /// <summary>A rule for the values of a column, all of which must match. A file without the column does not match.</summary>
    /// <param name="name">Name of the column; case is ignored.</param>
    /// <param name="pattern">A regular expression without lookaround and backreferences, searched anywhere in each value.</param>
    /// <exception cref="InputException">The pattern is not such an expression
    /// (<see cref="MeasurementError.BadPattern"/>).</exception>
    public static SourceRule OfColumn(string name, string pattern) => new($"the column {name}", pattern, f => f.ColumnTexts(name) ?? []);

    /// <summary>True if the file has the rule's subject and all its values match the pattern.</summary>
    /// <remarks>The expression never backtracks. Its time is proportional to the length of the text and needs no timeout.</remarks>
    public bool Matches(MeasurementFile file)
    {
        var texts = _texts(file);
        return texts.Count > 0 && texts.All(t => _regex.IsMatch(t));
    }

    /// <summary>The rule in words, for errors.</summary>
    public override string ToString() => $"{_subject} matches /{_regex}/";

    // A Windows path may be evaluated on Linux and vice versa.
    private static string NameOf(string path) => path[(path.LastIndexOfAny(['/', '\\']) + 1)..];
}
