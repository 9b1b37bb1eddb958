using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Converts canned cycles to their motions.</summary>
internal sealed class CannedCycles(NcControl control, ControlRefusals refusals)
{
    /// <summary>Distance above the last depth at which a rapid ends in a deep hole, mm: LinuxCNC's 0.010 inch. Other controls have a
    /// parameter for it (assumed equal).</summary>
    private const double PeckClearanceMm = 0.254;

    private readonly BoreRetraction _retraction = new(control);

    // The tool's height when the first cycle began, and the modal words of the cycle.
    private double _initial;
    private (double Depth, double Plane, double Peck, bool HasPlane) _words;
    private AxisSet _unknown;
    private bool _pecksVary;

    private bool RepeatsByK => !_retraction.ShiftsByK && (control.Dialect.PeckLetters & BlockWords.Bit('K')) == 0;

    /// <summary>Switches to a cycle.</summary>
    public void Begin(NcMeaning meaning)
    {
        if (control.State.Cycle == NcMeaning.Unknown)
        {
            _initial = control.State.Plane.Height(control.State.Position);
            _words = default;
            _pecksVary = false;
            _retraction.Begin();
            _unknown = AxisSet.All;
        }

        control.State.Cycle = meaning;
        control.State.Unsure &= ~Unsure.Mode;
    }

    /// <summary>Runs the active cycle at the block's place.</summary>
    public void Drill(MotionFlags flags)
    {
        flags |= MotionFlags.Cycle;
        var plane = control.State.Plane;
        var axis = plane switch { CoordinatePlane.ZX => 'Y', CoordinatePlane.YZ => 'X', _ => 'Z' };
        var toolAxis = AxisSet.All & ~plane.Axes();
        var (target, unknown) = control.Moves.Target();
        ReadWords(axis, toolAxis);
        if (control.State.Cycle != NcMeaning.BackBoreCycle && _words.HasPlane && (_unknown & toolAxis) == AxisSet.None)
        {
            flags |= refusals.RefuseRising(_words.Plane, _words.Depth);
        }

        if (control.State.Cycle == NcMeaning.TapCycle && plane != CoordinatePlane.XY)
        {
            // Measured with rs274: its feeds use other axes than its rapids.
            control.Result.Problem("tap-plane", "LinuxCNC 2.9 taps along the wrong axes in G18 and G19: what it does here is not followed.",
                MotionFlags.None);
            control.Moves.Append(MotionKind.Cycle, flags, target, AxisSet.All);
            return;
        }

        var isKnown = (control.State.Unknown & toolAxis) == AxisSet.None && (_unknown & toolAxis) == AxisSet.None && _words.HasPlane;
        isKnown &= control.State.Cycle != NcMeaning.OpaqueLevelCycle;
        if (!isKnown || _pecksVary || control.State.Cycle == NcMeaning.OpaqueCycle)
        {
            // It ends over the position, at the height of the retract mode.
            var height = control.State.RetractsToR && control.State.Cycle != NcMeaning.BackBoreCycle ? _words.Plane : _initial;
            control.Moves.Append(MotionKind.Cycle, flags, plane.Lift(plane.Project(target), height),
                (unknown & plane.Axes()) | (isKnown ? AxisSet.None : toolAxis));
            return;
        }

        var times = control.Words.Has('L') ? control.Words.Value('L') : control.Words.Has('K') && RepeatsByK ? control.Words.Value('K')
            : 1;
        control.Run.Holes += times * (1 + PecksOfHole());
        if (!(control.Run.Holes <= ProgramRun.MostHoles))
        {
            control.Moves.Append(MotionKind.Cycle, flags, target, AxisSet.All);
            return;
        }

        if (times == 0)
        {
            // Whether it moves to the place of a cycle that does not run depends on the control.
            var away = target - control.State.Position;
            control.State.Unknown |= ((away.X != 0 ? AxisSet.X : AxisSet.None) | (away.Y != 0 ? AxisSet.Y : AxisSet.None)
                | (away.Z != 0 ? AxisSet.Z : AxisSet.None)) & plane.Axes();
        }

        var step = plane.Project(target) - plane.Project(control.State.Position);
        for (var i = 0; i < times; i++)
        {
            var place = i == 0 || !control.State.Incremental ? plane.Project(target)
                : control.Words.IsPolar ? plane.Project(control.Moves.PolarWordsTarget(control.State.Position, control.State.Unknown).End)
                : plane.Project(control.State.Position) + step;
            if (control.State.Cycle == NcMeaning.BackBoreCycle)
            {
                BackBore(flags, place, unknown & plane.Axes());
            }
            else
            {
                Hole(flags, place, unknown & plane.Axes(), i == 0);
            }
        }
    }

