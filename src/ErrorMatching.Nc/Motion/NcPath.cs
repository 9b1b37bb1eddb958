using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>The result of interpreting a program: its motions in order, and reasons not to trust them.</summary>
public sealed class NcPath
{
    /// <summary>Distance up to which a motion is searched near the last one, before all are searched.</summary>
    private const int Far = 64;

    private int[]? _byBlock;
    private int _recent;

    internal NcPath(
        NcProgram program,
        NcDialect dialect,
        NcMotions motions,
        IReadOnlyList<NcProblem> problems,
        IReadOnlyList<(int Block, int Joint)> placeDependents,
        IReadOnlyList<NcFrame> frames,
        IReadOnlyList<NcNote> notes,
        Refusal? refusal,
        Func<string, NcProgram?>? library)
    {
        Program = program;
        Dialect = dialect;
        Motions = motions;
        Frames = frames;
        Problems = problems;
        PlaceDependents = placeDependents;
        Notes = notes;
        Refusal = refusal;
        Library = library;
    }

    /// <summary>The program that was interpreted.</summary>
    public NcProgram Program { get; }

    /// <summary>The dialect in which it was read.</summary>
    public NcDialect Dialect { get; }

    /// <summary>All motions, in execution order.</summary>
    public NcMotions Motions { get; }

    /// <summary>The layers of offsets and transformations, in execution order; <see cref="NcMotion.Frame"/> is an index into
    /// them.</summary>
    public IReadOnlyList<NcFrame> Frames { get; }

    /// <summary>Unknown words, arcs that do not close, unterminated comments and the like, in block order.</summary>
    public IReadOnlyList<NcProblem> Problems { get; }

    /// <summary>Readings that another machine could make differently. Every result of the program shows them.</summary>
    public IReadOnlyList<NcNote> Notes { get; }

    /// <summary>Blocks that move on only one of the ways of a branch on a value that only the machine knows: they must not change.
    /// Ascending.</summary>
    public IReadOnlyCollection<int> UncertainBlocks { get; init; } = [];

    /// <summary>The reason why the program could not be followed to its end: a missing program, an infinite loop, a branch on a value
    /// that only the machine knows. Null if it was followed to its end.</summary>
    public Refusal? Refusal { get; }

    /// <summary>The programs of other files that it called, in order of their first call.</summary>
    public IReadOnlyList<CalledProgram> CalledPrograms { get; init; } = [];

    /// <summary>Values that somebody stated for variables that only the machine knows, as far as the program reads them: text such as
    /// <c>#100 = 1</c>.</summary>
    public string Assumed { get; init; } = "";

    /// <summary>SHA-256 of the program, as 64 lower-case hexadecimal digits; if it called programs of other files, or read values that
    /// were assumed, of the list of their names and hashes, and of those values, behind its own.</summary>
    public string Sha256
    {
        get
        {
            var own = ContentHash.Sha256(Program.Bytes.Span);
            return CalledPrograms.Count == 0 && Assumed.Length == 0
                ? own
                : ContentHash.Sha256OfText(string.Join('\n',
                    [own, .. CalledPrograms.Select(c => $"{c.Name} {c.Sha256}"), .. Assumed.Length == 0 ? [] : (string[])[Assumed]]));
        }
    }

    /// <summary>The state in which the run reached some of the program's blocks.</summary>
    internal IReadOnlyList<RunBorder> Borders { get; init; } = [];

    /// <summary>Returns called programs that are not in the file.</summary>
    internal Func<string, NcProgram?>? Library { get; }

    /// <summary>Blocks that move nothing themselves but whose effect can depend on the tool's place (they set an origin or call an
    /// unknown program), each with the joint of the path at which the tool is.</summary>
    internal IReadOnlyList<(int Block, int Joint)> PlaceDependents { get; }

    /// <summary>Joints of the path with a tool change (M6), ascending.</summary>
    internal IReadOnlyList<int> ToolChanges { get; init; } = [];

    /// <summary>Blocks that state a pole (CC), each with the number of motions before it, ascending.</summary>
    internal IReadOnlyList<(int Motions, int Block)> Poles { get; init; } = [];

    /// <summary>Blocks that lead to a contour or away from it by a way that is not followed (APPR CT, DEP LCT), each once: whether the
    /// tool cuts into the piece on it, nobody knows here.</summary>
    public IReadOnlyList<int> UnfollowedWays =>
        [.. CompensationSwitches.Where(s => s.Meaning is NcMeaning.Approach or NcMeaning.Departure).Select(s => s.Block).Distinct()];

    /// <summary>True for an approach or a departure: the control computes its way from the contour, so it follows where the contour moves
    /// (APPR, DEP).</summary>
    internal bool IsLead(in NcMotion motion) => Dialect.BlocksNameMotions && motion.Kind == MotionKind.Spline;

    /// <summary>True for a rounding or chamfer that the control inserts behind a motion of the same block.</summary>
    internal bool IsInsertedCorner(int motion) => motion > 0 && motion < Motions.Length && Motions[motion].Has(MotionFlags.CornerWord)
        && Motions.BlockOf(motion) == Motions.BlockOf(motion - 1);

    /// <summary>The block that states the pole of a motion; -1 if none does.</summary>
    internal int PoleOf(int motion)
    {
        var (low, high) = (0, Poles.Count);
        while (low < high)
        {
            var middle = (low + high) / 2;
            (low, high) = Poles[middle].Motions <= motion ? (middle + 1, high) : (low, middle);
        }

        return low == 0 ? -1 : Poles[low - 1].Block;
    }

