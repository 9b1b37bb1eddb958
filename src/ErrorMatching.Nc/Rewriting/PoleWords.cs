using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>The words of centers that blocks of their own state for the arcs behind them (CC). All arcs about one center must accept the
/// same new words, because the block can change only once.</summary>
/// <param name="change">New joints and centers.</param>
/// <param name="grid">The numbers that words can express.</param>
internal sealed class PoleWords(PathChange change, IncrementGrid grid)
{
    /// <summary>Places closer than this are the same, mm.</summary>
    private const double SamePlace = 1e-9;

    private readonly NcPath _path = change.Path;
    private readonly Dictionary<int, WantedPole> _wanted = [];
    private readonly PolarEndWords _ends = new(change.Path, grid);

    /// <summary>Stores what an arc wants of its center.</summary>
    public void Want(int motion, WantedPole wanted) => _wanted[motion] = wanted;

    /// <summary>Adds what other arcs want, from another thread.</summary>
    public void Join(PoleWords other)
    {
        foreach (var (motion, wanted) in other._wanted)
        {
            _wanted[motion] = wanted;
        }
    }

    /// <summary>Changes the words of the centers. Call it when all arcs have said what they want.</summary>
    /// <param name="edit">Edits the blocks.</param>
    /// <param name="patches">Receives the patches.</param>
    /// <returns>The reason why a center cannot change, or null.</returns>
    public Refusal? Edit(BlockEdit edit, BlockPatches patches)
    {
        var edited = new SortedDictionary<int, NcPatch[]>();
        for (var i = 0; i < _path.Poles.Count; i++)
        {
            var (first, block) = _path.Poles[i];
            var end = i + 1 < _path.Poles.Count ? _path.Poles[i + 1].Motions : _path.Motions.Length;
            if (first == end)
            {
                continue;
            }

            var arcs = Enumerable.Range(first, end - first).Where(m => _path.Motions[m].Has(MotionFlags.CenterBefore)).ToList();
            if (!change.IsSet(first) && !arcs.Exists(_wanted.ContainsKey))
            {
                if (edited.GetValueOrDefault(block) is { Length: > 0 })
                {
                    return Refuse(block, NcRefusalCodes.RunsDiffer, "it runs several times, and would have to change differently.");
                }

                continue;
            }

            var refusal = Edit(edit, arcs, first, block, end, out var move)
                ?? Keep(edited, block, [.. edit.Patches])
                ?? EditEnds(arcs, move, edited);
            if (refusal is not null)
            {
                return refusal;
            }
        }

        foreach (var (block, texts) in edited)
        {
            patches.Insert(block, texts);
        }

        return null;
    }

    private Refusal? Keep(SortedDictionary<int, NcPatch[]> edited, int block, NcPatch[] patches)
    {
        if (edited.TryGetValue(block, out var known) && !RepeatedBlocks.Same(known, patches))
        {
            return Refuse(block, NcRefusalCodes.RunsDiffer, "it runs several times, and would have to change differently.");
        }

        edited[block] = patches;
        return null;
    }

    private Refusal? EditEnds(List<int> arcs, (long First, long Second) move, SortedDictionary<int, NcPatch[]> edited)
    {
        foreach (var arc in arcs)
        {
            var motion = _path.Motions[arc];
            if (!motion.IsToAngle || !_wanted.ContainsKey(arc))
            {
                continue;
            }

            var center = motion.Center + new Vector2(move.First * grid.Increment, move.Second * grid.Increment);
            var patch = _ends.Patch(arc, center, out var isPossible, out var end);
            var isExact = end.DistanceTo(grid.Rounded(motion.End, arc + 1, motion.Plane)) <= SamePlace;
            var refusal = !isPossible
                ? Refuse(motion.Block, NcRefusalCodes.Expression, "its angle is computed by the control. Post a plain number for it.")
                : !isExact && change.MoveOf(arc + 1) == Vector3.Zero
                ? Refuse(
                    motion.Block, NcRefusalCodes.ArcForm,
                    "its end is an angle about its center and cannot stay exactly where it is while its start moves. Name it and the block "
                        + "behind it as well, or post it with its coordinates.")
                : !isExact && arc + 1 < _path.Motions.Length && !StatesPlace(arc + 1)
                ? Refuse(
                    motion.Block, NcRefusalCodes.ArcForm,
                    "its end is an angle about its center, and what is behind it counts from that end, which is not met exactly. State "
                        + "both coordinates of the plane in the block behind it, or post the arc with its coordinates.")
                : Keep(edited, motion.Block, patch is { } text ? [text] : []);
            if (refusal is not null)
            {
                return refusal;
            }
        }

        return null;
    }

