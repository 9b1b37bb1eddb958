using System.Text.RegularExpressions;

namespace ErrorMatching.Measurement;

/// <summary>A pattern that tells from its name, a header field or a column whose measurement a file is.</summary>
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
            throw new MeasurementException(MeasurementError.BadPattern, $"the pattern {MeasurementException.Quote(pattern)} of a rule about {subject}", "a regular expression without look-around and back references: " + e.Message.TrimEnd('.'), cause: e);
        }
    }

    /// <summary>A rule about the name of the file, without its folders.</summary>
    /// <param name="pattern">A regular expression without look-around and back references, sought anywhere in the name.</param>
    /// <exception cref="MeasurementException">The pattern is no such expression (<see cref="MeasurementError.BadPattern"/>).</exception>
    public static SourceRule OfFileName(string pattern) => new("the file name", pattern, f => [NameOf(f.File)]);

    /// <summary>A rule about the value of a header field. A file without the field does not match.</summary>
    /// <param name="name">Name of the field, compared without regard to case.</param>
    /// <param name="pattern">A regular expression without look-around and back references, sought anywhere in the value.</param>
    /// <exception cref="MeasurementException">The pattern is no such expression (<see cref="MeasurementError.BadPattern"/>).</exception>
    public static SourceRule OfHeaderField(string name, string pattern) =>
        new($"the header field {name}", pattern, f => [.. f.HeaderFields.Where(h => string.Equals(h.Name, name, StringComparison.OrdinalIgnoreCase)).Select(h => h.Value)]);

    /// <summary>A rule about the values of a column: all of them must match. A file without the column does not.</summary>
    /// <param name="name">Name of the column, compared without regard to case.</param>
    /// <param name="pattern">A regular expression without look-around and back references, sought anywhere in each value.</param>
    /// <exception cref="MeasurementException">The pattern is no such expression (<see cref="MeasurementError.BadPattern"/>).</exception>
    public static SourceRule OfColumn(string name, string pattern) => new($"the column {name}", pattern, f => f.ColumnTexts(name) ?? []);

    /// <summary>True if the file has what the rule is about and all of it matches the pattern.</summary>
    /// <remarks>The expression never backtracks: its time grows with the length of the text and needs no limit by the clock.</remarks>
    public bool Matches(MeasurementFile file)
    {
        var texts = _texts(file);
        return texts.Count > 0 && texts.All(t => _regex.IsMatch(t));
    }

    /// <summary>The rule in words, as errors show it.</summary>
    public override string ToString() => $"{_subject} matches /{_regex}/";

    // A path of Windows may be judged on Linux and the other way round.
    private static string NameOf(string path) => path[(path.LastIndexOfAny(['/', '\\']) + 1)..];
}
