namespace ErrorMatching.Nc;

/// <summary>
/// The longest common subsequence of two sequences by the method of Hunt and Szymanski (Communications of the ACM 20, 1977, 350-353): the pairs of equal items are walked once, and for
/// each length the chain that ends earliest is kept. Time grows with the number of such pairs, not with the product of the lengths.
/// </summary>
internal static class CommonSubsequence
{
    /// <summary>Pairs of positions of equal items, ascending in both.</summary>
    public static List<(int First, int Second)> Of(ReadOnlySpan<object> first, ReadOnlySpan<object> second)
    {
        var start = first.CommonPrefixLength(second);
        var end = 0;
        while (end < Math.Min(first.Length, second.Length) - start && first[^(end + 1)].Equals(second[^(end + 1)]))
        {
            end++;
        }

        var pairs = new List<(int, int)>();
        for (var i = 0; i < start; i++)
        {
            pairs.Add((i, i));
        }

        pairs.AddRange(Inner(first[start..^end], second[start..^end]).Select(p => (p.First + start, p.Second + start)));
        for (var i = end; i > 0; i--)
        {
            pairs.Add((first.Length - i, second.Length - i));
        }

        return pairs;
    }

    private static List<(int First, int Second)> Inner(ReadOnlySpan<object> first, ReadOnlySpan<object> second)
    {
        // Positions in the second sequence, descending, so that one item of the first takes part in a chain once.
        var places = new Dictionary<object, List<int>>();
        for (var j = second.Length - 1; j >= 0; j--)
        {
            if (!places.TryGetValue(second[j], out var list))
            {
                places.Add(second[j], list = []);
            }

            list.Add(j);
        }

        var ends = new List<int>();
        var chains = new List<Link>();
        for (var i = 0; i < first.Length; i++)
        {
            foreach (var j in places.GetValueOrDefault(first[i]) ?? [])
            {
                var length = ends.BinarySearch(j);
                length = length < 0 ? ~length : length;
                var link = new Link(i, j, length > 0 ? chains[length - 1] : null);
                if (length == ends.Count)
                {
                    ends.Add(j);
                    chains.Add(link);
                }
                else
                {
                    (ends[length], chains[length]) = (j, link);
                }
            }
        }

        var pairs = new List<(int, int)>();
        for (var link = chains.Count > 0 ? chains[^1] : null; link is not null; link = link.Before)
        {
            pairs.Add((link.First, link.Second));
        }

        pairs.Reverse();
        return pairs;
    }

    private sealed record Link(int First, int Second, Link? Before);
}
