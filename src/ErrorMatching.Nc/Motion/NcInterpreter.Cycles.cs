using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>Canned cycles as the motions that they are made of.</content>
public sealed partial class NcInterpreter
{
    /// <summary>How far above the last depth a rapid ends in a deep hole, mm: LinuxCNC's 0.010 inch; other controls have a parameter for it (assumed the same).</summary>
    private const double PeckClearanceMm = 0.254;

    /// <summary>As many holes and pecks of one program as are followed: a block of a few bytes can ask for any number.</summary>
    private const int MostSteps = 100_000;

    private double _cycleInitial;
    private double _cycleSteps;
    private (double Depth, double Plane, double Peck, bool HasPlane) _cycle;
    private AxisSet _cycleUnknown;

    private void BeginCycle(NcMeaning meaning)
    {
        if (_state.Cycle == NcMeaning.Unknown)
        {
            _cycleInitial = _state.Plane.Height(_state.Position);
            _cycle = default;
            _cycleShift = null;
            _cycleUnknown = AxisSet.All;
        }

        _state.Cycle = meaning;
        _state.Unsure &= ~Unsure.Mode;
    }

    private void Drill(MotionFlags flags)
    {
        flags |= MotionFlags.Cycle;
        var plane = _state.Plane;
        var axis = plane switch { CoordinatePlane.ZX => 'Y', CoordinatePlane.YZ => 'X', _ => 'Z' };
        var toolAxis = AxisSet.All & ~plane.Axes();
        var (target, unknown) = Target();
        ReadCycleWords(axis, toolAxis);
        if (_state.Cycle == NcMeaning.TapCycle && plane != CoordinatePlane.XY)
        {
            // Measured with rs274: its feeds go along other axes than its rapids.
            Problem("tap-plane", "LinuxCNC 2.9 taps along the wrong axes in G18 and G19: what it does here is not followed.", MotionFlags.None);
            Append(MotionKind.Cycle, flags, target, AxisSet.All);
            return;
        }

        var isKnown = (_state.Unknown & toolAxis) == AxisSet.None && (_cycleUnknown & toolAxis) == AxisSet.None && _cycle.HasPlane;
        if (!isKnown || _state.Cycle == NcMeaning.OpaqueCycle)
        {
            // Over the position, at a height that depends.
            var height = _state.RetractsToR && _state.Cycle != NcMeaning.BackBoreCycle ? _cycle.Plane : _cycleInitial;
            Append(MotionKind.Cycle, flags, plane.Lift(plane.Project(target), height), (unknown & plane.Axes()) | (isKnown ? AxisSet.None : toolAxis));
            return;
        }

        var times = _words.Has('L') ? _words.Value('L') : _words.Has('K') && !ShiftsByK ? _words.Value('K') : 1;
        _cycleSteps += times * (1 + PecksOfHole());
        if (!(_cycleSteps <= MostSteps))
        {
            Append(MotionKind.Cycle, flags, target, AxisSet.All);
            return;
        }

        var step = plane.Project(target) - plane.Project(_state.Position);
        for (var i = 0; i < times; i++)
        {
            var place = i == 0 || !_state.Incremental ? plane.Project(target)
                : _words.IsPolar ? plane.Project(PolarWordsTarget(_state.Position, _state.Unknown).End)
                : plane.Project(_state.Position) + step;
            if (_state.Cycle == NcMeaning.BackBoreCycle)
            {
                BackBore(flags, place, unknown & plane.Axes());
            }
            else
            {
                Hole(flags, place, unknown & plane.Axes(), i == 0);
            }
        }
    }

