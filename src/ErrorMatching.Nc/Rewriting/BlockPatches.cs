namespace ErrorMatching.Nc;

/// <summary>The patches of changed blocks, in program order.</summary>
/// <param name="blocks">Number of blocks for which to reserve memory: most change two words.</param>
internal sealed class BlockPatches(int blocks)
{
    /// <summary>The patches.</summary>
    public List<NcPatch> All { get; } = new(2 * blocks);

    /// <summary>The changed blocks.</summary>
    public List<int> Blocks { get; } = new(blocks);

    /// <summary>Adds the patches of the next block; without patches, it is not changed.</summary>
    public void Add(int block, IReadOnlyCollection<NcPatch> patches)
    {
        if (patches.Count > 0)
        {
            All.AddRange(patches);
            Blocks.Add(block);
        }
    }

    /// <summary>Adds the patches of a block anywhere in the program.</summary>
    public void Insert(int block, IReadOnlyCollection<NcPatch> patches)
    {
        if (patches.Count > 0)
        {
            All.AddRange(patches);
            All.Sort((a, b) => a.Start.CompareTo(b.Start));
            Blocks.Insert(~Blocks.BinarySearch(block), block);
        }
    }

    /// <summary>Adds the patches of all later blocks.</summary>
    public void Join(BlockPatches later)
    {
        All.AddRange(later.All);
        Blocks.AddRange(later.Blocks);
    }
}