    /// <summary>True if a cycle is active whose hole is followed, and whose words have no other meaning in a pattern of holes.</summary>
    public bool CanDrillAt => control.State.Cycle is not (NcMeaning.Unknown or NcMeaning.OpaqueCycle or NcMeaning.FineBoreCycle
        or NcMeaning.OpaqueLevelCycle or NcMeaning.BackBoreCycle or NcMeaning.TapCycle) && !_pecksVary;

    /// <summary>Runs the active cycle at each of some places.</summary>
    public void DrillAt(MotionFlags flags, IReadOnlyList<Point2> places)
    {
        flags |= MotionFlags.Cycle;
        var plane = control.State.Plane;
        var toolAxis = AxisSet.All & ~plane.Axes();
        ReadPlaneAndDepth(plane switch { CoordinatePlane.ZX => 'Y', CoordinatePlane.YZ => 'X', _ => 'Z' }, toolAxis);
        control.Run.Holes += places.Count * (1 + PecksOfHole());
        var isKnown = (control.State.Unknown & toolAxis) == AxisSet.None && (_unknown & toolAxis) == AxisSet.None && _words.HasPlane
            && control.Run.Holes <= ProgramRun.MostHoles;
        for (var i = 0; i < places.Count; i++)
        {
            if (isKnown)
            {
                Hole(flags, places[i], AxisSet.None, i == 0);
            }
            else
            {
                control.Moves.Append(MotionKind.Cycle, flags, plane.Lift(places[i], _words.Plane), toolAxis);
            }
        }
    }

    // If coordinates are increments, the R plane is relative to the cycle's initial height, and the depth to the R plane.
    private void ReadWords(char axis, AxisSet toolAxis)
    {
        _retraction.Read();
        _pecksVary |= control.State.Cycle is NcMeaning.PeckCycle or NcMeaning.ChipBreakCycle
            && ((control.Words.Present | control.Words.Computed) & control.Dialect.PeckLetters) != 0;
        ReadPlaneAndDepth(axis, toolAxis);
    }

    private void ReadPlaneAndDepth(char axis, AxisSet toolAxis)
    {
        if (control.Words.Has('R'))
        {
            _words.Plane = control.State.Incremental ? BlockValues.Sum(_initial, control.Values.Length('R')) : control.Values.Length('R');
            _words.HasPlane = true;
        }

        if (control.Words.Has(axis))
        {
            var depth = control.Values.Length(axis);
            _words.Depth = control.State.Incremental ? BlockValues.Sum(_words.Plane, depth) : depth;
            _unknown &= ~toolAxis;
        }

        _words.Peck = control.Words.Has('Q') ? Math.Abs(control.Values.Length('Q')) : _words.Peck;
        _unknown |= control.Values.UnknownWords() & toolAxis;
        if ((control.Words.Unknown & (BlockWords.Bit('R') | BlockWords.Bit('Q'))) != 0)
        {
            _unknown |= toolAxis;
        }
    }

    private void Hole(MotionFlags flags, Point2 place, AxisSet unknown, bool first)
    {
        var plane = control.State.Plane;
        var (bottom, top) = (_words.Depth, _words.Plane);
        var clear = control.State.RetractsToR ? top : Math.Max(_initial, top);
        var height = plane.Height(control.State.Position);
        if (first && control.Values.ListsIdleMoves)
        {
            // LinuxCNC checks the cycle's initial height, not the tool's.
            if (_initial < top)
            {
                control.Moves.Append(
                    MotionKind.Rapid, flags, plane.Lift(plane.Project(control.State.Position), top), control.State.Unknown);
                height = top;
            }

            height = Math.Max(height, clear);
        }
        else if (first && height < top)
        {
            ToHeight(MotionKind.Rapid, flags, top);
            height = top;
        }

        if (control.Values.ListsIdleMoves || plane.Project(control.State.Position) != place || control.State.Unknown != unknown)
        {
            control.Moves.Append(MotionKind.Rapid, flags, plane.Lift(place, height), unknown);
        }

        if (height != top)
        {
            ToHeight(MotionKind.Rapid, flags, top);
        }

        Pecks(flags, bottom, top);
        ToHeight(MotionKind.Line, flags, bottom);
        if (control.State.Cycle is NcMeaning.FeedOutToClearCycle or NcMeaning.TapCycle)
        {
            ToHeight(MotionKind.Line, flags, clear);
            return;
        }

        if (control.State.Cycle == NcMeaning.FineBoreCycle)
        {
            RetractOffWall(flags, place, unknown, clear);
            return;
        }

        if (control.State.Cycle == NcMeaning.FeedOutCycle)
        {
            ToHeight(MotionKind.Line, flags, top);
        }

        ToHeight(MotionKind.Rapid, flags, clear);
    }

    // From the bottom: shifts off the wall, retracts, and moves back over the hole.
    private void RetractOffWall(MotionFlags flags, Point2 place, AxisSet unknown, double clear)
    {
        _retraction.Shift(flags, place, unknown, away: true);
        ToHeight(MotionKind.Rapid, flags, clear);
        _retraction.Shift(flags, place, unknown, away: false);
    }

