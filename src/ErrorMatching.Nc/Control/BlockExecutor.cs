using System.Runtime.CompilerServices;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Executes the words of a block: holds the stateful parts and calls them in the order in which a control works.</summary>
internal sealed class BlockExecutor
{
    // G0 and G1, in tenths. Other codes with the same meaning may be refused for reasons of their own.
    private const int Rapid = 0, Line = 10;
    private const uint StraightLetters = BlockWords.LinearAxes | (1u << ('N' - 'A')) | (1u << ('F' - 'A'));
    private const uint CutLetters = BlockWords.CenterWords | (1u << ('R' - 'A'));

    private readonly NcControl _control;
    private readonly NcDialect _dialect;
    private readonly BlockWords _words;
    private readonly BlockValues _values;
    private readonly BlockIntent _intent;
    private readonly ProgramRun _run;
    private readonly RunResult _result;
    private readonly ProgramTransforms _transforms;
    private readonly ToolMoves _moves;
    private readonly Corners _corners;
    private readonly PolarEnds _polar;
    private readonly StatedPole _statedPole;
    private readonly Arcs _arcs;
    private readonly CannedCycles _canned;
    private readonly BlockCycles _cycles;
    private readonly CycleCalls _calls;
    private readonly MachineMoves _machine;
    private readonly OriginCodes _origins;
    private readonly ModeMemory _memory;
    private readonly BlockCodes _codes;
    private readonly BlockObstacles _obstacles;
    private readonly ModeWords _modeWords;
    private readonly uint _straightLetters;
    private readonly bool _stopsAtMoves;
    private readonly uint _axes;
    private readonly uint _cutLetters;

    public BlockExecutor(NcControl control)
    {
        (_control, _dialect, _words, _values, _intent) = (control, control.Dialect, control.Words, control.Values, control.Intent);
        (_run, _result, _moves, _transforms) = (control.Run, control.Result, control.Moves, control.Layers.Transforms);
        Refusals = new(control);
        Steering = new(control);
        Integers = new(control);
        _modeWords = new(control);
        _corners = new(control);
        _polar = new(control);
        _statedPole = new(control);
        _arcs = new(control, _corners, _statedPole);
        _canned = new(control, Refusals);
        _cycles = new(control, _corners, _canned);
        _calls = new(control, _corners);
        _machine = new(control, _corners);
        _origins = new(control, _corners);
        _memory = new(control, _origins);
        _codes = new(control, _origins, _machine, _canned);
        _obstacles = new(control, new(control, _codes, _calls), Steering);

        // A rotary axis that moves along only marks the motion: its place is not followed.
        _straightLetters = (StraightLetters | _values.OtherAxes) & StraightRefusals.Letters & ~_values.UnknownLetters;
        _stopsAtMoves = _dialect.Compensation.StopCodes.Overlaps([Rapid, Line]);
        _axes = BlockWords.LinearAxes | _values.OtherAxes;
        _cutLetters = _straightLetters | (CutLetters & ~(_values.OtherAxes | _values.UnknownLetters));
        _run.Returned = _memory.Return;
    }

    public ControlRefusals Refusals { get; }

    public BlockSteering Steering { get; }

    public IntegerWords Integers { get; }

    public CompensationWords Compensation => _codes.Compensation;

    /// <summary>True if the executed block moved an axis.</summary>
    public bool Moved => _intent.Use == AxisUse.Motion && _values.MovesAxes();

    /// <summary>True if a straight move has no further effect: no cycle, macro, corner or compensation entry is pending, and work
    /// coordinates equal the programmed ones. Two runs in the same <see cref="ModalState"/> with this property true stay equal while they
    /// only cut.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool IsStraight()
    {
        ref var state = ref _control.State;
        return state.Cycle == NcMeaning.Unknown && state.Form == NcMeaning.Unknown && !_intent.HasUnknownCode
            && !state.CompensationSwitched && state.ModalRounding == 0
            && !_corners.IsPending && _transforms.AreNone && _calls.AreNone && !_run.HasModalCall;
    }

