using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>A range of numbered labels: <c>5..14</c> stands for 5, 6, ... 14, and <c>P05..P14</c> for P05, P06, ... P14.</summary>
public static class LabelRange
{
    private const string Dots = "..";
    private const int LongestRange = 100_000;
    private const int MostDigits = 9;

    /// <summary>Returns the labels of a range in ascending order. A text without two dots is returned unchanged.</summary>
    /// <param name="range">A label, or two labels with a common prefix that end in integers, in ascending order, separated by two dots. If
    /// the first number has leading zeros, all numbers have the same number of digits.</param>
    /// <exception cref="InputException">The range descends, is longer than 100,000, or its ends are not such labels
    /// (<see cref="MeasurementError.BadRange"/>).</exception>
    public static IReadOnlyList<string> Expand(string range)
    {
        var dots = range.IndexOf(Dots, StringComparison.Ordinal);
        if (dots < 0)
        {
            var label = range.Trim();
            return label.Length > 0 ? [label] : throw Bad(range, "a label, or a range such as 5..14");
        }

        var (prefix, firstDigits) = Split(range[..dots].Trim(), range);
        var (otherPrefix, lastDigits) = Split(range[(dots + Dots.Length)..].Trim(), range);
        if (!string.Equals(prefix, otherPrefix, StringComparison.Ordinal))
        {
            throw Bad(range, "the same letters before both numbers, such as P5..P14");
        }

        var first = int.Parse(firstDigits, NumberStyles.None, CultureInfo.InvariantCulture);
        var last = int.Parse(lastDigits, NumberStyles.None, CultureInfo.InvariantCulture);
        var width = firstDigits.Length > 1 && firstDigits[0] == '0' ? firstDigits.Length : 1;
        if (last < first || last - first >= LongestRange)
        {
            throw Bad(range, $"the smaller number first and at most {LongestRange} labels");
        }

        if (!string.Equals(Number(last, width), lastDigits, StringComparison.Ordinal))
        {
            throw Bad(range, "both numbers with the same leading zeros, such as P05..P14");
        }

        return [.. Enumerable.Range(first, last - first + 1).Select(n => prefix + Number(n, width))];
    }

    private static (string Prefix, string Digits) Split(string label, string range)
    {
        var start = label.Length;
        while (start > 0 && char.IsAsciiDigit(label[start - 1]))
        {
            start--;
        }

        return label.Length - start is > 0 and <= MostDigits
            ? (label[..start], label[start..])
            : throw Bad(range, "a whole number at the end of both labels, such as 5..14");
    }

    private static string Number(int number, int width) =>
        number.ToString("D" + width.ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);

    private static InputException Bad(string range, string expected) =>
        MeasurementRefusal.Of(MeasurementError.BadRange, $"the range {MeasurementRefusal.Quote(range)}", expected);
}
