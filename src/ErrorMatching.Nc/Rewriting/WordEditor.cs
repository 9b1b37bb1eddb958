using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Turns new joints and centers into the fewest changed words. Rounds displacements to the least increment once per joint and
/// adds them to the exact decimals of the original, so a chain of increments keeps its sum, however long.</summary>
internal sealed partial class WordEditor
{
    /// <summary>Minimum number of blocks for a second thread to pay off.</summary>
    private const int Many = 10_000;

    /// <summary>Number of blocks that are sampled for the spelling of all.</summary>
    private const int First = 100;

    private readonly PathChange _change;
    private readonly NcPath _path;
    private readonly bool _keepRadii;
    private readonly List<NcPatch> _patches;
    private readonly List<int> _changedBlocks;
    private readonly BlockEdit _edit;
    private readonly bool _inch;
    private readonly int _decimals;
    private readonly bool _programIsFixed;
    private readonly double _increment;

    private WordEditor(PathChange change, bool keepRadii, List<int> affected, int spelledLike)
    {
        _change = change;
        _keepRadii = keepRadii;
        _path = change.Path;

        // Most motions change two words. Reserve room for both halves now, so that the list is not copied later.
        (_patches, _changedBlocks) = (new(2 * affected.Count), new(affected.Count));

        // The control's least increment, or a finer one if the program itself is finer.
        var dialect = _path.Dialect;
        _inch = _path.Motions[affected.Find(i => change.IsSet(i + 1))].Has(MotionFlags.Inch);
        var least = _inch ? dialect.InchDecimals : dialect.MetricDecimals;
        (_decimals, _programIsFixed) = Spelling(affected, spelledLike, least);
        _increment = Math.Pow(10, -_decimals) * Unit;
        _edit = new(_path.Program, _programIsFixed, dialect.IntegersAreIncrements ? least : -1);
    }

    // An editor for other blocks of the same change.
    private WordEditor(WordEditor other)
    {
        (_change, _keepRadii, _path, _inch, _decimals, _programIsFixed, _increment) = (
            other._change, other._keepRadii, other._path, other._inch, other._decimals, other._programIsFixed, other._increment);
        (_patches, _changedBlocks, _edit) = (new(other._patches.Capacity / 2), new(other._changedBlocks.Capacity / 2), new(other._edit));
    }

    private double Unit => _inch ? 25.4 : 1;

    /// <summary>Rewrites the words of a change.</summary>
    /// <param name="change">New joints and centers.</param>
    /// <param name="keepRadii">True to keep a radius word while it nearly fits.</param>
    public static Outcome<Rewrite> Run(PathChange change, bool keepRadii)
    {
        var affected = change.Affected();
        if (affected.Count == 0)
        {
            return Rewrite.None(change.Path);
        }

        // Many blocks are mostly spelled like the first of them. Then there is no need to read them all beforehand.
        return affected.Count >= Many
            && new WordEditor(change, keepRadii, affected, spelledLike: First).RunIfSpelledAlike(affected) is { } rewrite
            ? rewrite
            : new WordEditor(change, keepRadii, affected, affected.Count).Run(affected);
    }

    // Null if a block does not match the sampled style or cannot be edited.
    private Rewrite? RunIfSpelledAlike(List<int> affected)
    {
        if (!_path.Motions.FollowBlocks || RunAgain(affected) || EditMany(affected) is not null)
        {
            return null;
        }

        var (decimals, isFixed) = _edit.Spelling;
        return decimals <= _decimals && isFixed == _programIsFixed ? Result() : null;
    }

    private Outcome<Rewrite> Run(List<int> affected)
    {
        if ((
            !_path.Motions.FollowBlocks || RunAgain(affected)
                ? EditRepeated(affected)
                : affected.Count < Many
                ? EditOnce(affected)
                : EditMany(affected)) is { } refusal)
        {
            return refusal;
        }

        return Result();
    }

    private Rewrite Result()
    {
        var program = _patches.Count == 0
            ? _path.Program
            : NcProgram.Read(NcPatch.ApplyInHalves(_path.Program.Bytes, _patches), _path.Program.Syntax);
        return new Rewrite(program, _patches, _changedBlocks, _patches.Count, _increment);
    }

    // A loop around a single motion is in block order, but runs one block several times.
    private bool RunAgain(List<int> affected)
    {
        foreach (var motion in affected)
        {
            var block = _path.Motions.BlockOf(motion);
            if ((motion > 0 && _path.Motions.BlockOf(motion - 1) == block)
                || (motion + 1 < _path.Motions.Length && _path.Motions.BlockOf(motion + 1) == block))
            {
                return true;
            }
        }

        return false;
    }

