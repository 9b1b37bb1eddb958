using System.Globalization;

namespace ErrorMatching.Hmi;

/// <summary>Short lists of key point labels: a run of consecutive labels is written as its first and last, as in a job.</summary>
internal static class LabelList
{
    // Two labels are just as short without dots.
    private const int LeastRun = 3;
    private const int MostDigits = 9;

    /// <summary>The labels in order, such as <c>4, 6..14</c>.</summary>
    /// <param name="labels">The labels.</param>
    public static string Short(IReadOnlyList<string> labels)
    {
        ArgumentNullException.ThrowIfNull(labels);
        var parts = new List<string>();
        for (var first = 0; first < labels.Count;)
        {
            var next = first + 1;
            while (next < labels.Count && labels[next] == After(labels[next - 1]))
            {
                next++;
            }

            parts.AddRange(next - first >= LeastRun ? [$"{labels[first]}..{labels[next - 1]}"] : labels.Skip(first).Take(next - first));
            first = next;
        }

        return string.Join(", ", parts);
    }

    // The label with the next number, keeping leading zeros; null if the label does not end in a number.
    private static string? After(string label)
    {
        var digits = label.Length - label.AsSpan().TrimEnd("0123456789").Length;
        if (digits is 0 or > MostDigits)
        {
            return null;
        }

        var (prefix, number) = (label[..^digits], label[^digits..]);
        return prefix
            + (int.Parse(number, CultureInfo.InvariantCulture) + 1).ToString(
                number[0] == '0' ? new string('0', digits) : "0", CultureInfo.InvariantCulture);
    }
}
