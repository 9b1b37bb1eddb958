namespace ErrorMatching.Nc;

/// <summary>A longest common subsequence by the greedy method of Myers (Algorithmica 1, 1986, 251-266), applied after removing equal ends
/// and items that only one side has.</summary>
/// <remarks>
/// Time grows with length times number of differences d while d is at most <see cref="MostEdits"/>. With more differences, it grows with
/// length times that bound: the search stops at the pair that it reached furthest and continues from there, so the subsequence is common
/// but may not be the longest. Memory grows with the length and the square of the smaller of d and the bound.
/// </remarks>
internal static class CommonSubsequence
{
    /// <summary>Maximum number of differences for which the subsequence is a longest one.</summary>
    public const int MostEdits = 1024;

    /// <summary>Pairs of positions of equal items, ascending in both.</summary>
    public static List<(int First, int Second)> Of(ReadOnlySpan<int> first, ReadOnlySpan<int> second)
    {
        var start = first.CommonPrefixLength(second);
        var end = 0;
        while (end < Math.Min(first.Length, second.Length) - start && first[^(end + 1)] == second[^(end + 1)])
        {
            end++;
        }

        var pairs = new List<(int, int)>();
        for (var i = 0; i < start; i++)
        {
            pairs.Add((i, i));
        }

        AddInner(first[start..^end], second[start..^end], start, pairs);
        for (var i = end; i > 0; i--)
        {
            pairs.Add((first.Length - i, second.Length - i));
        }

        return pairs;
    }

    private static void AddInner(ReadOnlySpan<int> first, ReadOnlySpan<int> second, int shift, List<(int First, int Second)> pairs)
    {
        // An item without an equal one on the other side is in no common subsequence.
        var (a, b) = (Shared(first, second), Shared(second, first));
        var (x, y) = (0, 0);
        while (x < a.Length && y < b.Length)
        {
            var (path, reachedX, reachedY) = Search(first, a.AsSpan(x), second, b.AsSpan(y));
            foreach (var (i, j) in path)
            {
                pairs.Add((a[x + i] + shift, b[y + j] + shift));
            }

            (x, y) = (x + reachedX, y + reachedY);
        }
    }

    private static int[] Shared(ReadOnlySpan<int> items, ReadOnlySpan<int> others)
    {
        var known = new HashSet<int>();
        foreach (var other in others)
        {
            known.Add(other);
        }

        var shared = new List<int>();
        for (var i = 0; i < items.Length; i++)
        {
            if (known.Contains(items[i]))
            {
                shared.Add(i);
            }
        }

        return [.. shared];
    }

    // The fewest removals and insertions that lead to both ends, or as far as the bound allows.
    private static (List<(int, int)> Path, int X, int Y) Search(
        ReadOnlySpan<int> first, ReadOnlySpan<int> a, ReadOnlySpan<int> second, ReadOnlySpan<int> b)
    {
        var bound = Math.Min(a.Length + b.Length, MostEdits);
        var furthest = new int[(2 * bound) + 3];
        var middle = bound + 1;
        var trace = new List<int[]>();
        for (var d = 0; ; d++)
        {
            for (var k = -d; k <= d; k += 2)
            {
                var x = k == -d || (k != d && furthest[middle + k - 1] < furthest[middle + k + 1])
                    ? furthest[middle + k + 1]
                    : furthest[middle + k - 1] + 1;
                while (x < a.Length && x - k < b.Length && first[a[x]] == second[b[x - k]])
                {
                    x++;
                }

                furthest[middle + k] = x;
                if (x >= a.Length && x - k >= b.Length)
                {
                    return (Back(trace, d, k, x), a.Length, b.Length);
                }
            }

            if (d == bound)
            {
                var best = FurthestInside(furthest, middle, d, a.Length, b.Length);
                return (Back(trace, d, best, furthest[middle + best]), furthest[middle + best], furthest[middle + best] - best);
            }

            trace.Add(furthest[(middle - d)..(middle + d + 1)]);
        }
    }

    private static int FurthestInside(int[] furthest, int middle, int d, int lengthA, int lengthB)
    {
        var (best, reach) = (0, -1);
        for (var k = -d; k <= d; k += 2)
        {
            var (x, y) = (furthest[middle + k], furthest[middle + k] - k);
            if (x <= lengthA && y <= lengthB && x + y > reach)
            {
                (best, reach) = (k, x + y);
            }
        }

        return best;
    }

    private static List<(int, int)> Back(List<int[]> trace, int d, int k, int x)
    {
        var path = new List<(int, int)>();
        for (; ; d--)
        {
            var from = 0;
            var previous = k;
            if (d > 0)
            {
                var before = trace[d - 1];
                var isDown = k == -d || (k != d && At(before, d - 1, k - 1) < At(before, d - 1, k + 1));
                previous = isDown ? k + 1 : k - 1;
                from = At(before, d - 1, previous) + (isDown ? 0 : 1);
            }

            while (x > from)
            {
                x--;
                path.Add((x, x - k));
            }

            if (d == 0)
            {
                path.Reverse();
                return path;
            }

            (x, k) = (At(trace[d - 1], d - 1, previous), previous);
        }
    }

    // Diagonals outside the range of d edits have not been reached.
    private static int At(int[] furthest, int d, int k) => Math.Abs(k) <= d ? furthest[k + d] : 0;
}
