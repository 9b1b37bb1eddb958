namespace ErrorMatching.Nc;

/// <summary>What a program does: its motions in order, and what stands in the way of trusting them.</summary>
public sealed class NcPath
{
    private readonly NcMotion[] _motions;
    private readonly int _count;

    internal NcPath(NcProgram program, NcDialect dialect, NcMotion[] motions, int count, IReadOnlyList<NcProblem> problems, IReadOnlyList<int> placeDependents, int flowBlock)
    {
        Program = program;
        Dialect = dialect;
        _motions = motions;
        _count = count;
        Problems = problems;
        PlaceDependents = placeDependents;
        FlowBlock = flowBlock;
    }

    /// <summary>The program that was interpreted.</summary>
    public NcProgram Program { get; }

    /// <summary>The dialect it was read in.</summary>
    public NcDialect Dialect { get; }

    /// <summary>All motions, in the order of their blocks.</summary>
    public ReadOnlySpan<NcMotion> Motions => _motions.AsSpan(0, _count);

    /// <summary>Unknown words, arcs that do not close, unterminated comments and the like, in the order of the blocks.</summary>
    public IReadOnlyList<NcProblem> Problems { get; }

    /// <summary>The first block that branches, loops or defines a subprogram; -1 where the program runs straight through. Behind it blocks may run several times or not at all.</summary>
    public int FlowBlock { get; }

    /// <summary>Blocks whose effect can depend on where the tool stands although they move nothing themselves: program calls, and what sets an origin.</summary>
    internal IReadOnlyList<int> PlaceDependents { get; }

    /// <summary>Position of the first motion of a block or a later one: <see cref="Motions"/> is sorted by block.</summary>
    public int FirstMotionFrom(int block)
    {
        var (low, high) = (0, _count);
        while (low < high)
        {
            var middle = (low + high) / 2;
            if (_motions[middle].Block < block)
            {
                low = middle + 1;
            }
            else
            {
                high = middle;
            }
        }

        return low;
    }

    /// <summary>Position of a block's motion, or -1 where it has none.</summary>
    public int MotionOf(int block)
    {
        var at = FirstMotionFrom(block);
        return at < _count && _motions[at].Block == block ? at : -1;
    }
}