    private Refusal? Edit(
        BlockEdit edit, List<int> arcs, int first, int block, int end, out (long First, long Second) moved)
    {
        moved = (0, 0);
        edit.Open(_path.Program[block]);
        if (arcs.Count == 0 && !Enumerable.Range(first, end - first).Any(IsPolar))
        {
            return null;
        }

        if (arcs.Count == 0 || CommonMove(arcs) is not { } move)
        {
            return Refuse(
                block,
                NcRefusalCodes.ArcForm,
                "it is the center of several arcs or polar ends, and they would need different ones. State the center again before each of "
                    + "them.");
        }

        if (move != (0, 0) && Enumerable.Range(first, end - first).Any(IsPolar))
        {
            return Refuse(
                block, NcRefusalCodes.ArcForm,
                "polar ends count from this center, and they would move along. Post them with their coordinates.");
        }

        moved = move;
        var (u, v) = _path.Motions[arcs[0]].Plane switch
        {
            CoordinatePlane.ZX => ((byte)'Z', (byte)'X'),
            CoordinatePlane.YZ => ((byte)'Y', (byte)'Z'),
            _ => ((byte)'X', (byte)'Y'),
        };
        return Set(edit, block, first, u, move.First) ?? Set(edit, block, first, v, move.Second);
    }

    // A coordinate that is an increment, or none at all, follows the place of the tool.
    private Refusal? Set(BlockEdit edit, int block, int joint, byte axis, long steps)
    {
        if (edit.Number(axis) is { } number)
        {
            steps -= edit.Distance(axis) == WordDistance.Incremental ? grid.Steps(joint, axis) : 0;
            if (steps != 0)
            {
                edit.Set(axis, number + grid.Number(steps));
            }

            return null;
        }

        steps -= edit.Computed(axis) is null or WordDistance.Incremental ? grid.Steps(joint, axis) : 0;
        return steps == 0
            ? null
            : edit.Computed(axis) is null
            ? Refuse(
                block, NcRefusalCodes.ArcForm,
                "the center is the place of the tool, and must not move as that does. State its coordinates.")
            : Refuse(block, NcRefusalCodes.Expression, "the center is computed by the control. Post plain numbers for it.");
    }

    // The move of the center in increments that all its arcs accept; null if there is none.
    private (long First, long Second)? CommonMove(List<int> arcs)
    {
        foreach (var candidate in arcs.Select(a => WantedOf(a).Move).Distinct())
        {
            if (arcs.TrueForAll(a => WantedOf(a).Accepts(candidate, _path.Motions[a].Center, grid.Increment)))
            {
                return candidate;
            }
        }

        return null;
    }

    private WantedPole WantedOf(int motion) => _wanted.GetValueOrDefault(motion, new((0, 0), null));

    // A motion that ends where its own words say, wherever it begins.
    private bool StatesPlace(int motion)
    {
        var stated = AxisSet.None;
        foreach (ref readonly var token in _path.Program.Tokens(_path.Program[_path.Motions.BlockOf(motion)]))
        {
            stated |= token is { Kind: NcTokenKind.Word, Letter: >= (byte)'X' and <= (byte)'Z', Distance: not WordDistance.Incremental }
                ? (AxisSet)(1 << (token.Letter - 'X'))
                : AxisSet.None;
        }

        var plane = _path.Motions[motion].Plane.Axes();
        return (stated & plane) == plane && !_path.Motions[motion].Has(MotionFlags.Incremental);
    }

    // The end of an arc to an angle is its own affair, and that of an arc that moves as a whole goes along.
    private bool IsPolar(int motion)
    {
        if (_path.Motions[motion].IsToAngle || (_wanted.TryGetValue(motion, out var wanted) && wanted.Free is null))
        {
            return false;
        }

        foreach (ref readonly var token in _path.Program.Tokens(_path.Program[_path.Motions.BlockOf(motion)]))
        {
            if (token.Kind == NcTokenKind.PolarWord)
            {
                return true;
            }
        }

        return false;
    }

    private Refusal Refuse(int block, string code, string why) => BlockRefusal.At(_path.Program, block, code, why);
}

/// <summary>What an arc wants of the center that another block states.</summary>
/// <param name="Move">The center's best move, in increments.</param>
/// <param name="Free">The arc, if other moves may fit it too; null if only this one does.</param>
internal readonly record struct WantedPole((long First, long Second) Move, (Point2 Start, Point2 End, Point2 Center)? Free)
{
    /// <summary>True if a move of the center fits the arc: the radii agree, and the center is next to the exact one.</summary>
    public bool Accepts((long First, long Second) move, Point2 center, double increment)
    {
        if (move == Move || Free is not { } arc)
        {
            return move == Move;
        }

        var moved = center + new Vector2(move.First * increment, move.Second * increment);
        return moved.DistanceTo(arc.Center) <= 1.5 * increment
            && ArcCenter.Mismatch(arc.Start, arc.End, moved) <= CenterGrid.WantedMismatchMm;
    }
}