    /// <summary>True until a block could have changed more than modes, the tool's place and variables.</summary>
    public bool HasOnlyModes { get; set; }

    /// <summary>True if nothing is pending that the next motion completes: two runs can be compared here by modes, place and
    /// variables.</summary>
    public bool CanBranch()
    {
        ref var state = ref _control.State;
        return state.Cycle == NcMeaning.Unknown && !state.CompensationSwitched && state.ModalRounding == 0 && !_corners.IsPending
            && _calls.AreNone && !_run.HasModalCall && !_memory.HasSaved;
    }

    /// <summary>Reads a block of plain words in one pass; false if it has anything else.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryReadPlain(ReadOnlySpan<byte> text) => _words.TryReadPlain(text, _dialect.Ways);

    /// <summary>True if the block whose plain words were just read is only a cut or a rapid.</summary>
    public bool IsCut()
    {
        var isCut = (_words.Present & ~_cutLetters) == 0 && _words.Repeated == 0 && _words.Functions.Length == 0 && IsStraight();
        foreach (var code in _words.Codes)
        {
            isCut &= _dialect.MeaningOf(code) is NcMeaning.Rapid or NcMeaning.Line or NcMeaning.ArcClockwise
                or NcMeaning.ArcCounterClockwise;
        }

        return isCut;
    }

    /// <summary>The short way for nearly all blocks: a straight move of plain words in a state without cycles, transformations and the
    /// like. False if the block may have more than that; then nothing was done.</summary>
    /// <remarks>
    /// Motions, modes, problems and counts are those of <see cref="Step"/>, as a test checks. Where the two differ:
    /// <list type="bullet">
    /// <item><description>The intent stays that of the last block of <see cref="Step"/>. It is read only in and after
    /// <see cref="Step"/>, which begins another one; an unknown code in it keeps blocks off this way.</description></item>
    /// <item><description>A D word that LinuxCNC forgets behind its block stays until the next <see cref="Step"/>, which forgets it before
    /// anything reads it.</description></item>
    /// <item><description>Codes at which the control stops under compensation are not looked for: blocks with G0 or G1 keep off this way
    /// where the dialect has them among these.</description></item>
    /// <item><description><see cref="HasOnlyModes"/> is judged by letters alone, which is enough for plain words with G0 or G1.
    /// </description></item>
    /// <item><description>The motion is added without layers and corners: programmed coordinates are work coordinates, and no corner is
    /// pending or stated.</description></item>
    /// </list>
    /// </remarks>
    public bool TryRunStraight()
    {
        var isStraight = (_words.Present & ~_straightLetters) == 0 && _words.Repeated == 0 && _words.Functions.Length == 0
            && IsStraight() && TryBeginStraight();
        if (isStraight)
        {
            ref var state = ref _control.State;
            HasOnlyModes &= HasOnlyModes && _modeWords.AreAllLetters();
            ReadNumbers(state.InchFeed);
            if ((_words.Present & _axes) != 0)
            {
                var given = _words.Present & BlockWords.LinearAxes;
                var incremental = state.Incremental ? given : 0;
                var flags = (_words.Present & _values.OtherAxes) != 0 ? MotionFlags.OtherAxis : MotionFlags.None;
                _moves.AppendStraight(
                    flags, _values.End(state.Position, given, incremental), state.Unknown & ~BlockWords.AxesOf(given & ~incremental));
            }
        }

        return isStraight;
    }

    // Puts G0 or G1 in force if the block states it, or goes on with the one in force. False if it has another code, or if the control may
    // refuse it.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool TryBeginStraight()
    {
        var codes = _words.Codes;
        if (codes.Length == 0)
        {
            return _control.State.Mode is MotionKind.Rapid or MotionKind.Line && Refusals.PassStraight(hasCode: false, isLine: false);
        }

        var meaning = _dialect.MeaningOf(codes[0]);
        if (codes.Length > 1 || codes[0] is not (Rapid or Line) || meaning is not (NcMeaning.Rapid or NcMeaning.Line) || _stopsAtMoves
            || (_values.ListsIdleMoves && (_words.Present & BlockWords.LinearAxes) == 0)
            || !Refusals.PassStraight(hasCode: true, meaning == NcMeaning.Line))
        {
            return false;
        }

        _control.Mode(meaning == NcMeaning.Rapid ? MotionKind.Rapid : MotionKind.Line);
        return true;
    }

