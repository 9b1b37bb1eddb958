using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>
/// Turns new joints and centers into the fewest changed words. Displacements are rounded to the least increment once, per joint, and added to the exact decimals
/// of the original, so increments keep their sum however long the chain is.
/// </summary>
internal sealed class WordEditor
{
    private readonly PathChange _change;
    private readonly NcPath _path;
    private readonly bool _keepRadii;
    private readonly List<NcPatch> _patches = [];
    private readonly List<int> _changedBlocks = [];
    private bool _inch;
    private int _decimals;
    private double _increment;
    private bool _programIsFixed;

    public WordEditor(PathChange change, bool keepRadii)
    {
        _change = change;
        _keepRadii = keepRadii;
        _path = change.Path;
    }

    public NcOutcome<Rewrite> Run()
    {
        var affected = Affected();
        if (affected.Count == 0)
        {
            return Rewrite.None(_path);
        }

        ChooseIncrement(affected);
        foreach (var motion in affected)
        {
            if (TryEdit(motion) is { } refusal)
            {
                return refusal;
            }
        }

        var program = _patches.Count == 0 ? _path.Program : NcProgram.Read(NcPatch.Apply(_path.Program.Bytes.Span, _patches), _path.Program.Syntax);
        return new Rewrite(program, _patches, _changedBlocks, _patches.Count, _increment);
    }

    // Exact decimals end at 18 digits: where a program's own number leaves no room, nothing else is written instead.
    private NcRefusal? TryEdit(int motion)
    {
        try
        {
            return Edit(motion);
        }
        catch (NcException e) when (e.Code == NcErrorCode.NumberTooLong)
        {
            return NcRefusal.At(_path.Program, _path.Motions[motion].Block, NcRefusalCodes.NumberTooLong, e.Message);
        }
    }

    private List<int> Affected()
    {
        var affected = new List<int>();
        for (var i = 0; i < _path.Motions.Length; i++)
        {
            if (_change.IsSet(i) || _change.IsSet(i + 1) || _change.Centers.ContainsKey(i))
            {
                affected.Add(i);
            }
        }

        return affected;
    }

    // The control's least increment, or finer where the program itself is written finer.
    private void ChooseIncrement(List<int> affected)
    {
        var first = _path.Motions[affected.Find(i => _change.IsSet(i + 1))];
        _inch = first.Has(MotionFlags.Inch);
        _decimals = _inch ? _path.Dialect.InchDecimals : _path.Dialect.MetricDecimals;
        foreach (var motion in affected)
        {
            foreach (var token in _path.Program.Tokens(_path.Program[_path.Motions[motion].Block]))
            {
                if (token.Kind == NcTokenKind.Word && token.Letter is >= (byte)'X' and <= (byte)'Z' or >= (byte)'I' and <= (byte)'K')
                {
                    _decimals = Math.Max(_decimals, Math.Min(6, token.Number.Decimals));
                    _programIsFixed |= token.Number.Decimals > 1 && token.Number.Digits % 10 == 0;
                }
            }
        }

        _increment = Math.Pow(10, -_decimals) * (_inch ? 25.4 : 1);
    }

    private NcRefusal? Edit(int index)
    {
        var motion = _path.Motions[index];
        if (motion.Kind == MotionKind.Reference)
        {
            // It ends at a place of the machine, wherever it begins.
            return null;
        }

        var edit = new BlockEdit(_path.Program, _path.Program[motion.Block], _programIsFixed);
        if (SetCoordinates(edit, index, motion) is { } unknown)
        {
            return unknown;
        }

        if (motion.IsArc)
        {
            SetCircle(edit, index, motion);
        }

        if (edit.Patches.Count == 0)
        {
            return null;
        }

        if (Obstacles.Of(_path, index) is { } obstacle)
        {
            return obstacle;
        }

        if (motion.Has(MotionFlags.Inch) != _inch)
        {
            return NcRefusal.At(_path.Program, motion.Block, NcRefusalCodes.UnknownState, "the unit changes (G20/G21) between blocks that must change together.");
        }

        _patches.AddRange(edit.Patches);
        _changedBlocks.Add(motion.Block);
        return null;
    }

