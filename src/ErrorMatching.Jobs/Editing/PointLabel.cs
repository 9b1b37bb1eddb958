using System.Globalization;

namespace ErrorMatching.Jobs;

/// <summary>Numeric point labels.</summary>
internal static class PointLabel
{
    /// <summary>The label of a number.</summary>
    public static string Of(int number) => number.ToString(CultureInfo.InvariantCulture);

    /// <summary>The number at the start of a label; 0 if there is none.</summary>
    public static int NumberOf(string label)
    {
        var digits = label.AsSpan(0, label.AsSpan().IndexOfAnyExceptInRange('0', '9') is var end and >= 0 ? end : label.Length);
        return int.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out var number) && number < int.MaxValue / 2
            ? number
            : 0;
    }
}