    // The R plane counts from where the cycle began, the depth from the R plane, where coordinates are increments.
    private void ReadCycleWords(char axis, AxisSet toolAxis)
    {
        if (_words.Has('R'))
        {
            _cycle.Plane = _state.Incremental ? Sum(_cycleInitial, Length('R')) : Length('R');
            _cycle.HasPlane = true;
        }

        if (_words.Has(axis))
        {
            _cycle.Depth = _state.Incremental ? Sum(_cycle.Plane, Length(axis)) : Length(axis);
            _cycleUnknown &= ~toolAxis;
        }

        ReadCycleShift();
        _cycle.Peck = _words.Has('Q') ? Math.Abs(Length('Q')) : _cycle.Peck;
        _cycleUnknown |= UnknownWords() & toolAxis;
        if ((_words.Unknown & (BlockWords.Bit('R') | BlockWords.Bit('Q'))) != 0)
        {
            _cycleUnknown |= toolAxis;
        }
    }

    private void Hole(MotionFlags flags, Point2 place, AxisSet unknown, bool first)
    {
        var plane = _state.Plane;
        var (bottom, top) = (_cycle.Depth, _cycle.Plane);
        var clear = _state.RetractsToR ? top : Math.Max(_cycleInitial, top);
        var height = plane.Height(_state.Position);
        if (first && ListsIdleMoves)
        {
            // LinuxCNC asks where the cycle began, not where the tool is.
            if (_cycleInitial < top)
            {
                Append(MotionKind.Rapid, flags, plane.Lift(plane.Project(_state.Position), top), _state.Unknown);
                height = top;
            }

            height = Math.Max(height, clear);
        }
        else if (first && height < top)
        {
            ToHeight(MotionKind.Rapid, flags, top);
            height = top;
        }

        if (ListsIdleMoves || plane.Project(_state.Position) != place || _state.Unknown != unknown)
        {
            Append(MotionKind.Rapid, flags, plane.Lift(place, height), unknown);
        }

        if (height != top)
        {
            ToHeight(MotionKind.Rapid, flags, top);
        }

        Pecks(flags, bottom, top);
        ToHeight(MotionKind.Line, flags, bottom);
        if (_state.Cycle is NcMeaning.FeedOutToClearCycle or NcMeaning.TapCycle)
        {
            ToHeight(MotionKind.Line, flags, clear);
            return;
        }

        if (_state.Cycle == NcMeaning.FineBoreCycle)
        {
            LeaveOffTheWall(flags, place, unknown, clear);
            return;
        }

        if (_state.Cycle == NcMeaning.FeedOutCycle)
        {
            ToHeight(MotionKind.Line, flags, top);
        }

        ToHeight(MotionKind.Rapid, flags, clear);
    }

    // LinuxCNC has a motion for each step of a cycle even where it leads nowhere.
    private bool ListsIdleMoves => _dialect.Syntax == NcSyntax.LinuxCnc;

    private double PecksOfHole() => _state.Cycle is NcMeaning.PeckCycle or NcMeaning.ChipBreakCycle && _cycle.Peck > 0
        ? Math.Max(0, Math.Ceiling((_cycle.Plane - _cycle.Depth) / _cycle.Peck))
        : 0;

    private void Pecks(MotionFlags flags, double bottom, double top)
    {
        // Counted, since a peck can be too short to change a large height.
        var (most, depth) = (PecksOfHole(), Sum(top, -_cycle.Peck));
        for (var peck = 0; peck < most && depth > bottom; peck++, depth = Sum(depth, -_cycle.Peck))
        {
            ToHeight(MotionKind.Line, flags, depth);
            if (_state.Cycle == NcMeaning.PeckCycle)
            {
                ToHeight(MotionKind.Rapid, flags, top);
            }

            ToHeight(MotionKind.Rapid, flags, Sum(depth, PeckClearanceMm));
        }
    }

    private void ToHeight(MotionKind kind, MotionFlags flags, double height)
    {
        var plane = _state.Plane;
        if (ListsIdleMoves || plane.Height(_state.Position) != height)
        {
            Append(kind, flags, plane.Lift(plane.Project(_state.Position), height), _state.Unknown);
        }
    }
}