    private (int Decimals, bool IsFixed) Spelling(List<int> affected, int count, int leastDecimals)
    {
        var spelling = (leastDecimals, false);
        for (var i = 0; i < count; i++)
        {
            foreach (ref readonly var token in _path.Program.Tokens(_path.Program[_path.Motions.BlockOf(affected[i])]))
            {
                spelling = BlockEdit.SpellingWith(spelling, token);
            }
        }

        return spelling;
    }

    // Each block is edited independently, so two concurrent halves give the same result as a sequential run.
    private Refusal? EditMany(List<int> affected)
    {
        var half = affected.Count / 2;
        while (half > 0 && _path.Motions.BlockOf(affected[half - 1]) == _path.Motions.BlockOf(affected[half]))
        {
            half--;
        }

        var other = new WordEditor(this);
        var behind = Task.Run(() => other.EditOnce(affected[half..]));
        var refusal = EditOnce(affected[..half]);
        refusal ??= behind.GetAwaiter().GetResult();
        _patches.AddRange(other._patches);
        _changedBlocks.AddRange(other._changedBlocks);
        _edit.Join(other._edit);
        return refusal;
    }

    private Refusal? EditOnce(List<int> affected)
    {
        foreach (var motion in affected)
        {
            if (Edit(motion) is { } refusal)
            {
                return refusal;
            }

            if (_edit.Patches is { Count: > 0 } patches)
            {
                _patches.AddRange(patches);
                _changedBlocks.Add(_path.Motions.BlockOf(motion));
            }
        }

        return null;
    }

    // Exact decimals end at 18 digits. If a program's own number leaves no room, the edit is refused.
    private Refusal? Edit(int index)
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
        _edit.Open(_path.Program[motion.Block]);
        if (motion.Has(MotionFlags.MachineMove))
        {
            // It ends at a machine position regardless of its start, or in other axes where it begins.
            var known = ~motion.UnknownEnd;
            var carried = Positioning.Only(known & motion.CarriedAxes, _change.MoveOf(index));
            return Positioning.Only(known, _change.MoveOf(index + 1)) == carried ? null : Obstacles.Of(_path, motion);
        }

        if (SetCoordinates(index, motion) is { } unknown)
        {
            return unknown;
        }

        if (motion.IsArc)
        {
            SetCircle(index, motion);
        }

        if (_edit.Patches.Count == 0)
        {
            return null;
        }

        if (Obstacles.Of(_path, motion) is { } obstacle)
        {
            return obstacle;
        }

        return motion.Has(MotionFlags.Inch) != _inch
            ? BlockRefusal.At(
                _path.Program,
                motion.Block,
                NcRefusalCodes.UnknownState,
                "the unit changes (G20/G21) between blocks that must change together.")
            : null;
    }

    private Refusal? SetCoordinates(int index, in NcMotion motion)
    {
        foreach (var axis in "XYZ"u8)
        {
            var (from, to) = (Steps(index, axis), Steps(index + 1, axis));
            var incremental = _edit.Distance(axis) switch
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

            if (_edit.Number(axis) is { } number)
            {
                if (steps != 0)
                {
                    _edit.Set(axis, number + new NcNumber(steps, _decimals));
                }
            }
            else if (from != to && _edit.Computed(axis) is { } distance)
            {
                // A computed position stays. A computed increment, or a position that would move, cannot be written.
                if (to != 0
                    || distance == WordDistance.Incremental
                    || (distance == WordDistance.Modal && motion.Has(MotionFlags.Incremental)))
                {
                    return Obstacles.Of(_path, index);
                }
            }
            else if (from != to)
            {
                if (!incremental && (motion.UnknownEnd & Axis(axis)) != AxisSet.None)
                {
                    return Obstacles.UnknownPlace(_path, index);
                }

                var original = incremental
                    ? new NcNumber(0, 0)
                    : NcNumber.Round(Coordinate(motion.End + (_path.Frames[motion.Frame].ProgramShift * -1), axis) / Unit, 6).Trim();
                _edit.Set(axis, original + new NcNumber(steps, _decimals));
            }
        }

        return null;
    }

    private static AxisSet Axis(byte letter) => letter switch { (byte)'X' => AxisSet.X, (byte)'Y' => AxisSet.Y, _ => AxisSet.Z };

    private long Steps(int joint, byte axis) =>
        NcNumber.Round(Coordinate(default(Point3) + _change.MoveOf(joint), axis) / _increment, 0).Digits;

    private static double Coordinate(Point3 point, byte axis) => axis switch { (byte)'X' => point.X, (byte)'Y' => point.Y, _ => point.Z };

    private Point2 Rounded(Point3 place, int joint, CoordinatePlane plane) =>
        plane.Project(new(
            place.X + (Steps(joint, (byte)'X') * _increment),
            place.Y + (Steps(joint, (byte)'Y') * _increment),
            place.Z + (Steps(joint, (byte)'Z') * _increment)));
}