    /// <summary>Words that concern cutter compensation, in execution order.</summary>
    internal IReadOnlyList<CompensationSwitch> CompensationSwitches { get; init; } = [];

    /// <summary>Number of tool changes (M6, TOOL CALL) before a motion: motions with the same number are made with one tool, unless a T
    /// word alone or a macro changes it.</summary>
    /// <param name="motion">Position of the motion.</param>
    public int ToolChangesBefore(int motion) => ToolChangesBelow(motion + 1);

    /// <summary>True if the tool was changed at one of the joints.</summary>
    internal bool ChangesTool(int firstJoint, int lastJoint)
    {
        var first = ToolChangesBelow(firstJoint);
        return first < ToolChanges.Count && ToolChanges[first] <= lastJoint;
    }

    private int ToolChangesBelow(int joint)
    {
        var (low, high) = (0, ToolChanges.Count);
        while (low < high)
        {
            var middle = (low + high) / 2;
            (low, high) = ToolChanges[middle] < joint ? (middle + 1, high) : (low, middle);
        }

        return low;
    }

    /// <summary>All motions of a block, in execution order: several if it runs several times or is a canned cycle.</summary>
    public ReadOnlySpan<int> MotionsOf(int block)
    {
        if (Motions.FollowBlocks)
        {
            var first = FirstFrom(null, block, ref _recent);
            var end = first;
            while (end < Motions.Length && Motions.BlockOf(end) == block)
            {
                end++;
            }

            var motions = new int[end - first];
            for (var i = 0; i < motions.Length; i++)
            {
                motions[i] = first + i;
            }

            return motions;
        }

        var order = _byBlock ??= OrderByBlock();
        var from = FirstFrom(order, block, ref _recent);
        var to = from;
        while (to < order.Length && Motions.BlockOf(order[to]) == block)
        {
            to++;
        }

        return order.AsSpan(from, to - from);
    }

    /// <summary>Position of a block's first motion; -1 if it has none.</summary>
    public int MotionOf(int block) => RunOf(block, 0);

    /// <summary>The n-th motion of a block; -1 after the last.</summary>
    internal int RunOf(int block, int run) => RunOf(block, run, ref _recent);

    /// <summary>The same for concurrent callers, each with its own cached position.</summary>
    /// <param name="block">The block.</param>
    /// <param name="run">Which of its motions, from 0.</param>
    /// <param name="recent">Position where the caller found the last one; 0 at first.</param>
    internal int RunOf(int block, int run, ref int recent)
    {
        var order = Motions.FollowBlocks ? null : _byBlock ??= OrderByBlock();
        var place = FirstFrom(order, block, ref recent) + run;
        return place < Motions.Length && BlockAt(order, place) == block ? order is null ? place : order[place] : -1;
    }

    private int[] OrderByBlock()
    {
        var blocks = new int[Motions.Length];
        var order = new int[Motions.Length];
        for (var i = 0; i < order.Length; i++)
        {
            (blocks[i], order[i]) = (Motions.BlockOf(i), i);
        }

        // Motions of one block stay in order: the index decides between equal blocks.
        Array.Sort(order, (a, b) => blocks[a] != blocks[b] ? blocks[a].CompareTo(blocks[b]) : a.CompareTo(b));
        return order;
    }

    // The first motion of a block or of a later one, in block order (null: the path's own). It is mostly near the last one found.
    private int FirstFrom(int[]? order, int block, ref int recent)
    {
        var (low, high) = (0, Motions.Length);
        var hint = recent;
        if (hint < high && BlockAt(order, hint) >= block && (hint == 0 || BlockAt(order, hint - 1) < block))
        {
            return hint;
        }

        for (var reach = 1; hint < high && reach <= Far; reach *= 2)
        {
            if (BlockAt(order, hint) < block)
            {
                low = hint + 1;
                hint += reach;
            }
            else
            {
                high = hint;
            }
        }

        while (low < high)
        {
            var middle = (int)(((uint)low + (uint)high) / 2);
            if (BlockAt(order, middle) < block)
            {
                low = middle + 1;
            }
            else
            {
                high = middle;
            }
        }

        recent = low;
        return low;
    }

    private int BlockAt(int[]? order, int place) => Motions.BlockOf(order is null ? place : order[place]);
}

/// <summary>Something in a program that the interpreter did not understand or considers wrong. The program stays unchanged.</summary>
/// <param name="Code">A stable identifier.</param>
/// <param name="Block">Position of the block, from 0.</param>
/// <param name="Message">What was found.</param>
public sealed record NcProblem(string Code, int Block, string Message);

/// <summary>A note on how a program was read: something that another machine could read differently, or control behavior that is not
/// followed. The program itself is not wrong.</summary>
/// <param name="Code">A stable identifier.</param>
/// <param name="Block">Position of the first block concerned, from 0.</param>
/// <param name="Count">Number of occurrences while the program ran.</param>
/// <param name="Message">What was found and how it was read, in a sentence.</param>
public sealed record NcNote(string Code, int Block, long Count, string Message);

/// <summary>A program that the interpreted one calls and that is in another file.</summary>
/// <param name="Name">The name by which it is called: <c>O1002</c>, <c>POCKET</c>.</param>
/// <param name="Sha256">SHA-256 of its bytes as 64 lower-case hexadecimal digits.</param>
public sealed record CalledProgram(string Name, string Sha256);