    // The tool passes the hole shifted off its wall, cuts upwards from the R plane below, and returns to its initial height, regardless
    // of G98 and G99.
    private void BackBore(MotionFlags flags, Point2 place, AxisSet unknown)
    {
        var plane = control.State.Plane;
        if (plane.Project(control.State.Position) != place || control.State.Unknown != unknown)
        {
            control.Moves.Append(MotionKind.Rapid, flags, plane.Lift(place, plane.Height(control.State.Position)), unknown);
        }

        _retraction.Shift(flags, place, unknown, away: true);
        ToHeight(MotionKind.Rapid, flags, _words.Plane);
        _retraction.Shift(flags, place, unknown, away: false);
        ToHeight(MotionKind.Line, flags, _words.Depth);
        RetractOffWall(flags, place, unknown, _initial);
    }

    private double PecksOfHole() => control.State.Cycle is NcMeaning.PeckCycle or NcMeaning.ChipBreakCycle && _words.Peck > 0
        ? Math.Max(0, Math.Ceiling((_words.Plane - _words.Depth) / _words.Peck))
        : 0;

    private void Pecks(MotionFlags flags, double bottom, double top)
    {
        // Limited by a count, because a peck can be too short to change a large height.
        var (most, depth) = (PecksOfHole(), BlockValues.Sum(top, -_words.Peck));
        for (var peck = 0; peck < most && depth > bottom; peck++, depth = BlockValues.Sum(depth, -_words.Peck))
        {
            ToHeight(MotionKind.Line, flags, depth);
            if (control.State.Cycle == NcMeaning.PeckCycle)
            {
                ToHeight(MotionKind.Rapid, flags, top);
            }

            ToHeight(MotionKind.Rapid, flags, BlockValues.Sum(depth, PeckClearanceMm));
        }
    }

    private void ToHeight(MotionKind kind, MotionFlags flags, double height)
    {
        var plane = control.State.Plane;
        if (control.Values.ListsIdleMoves || plane.Height(control.State.Position) != height)
        {
            control.Moves.Append(kind, flags, plane.Lift(plane.Project(control.State.Position), height), control.State.Unknown);
        }
    }
}

/// <summary>How boring cycles take the tip off the wall at the bottom: the spindle stops in one orientation, the tool shifts away from
/// the tip, retracts, and shifts back (Fanuc G76, G87). Q gives the distance, but a machine parameter gives the direction; then the place
/// in the plane is unknown while the tool is shifted. I, J and K give both.</summary>
internal sealed class BoreRetraction(NcControl control)
{
    private Vector2? _shift;

    private (char First, char Second) ShiftLetters => control.State.Plane switch
    {
        CoordinatePlane.ZX => ('K', 'I'),
        CoordinatePlane.YZ => ('J', 'K'),
        _ => ('I', 'J'),
    };

    /// <summary>True if K is a shift: in G18 and G19, together with the other letter; alone it is the number of cycle runs.</summary>
    public bool ShiftsByK => control.State.Cycle is NcMeaning.FineBoreCycle or NcMeaning.BackBoreCycle
        && control.State.Plane != CoordinatePlane.XY && control.Words.Has(ShiftLetters.First) && control.Words.Has(ShiftLetters.Second);

    /// <summary>Clears the shift: a cycle begins.</summary>
    public void Begin() => _shift = null;

    /// <summary>Reads the shift. It is modal like the other words of a cycle: the last block with Q or the center letters of the plane
    /// applies.</summary>
    public void Read()
    {
        var (first, second) = ShiftLetters;
        var stated = (control.Words.Has(first) ? BlockWords.Bit(first) : 0) | (control.Words.Has(second) ? BlockWords.Bit(second) : 0);
        stated &= ShiftsByK ? uint.MaxValue : ~BlockWords.Bit('K');
        if (((control.Words.Present | control.Words.Unknown) & BlockWords.Bit('Q')) != 0
            || (control.Words.Unknown & BlockWords.CenterWords) != 0)
        {
            _shift = null;
        }
        else if (stated != 0)
        {
            _shift = new((stated & BlockWords.Bit(first)) != 0 ? control.Values.Length(first) : 0,
                (stated & BlockWords.Bit(second)) != 0 ? control.Values.Length(second) : 0);
        }
    }

    /// <summary>Shifts the tool away from the wall over a hole, or back.</summary>
    public void Shift(MotionFlags flags, Point2 place, AxisSet unknown, bool away)
    {
        var plane = control.State.Plane;
        var to = away ? place + (_shift ?? Vector2.Zero) : place;
        unknown |= away && _shift is null ? plane.Axes() : AxisSet.None;

        // A stated shift is at feed; one by the machine parameter is a rapid.
        control.Moves.Append(_shift is null ? MotionKind.Rapid : MotionKind.Line, flags,
            plane.Lift(to, plane.Height(control.State.Position)), unknown);
    }
}
