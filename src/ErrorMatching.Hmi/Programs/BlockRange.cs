namespace ErrorMatching.Hmi;

/// <summary>Blocks of a program that follow each other.</summary>
/// <param name="First">Position of the first one, from 0.</param>
/// <param name="Last">Position of the last one; not less.</param>
public readonly record struct BlockRange(int First, int Last)
{
    /// <summary>Number of blocks.</summary>
    public int Count => Last - First + 1;

    /// <summary>The blocks between two, in whichever order they are given.</summary>
    public static BlockRange Between(int one, int other) => new(Math.Min(one, other), Math.Max(one, other));

    /// <summary>Ascending blocks as ranges, as few as they can be.</summary>
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

    /// <summary>True if a block is among them.</summary>
    public bool Contains(int block) => block >= First && block <= Last;
}
