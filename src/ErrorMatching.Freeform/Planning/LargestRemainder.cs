namespace ErrorMatching.Freeform;

/// <summary>Divides whole things in proportion to shares: each gets the whole part of what is due to it, and what is left goes to the largest fractions, the first of equal ones.</summary>
internal static class LargestRemainder
{
    /// <summary>How many each share gets.</summary>
    /// <param name="count">How many there are.</param>
    /// <param name="shares">Numbers that are not negative; all alike if they are all zero.</param>
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