    /// <summary>Executes any words that were just read.</summary>
    /// <param name="flags">What is known of the block's motions before its words.</param>
    public void Step(MotionFlags flags = MotionFlags.None)
    {
        HasOnlyModes &= HasOnlyModes && _modeWords.AreAll();
        _intent.Begin();
        flags |= ReadModes();
        if (_words.HasPolarEnd && (_intent.Use is not (AxisUse.Motion or AxisUse.Pole) || _control.State.Cycle != NcMeaning.Unknown))
        {
            flags |= LosePolarEnd();
        }

        if (_dialect.BlocksNameMotions)
        {
            flags |= CheckMotion();
        }

        switch (_intent.Use)
        {
            case AxisUse.Motion when _values.MovesAxes() || EndsSomewhere():
                Move(flags);
                break;
            case AxisUse.Motion when _values.ListsIdleMoves && _values.StatesStraightMotion():
                // LinuxCNC adds a motion that stays in place.
                _moves.Append(_control.State.Mode, flags, _control.State.Position, _control.State.Unknown);
                break;
            case AxisUse.MachineCoordinates when _values.MovesAxes():
                _machine.Move(flags);
                break;
            case AxisUse.Reference:
                _machine.Return(flags);
                break;
            case AxisUse.Pole:
                _polar.SetPole(_intent.Code);
                break;
            case AxisUse.Cycle:
                _cycles.Run(flags);
                break;
            case AxisUse.Origin:
                _origins.Run();
                break;
            case AxisUse.Center:
                _statedPole.Set();
                break;
            case AxisUse.Corner:
                _corners.KeepForLast(_intent.Code);
                break;
        }

        if (!_calls.AreNone)
        {
            _calls.RunBehind(Moved);
        }

        Refusals.EndBlock();
    }

    // A departure moves without coordinates, too: to a place that the control computes.
    private bool EndsSomewhere() => _intent.NamesMotion && _control.State.Form == NcMeaning.Departure;

    // Where each block names its motion, coordinates without a motion, and an arc without its sense or its end, are an error.
    private MotionFlags CheckMotion()
    {
        if (_intent.CallsTool)
        {
            _codes.CallTool();
        }

        if ((_words.Present & _values.ToolCalls) != 0 || (_words.Computed & _values.ToolCalls) != 0)
        {
            _result.ChangeTool();
            _origins.Lengths.TakeFromTable();
            _control.State.Unknown = AxisSet.All;
        }

        if (_intent.Use is not (AxisUse.Motion or AxisUse.MachineCoordinates))
        {
            return MotionFlags.None;
        }

        _intent.AboutPole |= _words.IsPolar;
        if (_intent.NeedsSense || (_control.State.Form == NcMeaning.ArcAboutPole && _intent.NamesMotion && !_values.MovesAxes()))
        {
            _control.State.Unknown |= _control.State.Plane.Axes();
            return _result.Problem("bad-arc", "Not an arc: its end or its sense (DR) is missing.", MotionFlags.BadArc);
        }

        if (!_intent.NamesMotion && _values.MovesAxes())
        {
            _control.Layers.Forget();
            _intent.Use = AxisUse.Nothing;
            return _result.Problem("unknown-word", "Coordinates without a path function: what moves here is not known.",
                MotionFlags.UnknownWord);
        }

        return MotionFlags.None;
    }

