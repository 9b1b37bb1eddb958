namespace ErrorMatching.Freeform;

/// <summary>Divides whole things in proportion to shares: each gets the whole part of what is due to it, and what is left goes to the largest fractions, the first of equal ones.</summary>
internal static class LargestRemainder
{
    /// <summary>How many each share gets.</summary>
    /// <param name="count">How many there are.</param>
    /// <param name="shares">Numbers that are not negative; all alike if they are all zero.</param>
    public static int[] Divide(int count, IReadOnlyList<double> shares)
    {
        var sum = shares.Sum();
        var due = shares.Select(s => count * (sum > 0 ? s / sum : 1.0 / shares.Count)).ToArray();
        var result = due.Select(d => (int)d).ToArray();
        var order = Enumerable.Range(0, due.Length).OrderByDescending(i => Math.Round(due[i] - result[i], 9)).ThenBy(i => i).ToArray();
        for (var (left, k) = (count - result.Sum(), 0); left > 0; left--, k++)
        {
            result[order[k % order.Length]]++;
        }

        return result;
    }
}