    private NcRefusal? SetCoordinates(BlockEdit edit, int index, in NcMotion motion)
    {
        foreach (var axis in "XYZ")
        {
            var (from, to) = (Steps(index, axis), Steps(index + 1, axis));
            var steps = motion.Has(MotionFlags.Incremental) ? to - from : to;
            if (edit.Number(axis) is { } number)
            {
                if (steps != 0)
                {
                    edit.Set(axis, number + new NcNumber(steps, _decimals));
                }
            }
            else if (from != to)
            {
                if (!motion.Has(MotionFlags.Incremental) && (motion.UnknownEnd & Axis(axis)) != AxisSet.None)
                {
                    return Obstacles.UnknownPlace(_path, index);
                }

                var original = motion.Has(MotionFlags.Incremental) ? new NcNumber(0, 0) : NcNumber.Round(Coordinate(motion.End, axis) / Unit, 6).Trim();
                edit.Set(axis, original + new NcNumber(steps, _decimals));
            }
        }

        return null;
    }

    private static AxisSet Axis(char letter) => letter switch { 'X' => AxisSet.X, 'Y' => AxisSet.Y, _ => AxisSet.Z };

    private double Unit => _inch ? 25.4 : 1;

    private long Steps(int joint, char axis) => NcNumber.Round(Coordinate(default(Point3) + _change.MoveOf(joint), axis) / _increment, 0).Digits;

    private static double Coordinate(Point3 point, char axis) => axis switch { 'X' => point.X, 'Y' => point.Y, _ => point.Z };

    private Point2 Rounded(Point3 place, int joint, CoordinatePlane plane) =>
        plane.Project(new(place.X + (Steps(joint, 'X') * _increment), place.Y + (Steps(joint, 'Y') * _increment), place.Z + (Steps(joint, 'Z') * _increment)));

    private void SetCircle(BlockEdit edit, int index, in NcMotion motion)
    {
        var (start, end) = (Rounded(motion.Start, index, motion.Plane), Rounded(motion.End, index + 1, motion.Plane));
        var exact = _change.Centers.TryGetValue(index, out var moved) ? moved : motion.Center;
        if (IsShift(index, motion, exact - motion.Center))
        {
            ShiftCenter(edit, index, motion);
            return;
        }

        var wanted = Arc2.Between(
            motion.PlaneStart + _change.PlaneMoveOf(index, motion.Plane), motion.PlaneEnd + _change.PlaneMoveOf(index + 1, motion.Plane), exact, motion.Kind == MotionKind.ArcCounterClockwise);
        if (start == motion.PlaneStart && end == motion.PlaneEnd && wanted.Middle.DistanceTo(motion.Arc.Middle) < _increment)
        {
            // What was asked is less than the control can do.
            return;
        }

        if (motion.Has(MotionFlags.ByRadius))
        {
            SetRadius(edit, motion, start, end, wanted);
            return;
        }

        var (first, second) = CenterLetters(motion.Plane);
        var origin = CenterOrigin(motion, start);
        var was = new Vector2((edit.Number(first)?.Value ?? 0) * Unit, (edit.Number(second)?.Value ?? 0) * Unit);
        var (i, j) = CenterGrid.Choose(origin, start, end, wanted, was, _increment);
        SetCenterWord(edit, first, i);
        SetCenterWord(edit, second, j);
    }

    private static Point2 CenterOrigin(in NcMotion motion, Point2 start) => motion.Has(MotionFlags.AbsoluteCenter) ? Point2.Origin : start;

    // An arc that moves as a whole keeps its words, even if its radii agreed badly before; absolute center words move along.
    private bool IsShift(int index, in NcMotion motion, Vector2 centerMove) =>
        (_change.PlaneMoveOf(index, motion.Plane) - centerMove).Length < 1e-9 && (_change.PlaneMoveOf(index + 1, motion.Plane) - centerMove).Length < 1e-9;

