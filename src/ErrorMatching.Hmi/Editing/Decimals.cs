using System.Globalization;

namespace ErrorMatching.Hmi;

/// <summary>Numbers under each other, as they were typed.</summary>
internal static class Decimals
{
    // A number with more of them than anybody measures does not push the others away.
    private const int Most = 6;

    /// <summary>Says of each number what it lacks to as many decimals as another has.</summary>
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

    // Characters from the decimal sign on; null for what is no number.
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
