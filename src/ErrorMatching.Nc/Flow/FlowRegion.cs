namespace ErrorMatching.Nc;

/// <summary>A section that a REPEAT statement repeats.</summary>
/// <param name="owner">The block of the statement; execution continues after it.</param>
/// <param name="first">First block of the section.</param>
/// <param name="last">Its last block, executed too; equal to <paramref name="owner"/> if the section ends at the statement itself.</param>
/// <param name="passes">Remaining passes, including the current one.</param>
internal sealed class FlowRegion(int owner, int first, int last, long passes)
{
    public int Owner { get; } = owner;

    public int First { get; } = first;

    public int Last { get; } = last;

    public long Passes { get; set; } = passes;
}
