namespace ErrorMatching.Freeform;

/// <summary>Divides a count in proportion to shares. Each share gets its whole part; the rest goes to the largest fractions, the first of
/// equal ones.</summary>
internal static class LargestRemainder
{
    /// <summary>Returns the count of each share.</summary>
    /// <param name="count">The count to divide.</param>
    /// <param name="shares">Nonnegative numbers; equal shares if all are zero.</param>
    public static int[] Divide(int count, IReadOnlyList<double> shares)
    {
        var sum = 0.0;
        foreach (var share in shares)
        {
            sum += share;
        }

        var (result, fractions, order) = (new int[shares.Count], new double[shares.Count], new int[shares.Count]);
        var left = count;
        for (var i = 0; i < result.Length; i++)
        {
            var due = count * (sum > 0 ? shares[i] / sum : 1.0 / shares.Count);
            result[i] = (int)due;
            left -= result[i];
            (fractions[i], order[i]) = (Math.Round(due - result[i], 9), i);
        }

        Array.Sort(order, (a, b) => fractions[a] != fractions[b] ? fractions[b].CompareTo(fractions[a]) : a.CompareTo(b));
        for (var k = 0; left > 0; left--, k++)
        {
            result[order[k % order.Length]]++;
        }

        return result;
    }
}
