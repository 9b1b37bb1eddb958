using System.Text;
using System.Text.RegularExpressions;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>A shop's description of the lines of a log: text with places for the label and the coordinates,
/// <c>TP{label} X{x} Y{y}</c>.</summary>
/// <remarks>Blanks stand for one blank or more. Blanks may also be before a number and behind its sign. <c>{}</c> is a word that is not
/// needed. A line that begins with the pattern's own first text must match all of it; other lines are skipped. If the pattern begins with a
/// place, every line must match.</remarks>
internal sealed partial class LinePattern
{
    private const int LongestPattern = 500;

    private const string Expected =
        "text with {x} and {y}, and {z} and {label} where the log has them, each once, such as TP{label} X{x} Y{y}";

    private readonly string _text;
    private readonly string _first;
    private readonly Regex _regex;

    private LinePattern(string text, string first, bool decimalComma)
    {
        (_text, _first) = (text, first);
        _regex = new(
            Expression(text, decimalComma),
            RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture | RegexOptions.NonBacktracking,
            Regex.InfiniteMatchTimeout);
    }

    /// <summary>Reads a description.</summary>
    /// <param name="text">The description.</param>
    /// <param name="decimalComma">True if numbers have decimal commas.</param>
    /// <exception cref="InputException">It is no such text (<see cref="MeasurementError.BadFormat"/>).</exception>
    public static LinePattern Parse(string text, bool decimalComma)
    {
        text = text.Trim();
        var places = Places().Matches(text).Select(m => m.Value).Where(p => p != "{}").ToArray();
        var rest = Places().Replace(text, "");
        return text.Length <= LongestPattern && places.Contains("{x}") && places.Contains("{y}")
            && places.Distinct(StringComparer.Ordinal).Count() == places.Length && !rest.AsSpan().ContainsAny('{', '}')
                ? new(text, text[..text.IndexOf('{', StringComparison.Ordinal)].TrimEnd(), decimalComma)
                : throw MeasurementRefusal.Of(MeasurementError.BadFormat, MeasurementRefusal.Quote(text), Expected);
    }

    /// <summary>Reads the points of a log.</summary>
    /// <exception cref="InputException">A line that must match does not, or a point cannot be used.</exception>
    public MeasuredContent Read(MeasurementBytes source, MeasurementFormat format)
    {
        var points = new LogPoints(source.File, format.Unit, format.MaxPoints);
        foreach (var line in LogLines.Of(source, format).Where(l => l.Number > format.SkipLines))
        {
            var found = _regex.Match(line.Text);
            if (found.Success)
            {
                points.Add(
                    Cell(line, found, "label"), Cell(line, found, "x")!.Value, Cell(line, found, "y")!.Value, Cell(line, found, "z"));
            }
            else if (line.Text.StartsWith(_first, StringComparison.Ordinal) && line.Text != LogLines.Bracket)
            {
                throw line.Fail(
                    MeasurementError.BadStructure,
                    MeasurementRefusal.Quote(line.Text),
                    $"a line like {MeasurementRefusal.Quote(_text)}, as \"line\" of the format says: the line is cut off or damaged");
            }
        }

        return points.Content(!_text.Contains("{label}", StringComparison.Ordinal));
    }

    // The column of a word is its position among those that blanks separate.
    private static Cell? Cell(TextLine line, Match found, string name) => found.Groups[name] is { Success: true } group
        ? line.Cell(
            group.Value.Replace(" ", "", StringComparison.Ordinal).Replace("\t", "", StringComparison.Ordinal),
            1 + Words(line.Text.AsSpan(0, group.Index)),
            name)
        : null;

    private static int Words(ReadOnlySpan<char> text)
    {
        var (count, isBlank) = (0, true);
        foreach (var c in text)
        {
            count += isBlank && c is not (' ' or '\t') ? 1 : 0;
            isBlank = c is ' ' or '\t';
        }

        return isBlank ? count : count - 1;
    }

    private static string Expression(string text, bool decimalComma)
    {
        var point = decimalComma ? "," : @"\.";
        var expression = new StringBuilder("^");
        for (var i = 0; i < text.Length; i++)
        {
            if (text[i] == '{')
            {
                var end = text.IndexOf('}', i);
                expression.Append(text[(i + 1)..end] switch
                {
                    "" => @"[^ \t]+",
                    "label" => @"(?<label>[^ \t]+)",
                    var axis => $@"[ \t]*(?<{axis}>[-+]?[ \t]*([0-9]+{point}?[0-9]*|{point}[0-9]+))",
                });
                i = end;
            }
            else if (text[i] is not (' ' or '\t'))
            {
                expression.Append(Regex.Escape(text[i].ToString()));
            }
            else if (text[i + 1] is not (' ' or '\t'))
            {
                expression.Append(@"[ \t]+");
            }
        }

        return expression.Append('$').ToString();
    }

    [GeneratedRegex(@"\{(x|y|z|label|)\}", RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Places();
}
