namespace ErrorMatching.Nc;

/// <summary>A section that a REPEAT statement executes again.</summary>
/// <param name="owner">The block of the statement; execution goes on behind it.</param>
/// <param name="first">First block of the section.</param>
/// <param name="last">Its last block, executed too; equal to <paramref name="owner"/> where the section ends at the statement
/// itself.</param>
/// <param name="passes">Passes left, the present one included.</param>
internal sealed class FlowRegion(int owner, int first, int last, long passes)
{
    public int Owner { get; } = owner;

    public int First { get; } = first;

    public int Last { get; } = last;

    public long Passes { get; set; } = passes;
}