    // Reads all that a block switches before its axis words apply, and the feed.
    private MotionFlags ReadModes()
    {
        var flags = _obstacles.Read();
        var modes = _memory.RoleOfBlock();
        if (modes == FunctionRole.RestoreModes)
        {
            flags |= _memory.Restore();
        }

        var saves = modes is FunctionRole.SaveModes or FunctionRole.SaveModesOfCall;
        var before = saves ? _memory.Now(atReturn: modes == FunctionRole.SaveModesOfCall) : default;
        var inchFeedBefore = _control.State.InchFeed;
        flags |= _codes.ReadCodes() | _codes.ReadFunctions() | Refusals.Read();
        _memory.Drop();
        if (_intent.Use is not (AxisUse.Nothing or AxisUse.Corner))
        {
            ReadNumbers(_dialect.Ways.ReadsFeedBeforeUnits ? inchFeedBefore : _control.State.InchFeed);
        }

        if (saves)
        {
            _memory.Save(before);
        }

        return flags;
    }

    // Counts coordinates without a point, and takes the feed over, for both ways of executing a block.
    private void ReadNumbers(bool inchFeed)
    {
        if (Integers.Matter && (_words.Integers & _values.LengthLetters) != 0)
        {
            Integers.CountIn(_result.Block);
        }

        if (_words.Has('F'))
        {
            ref var state = ref _control.State;
            state.Feed = _words.Value('F') * (inchFeed && !state.InverseTime ? NcControl.MmPerInch : 1);
        }
    }

    private void Move(MotionFlags flags)
    {
        ref var state = ref _control.State;
        if (state.Cycle != NcMeaning.Unknown)
        {
            _corners.Lose();
            _canned.Drill(flags);
            return;
        }

        flags |= _words is { HasPolarEnd: false, IsPolar: false } ? MotionFlags.None
            : _transforms.AreMoreThanShift ? MotionFlags.Transformed
            : !_words.HasPolarEnd && _statedPole.IsPlainArc() ? MotionFlags.PolarEnd
            : MotionFlags.Transformed | MotionFlags.PolarEnd;
        flags |= state.Form == NcMeaning.ThreadCut ? MotionFlags.Cycle : MotionFlags.None;
        var kind = _intent.Probes ? MotionKind.Probe : state.Mode;
        var plane = state.Plane;
        state.WorksInXY = _dialect.BlocksNameMotions ? plane == CoordinatePlane.XY : state.WorksInXY;
        state.Plane = _statedPole.Plane;
        var (end, unknown) = _words.HasPolarEnd ? PolarTarget(kind, ref flags) : _intent.AboutPole ? _statedPole.Target() : _moves.Target();
        unknown |= EndsSomewhere() && !_words.IsPolar ? state.Plane.Axes() & ~_values.GivenAxes() : AxisSet.None;
        if (kind is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise)
        {
            // Only an arc to a polar end is documented as a helix.
            flags |= _dialect.BlocksNameMotions && !_intent.AboutPole && (_values.GivenAxes() & ~state.Plane.Axes()) != AxisSet.None
                ? _result.Problem("bad-arc", "Not an arc: it has a coordinate outside of its plane.", MotionFlags.BadArc)
                : MotionFlags.None;
            _arcs.Turn(kind, flags, end, unknown);
        }
        else
        {
            flags |= _control.TakeSwitch(state.Plane.Project(state.Position) != state.Plane.Project(end) || EndsSomewhere());
            _corners.Cut(kind, flags, end, unknown, null);
            _moves.Append(kind, flags, end, unknown);
        }

        state.Plane = plane;
        _corners.Keep(kind);
        if (kind == MotionKind.Probe)
        {
            state.Unknown |= _values.GivenAxes();
        }
    }

    private (Point3 End, AxisSet Unknown) PolarTarget(MotionKind kind, ref MotionFlags flags)
    {
        var (given, unknown) = _moves.Target();
        if (_polar.End(kind) is { } end)
        {
            return (end, unknown & ~_control.State.Plane.Axes());
        }

        flags |= LosePolarEnd();
        return (given, unknown | _control.State.Plane.Axes());
    }

    // The end of the block is not followed.
    private MotionFlags LosePolarEnd()
    {
        _control.State.Unknown |= _control.State.Plane.Axes();
        return _result.UnknownWord("a polar end that the block does not state as a whole");
    }
}
