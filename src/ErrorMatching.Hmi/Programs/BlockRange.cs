namespace ErrorMatching.Hmi;

/// <summary>Consecutive blocks of a program.</summary>
/// <param name="First">Index of the first block, from 0.</param>
/// <param name="Last">Index of the last block; not less.</param>
public readonly record struct BlockRange(int First, int Last)
{
    public int Count => Last - First + 1;

    /// <summary>The range between two blocks, given in either order.</summary>
    public static BlockRange Between(int one, int other) => new(Math.Min(one, other), Math.Max(one, other));

    /// <summary>Converts ascending blocks to as few ranges as possible.</summary>
    public static IReadOnlyList<BlockRange> Of(IReadOnlyList<int> blocks)
    {
        var ranges = new List<BlockRange>();
        foreach (var block in blocks)
        {
            if (ranges.Count > 0 && ranges[^1].Last + 1 == block)
            {
                ranges[^1] = ranges[^1] with { Last = block };
            }
            else
            {
                ranges.Add(new(block, block));
            }
        }

        return ranges;
    }

    public bool Contains(int block) => block >= First && block <= Last;
}
