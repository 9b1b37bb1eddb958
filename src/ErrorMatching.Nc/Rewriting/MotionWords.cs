using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Changes the words of one motion's block at a time. Adds rounded displacements to the exact decimals of the original, so a chain
/// of increments keeps its sum, however long.</summary>
/// <param name="change">New joints and centers.</param>
/// <param name="grid">The numbers that words can express.</param>
/// <param name="edit">Edits the blocks.</param>
internal sealed class MotionWords(PathChange change, IncrementGrid grid, BlockEdit edit)
{
    /// <summary>Places closer than this are the same, mm.</summary>
    private const double SamePlace = 1e-9;

    private readonly NcPath _path = change.Path;
    private readonly CircleWords _circles = new(change, grid, edit);

    /// <summary>Patches of the opened block.</summary>
    public List<NcPatch> Patches => edit.Patches;

    /// <summary>Spelling of all opened blocks.</summary>
    public (int Decimals, bool IsFixed) Spelling => edit.Spelling;

    /// <summary>The same for other blocks, on another thread.</summary>
    public MotionWords ForOthers() => new(change, grid, new(edit));

    /// <summary>Adds the spelling of the blocks that others have opened.</summary>
    public void Join(MotionWords other)
    {
        edit.Join(other.Edited);
        _circles.Poles.Join(other._circles.Poles);
    }

    /// <summary>Changes the words of centers that blocks of their own state. Call it when all motions are edited.</summary>
    /// <returns>The reason why they cannot change, or null.</returns>
    public Refusal? EditPoles(BlockPatches patches) => _path.Poles.Count == 0 ? null : _circles.Poles.Edit(edit, patches);

    private BlockEdit Edited => edit;

    /// <summary>Opens the block of a motion and changes its words.</summary>
    /// <returns>The reason why they cannot change, or null.</returns>
    /// <remarks>Exact decimals end at 18 digits. If a program's own number leaves no room, the edit is refused.</remarks>
    public Refusal? Edit(int index)
    {
        try
        {
            return EditWords(index);
        }
        catch (InputException e) when (e.Code == NcRefusalCodes.NumberTooLong)
        {
            return BlockRefusal.At(_path.Program, _path.Motions[index].Block, NcRefusalCodes.NumberTooLong, e.Message);
        }
    }

    private Refusal? EditWords(int index)
    {
        var motion = _path.Motions[index];
        edit.Open(_path.Program[motion.Block]);
        if (motion.Has(MotionFlags.MachineMove))
        {
            // It ends at a machine position regardless of its start, or in other axes where it begins.
            var known = ~motion.UnknownEnd;
            var carried = Positioning.Only(known & motion.CarriedAxes, change.MoveOf(index));
            return Positioning.Only(known, change.MoveOf(index + 1)) == carried ? null : Obstacles.Of(_path, motion);
        }

        if (SetCoordinates(index, motion) is { } unknown)
        {
            return unknown;
        }

        if (motion is { IsCut: true, IsArc: false, MovesInPlane: true } && TurnsRound(index, motion))
        {
            return BlockRefusal.At(
                _path.Program, motion.Block, NcRefusalCodes.ElementFlips,
                "displaced as asked and rounded to what its words can say, it would turn round or vanish: it is hardly longer than that. "
                    + "Leave it out of the program, or displace less.");
        }

        if (motion.IsArc && _circles.Set(index, motion) is { } refusal)
        {
            return refusal;
        }

        if (edit.Patches.Count == 0)
        {
            return null;
        }

        if (Obstacles.Of(_path, motion) is { } obstacle)
        {
            return obstacle;
        }

        return motion.Has(MotionFlags.Inch) != grid.IsInch
            ? BlockRefusal.At(
                _path.Program,
                motion.Block,
                NcRefusalCodes.UnknownState,
                "the unit changes (G20/G21) between blocks that must change together.")
            : null;
    }

    // An element that keeps its sense can still lose it by rounding. One that shrank to a corner has both ends there.
    private bool TurnsRound(int index, in NcMotion motion)
    {
        var was = motion.PlaneEnd - motion.PlaneStart;
        var exact = was + change.PlaneMoveOf(index + 1, motion.Plane) - change.PlaneMoveOf(index, motion.Plane);
        return exact.Dot(was) > 1e-9 * was.Length && (grid.Rounded(motion.End, index + 1, motion.Plane)
            - grid.Rounded(motion.Start, index, motion.Plane)).Dot(was) <= 1e-9 * was.Length;
    }

    private Refusal? SetCoordinates(int index, in NcMotion motion)
    {
        if (motion.IsToAngle)
        {
            // Its angle follows when its center is known.
            var (start, end) = (default(Point3) + change.MoveOf(index), default(Point3) + change.MoveOf(index + 1));
            return motion.Plane.Height(start) == motion.Plane.Height(end) ? null : Obstacles.UnknownPlace(_path, index);
        }

        foreach (var axis in "XYZ"u8)
        {
            var (from, to) = (grid.Steps(index, axis), grid.Steps(index + 1, axis));
            var incremental = edit.Distance(axis) switch
            {
                WordDistance.Absolute => false,
                WordDistance.Incremental => true,
                _ => motion.Has(MotionFlags.Incremental)
            };
            var steps = incremental ? to - from : to;
            if (steps != 0 && incremental && motion.Has(MotionFlags.StartsElsewhere) && (motion.UnknownStart & Axis(axis)) != AxisSet.None)
            {
                // Something unknown is between the moved place and this increment.
                return Obstacles.UnknownPlace(_path, index);
            }

            if (edit.Number(axis) is { } number)
            {
                if (steps != 0)
                {
                    edit.Set(axis, number + grid.Number(steps));
                }
            }
            else if (edit.Computed(axis) is { } distance)
            {
                var by = distance == WordDistance.Incremental || (distance == WordDistance.Modal && motion.Has(MotionFlags.Incremental))
                    ? to - from
                    : to;
                if (by != 0 && !edit.Add(axis, grid.Number(by)))
                {
                    return Obstacles.Computed(_path, motion);
                }
            }
            else if (from != to && !(_path.IsLead(motion) && (motion.UnknownEnd & Axis(axis)) != AxisSet.None))
            {
                if (!incremental && (motion.UnknownEnd & Axis(axis)) != AxisSet.None)
                {
                    return Obstacles.UnknownPlace(_path, index);
                }

                var end = motion.End + (_path.Frames[motion.Frame].ProgramShift * -1);
                var original = incremental
                    ? new NcNumber(0, 0)
                    : NcNumber.Round(IncrementGrid.Coordinate(end, axis) / grid.Unit, 6).Trim();
                if (!incremental && Math.Abs((original.Value * grid.Unit) - IncrementGrid.Coordinate(end, axis)) > SamePlace)
                {
                    return BlockRefusal.At(
                        _path.Program, motion.Block, NcRefusalCodes.NumberTooLong,
                        "it needs a coordinate word now, and its place has more digits than such a word can say. Post it "
                            + "with all of its coordinates.");
                }

                edit.Set(axis, original + grid.Number(steps));
            }
        }

        return null;
    }

    private static AxisSet Axis(byte letter) => letter switch { (byte)'X' => AxisSet.X, (byte)'Y' => AxisSet.Y, _ => AxisSet.Z };
}