    private void ShiftCenter(BlockEdit edit, int index, in NcMotion motion)
    {
        if (!motion.Has(MotionFlags.AbsoluteCenter) || motion.Has(MotionFlags.ByRadius))
        {
            return;
        }

        var (first, second) = CenterLetters(motion.Plane);
        foreach (var letter in (ReadOnlySpan<char>)[first, second])
        {
            if (Steps(index, letter switch { 'I' => 'X', 'J' => 'Y', _ => 'Z' }) is not 0 and var steps)
            {
                edit.Set(letter, (edit.Number(letter) ?? new NcNumber(0, 0)) + new NcNumber(steps, _decimals));
            }
        }
    }

    private void SetCenterWord(BlockEdit edit, char letter, long? steps)
    {
        if (steps is { } value && (value != 0 || edit.Number(letter) is not null))
        {
            edit.Set(letter, new(value, _decimals));
        }
    }

    // A radius keeps its word while it can: near half a turn the arc's height hangs on the radius by a square root, and a center says it better.
    private void SetRadius(BlockEdit edit, in NcMotion motion, Point2 start, Point2 end, Arc2 wanted)
    {
        var old = edit.Number('R')!.Value;
        var sign = old.Digits < 0 ? -1 : 1;
        var oldRadius = Math.Abs(old.Value) * Unit;
        if (_keepRadii && Sweep(start, end, sign * oldRadius, motion) is { } kept && Math.Abs(kept - motion.Arc.Sweep.Radians) < 0.02 * Math.Abs(motion.Arc.Sweep.Radians))
        {
            return;
        }

        if (Math.Abs(wanted.Radius - oldRadius) < _increment / 2 && HeightError(start, end, sign * oldRadius, wanted, motion) < _increment)
        {
            return;
        }

        // Moved end points take the radius rounded up, so that it surely reaches; elements take the nearest.
        var exactSteps = wanted.Radius / _increment;
        var steps = NcNumber.Round(_keepRadii ? Math.Ceiling(exactSteps - 1e-6) : exactSteps, 0).Digits;
        sign = Math.Abs(wanted.Sweep.Radians) > Math.PI + 1e-9 ? -1 : 1;
        while (2 * steps * _increment < start.DistanceTo(end))
        {
            steps++;
        }

        if (_keepRadii || HeightError(start, end, sign * steps * _increment, wanted, motion) < _increment)
        {
            edit.Set('R', new(sign * steps, _decimals));
            return;
        }

        var (first, second) = CenterLetters(motion.Plane);
        var origin = CenterOrigin(motion, start);
        var (i, j) = CenterGrid.Choose(origin, start, end, wanted, null, _increment);
        edit.Replace('R', (first, new(i!.Value, _decimals)), (second, new(j!.Value, _decimals)));
    }

    private static double? Sweep(Point2 start, Point2 end, double radius, in NcMotion motion)
    {
        var counterClockwise = motion.Kind == MotionKind.ArcCounterClockwise;
        return ArcCenter.ByRadius(start, end, radius, counterClockwise, 0) is { } center ? Arc2.Between(start, end, center, counterClockwise).Sweep.Radians : null;
    }

    private static double HeightError(Point2 start, Point2 end, double radius, Arc2 wanted, in NcMotion motion)
    {
        var counterClockwise = motion.Kind == MotionKind.ArcCounterClockwise;
        return ArcCenter.ByRadius(start, end, radius, counterClockwise, 0) is { } center
            ? Math.Abs(Arc2.Between(start, end, center, counterClockwise).Circle.SignedDistance(wanted.Middle))
            : double.PositiveInfinity;
    }

    private static (char First, char Second) CenterLetters(CoordinatePlane plane) => plane switch
    {
        CoordinatePlane.ZX => ('K', 'I'),
        CoordinatePlane.YZ => ('J', 'K'),
        _ => ('I', 'J'),
    };
}
