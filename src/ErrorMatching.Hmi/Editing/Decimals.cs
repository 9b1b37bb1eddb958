using System.Globalization;

namespace ErrorMatching.Hmi;

/// <summary>Aligns typed numbers in a column.</summary>
internal static class Decimals
{
    // A number with more decimals than any gauge measures does not shift the others.
    private const int Most = 6;

    /// <summary>Sets the decimals that each number lacks compared with the longest.</summary>
    public static void Align(IEnumerable<TextField> fields)
    {
        var all = fields.Select(f => (Field: f, Tail: TailOf(f.Text))).ToArray();
        var longest = all.Select(f => f.Tail ?? 0).DefaultIfEmpty().Max();
        foreach (var (field, tail) in all)
        {
            field.Missing = tail is not { } length || length >= longest
                ? ""
                : length > 0
                ? new('0', longest - length)
                : "." + new string('0', longest - 1);
        }
    }

    // Number of characters from the decimal sign; null if the text is not a number.
    private static int? TailOf(string text)
    {
        var number = text.Trim();
        if (!double.TryParse(
            number.Replace(',', '.'), NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out _))
        {
            return null;
        }

        var sign = number.IndexOfAny(['.', ',']);
        return sign < 0 ? 0 : Math.Min(Most + 1, number.Length - sign);
    }
}
