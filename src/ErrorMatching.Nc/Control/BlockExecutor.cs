using System.Runtime.CompilerServices;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Executes the words of a block: holds the stateful parts and calls them in the order in which a control works.</summary>
internal sealed class BlockExecutor
{
    private const uint StraightLetters = BlockWords.LinearAxes | (1u << ('N' - 'A')) | (1u << ('F' - 'A'));
    private const uint CutLetters = BlockWords.CenterWords | (1u << ('R' - 'A'));

    private readonly ControlState _control;
    private readonly ProgramRun _run;
    private readonly RunResult _result;
    private readonly BlockValues _values;
    private readonly BlockWords _words;
    private readonly NcDialect _dialect;
    private readonly ProgramTransforms _transforms;
    private readonly MotionWriter _writer;
    private readonly BlockIntent _intent = new();
    private readonly EndPoints _ends;
    private readonly Corners _corners;
    private readonly Arcs _arcs;
    private readonly CannedCycles _canned;
    private readonly BlockCycles _cycles;
    private readonly PolarEnds _polar;
    private readonly CycleCalls _calls;
    private readonly MachineMoves _machine;
    private readonly ModeMemory _memory;
    private readonly OriginCodes _origins;
    private readonly BlockCodes _codes;
    private readonly BlockObstacles _obstacles;
    private readonly ControlRefusals _refusals;
    private readonly PoleCodes _pole;
    private readonly ToolLengthCodes _lengths;
    private readonly ModeWords _modeWords;
    private readonly uint _straightLetters;
    private readonly uint _axes;
    private readonly uint _cutLetters;

    public BlockExecutor(ControlState control, ProgramRun run, RunResult result)
    {
        (_control, _run, _result, _dialect) = (control, run, result, run.Dialect);
        var values = _values = new(_dialect, control);
        var layers = Layers = new(control, result, run);
        var steps = new CycleSteps();
        (_words, _transforms) = (values.Words, layers.Transforms);
        _writer = new(control, layers, result);
        _pole = new(control, values, result);
        Refusals = _refusals = new(control, values, result, layers, _intent);
        _ends = new(control, values, layers, _intent);
        _corners = new(control, values, layers, result, _writer);
        _arcs = new(control, values, layers, result, _writer, _corners, _pole);
        _canned = new(control, values, result, _writer, _ends, new(control, values, _writer), steps, _refusals);
        _polar = new(control, values);
        _cycles = new(control, values, layers, result, _intent, _writer, _ends, _corners, _canned);
        _calls = new(control, run, result, _writer, _corners, new(control, _writer, steps), new(control, steps));
        _machine = new(control, values, layers, result, _writer, _intent, _ends, _corners);

        var transforms = new TransformCodes(control, values, layers, result);
        var lengths = _lengths = new ToolLengthCodes(control, values, layers);
        var offsets = new OffsetCodes(control, values, layers, result);
        _memory = new(control, values, run, layers, result, offsets, lengths, transforms);
        _origins = new(_intent, layers, result, _corners, new(values, layers), offsets, lengths, transforms);
        var tool = new CalledTool(control, values);
        Compensation = new(control, values, tool, result);
        _codes = new(
            control, values, run, layers, result, _intent, offsets, lengths, transforms, _machine, _canned, _memory, Compensation);

        _modeWords = new(control, values, run);
        Reader = new(values, run);
        Switches = new(values, run, layers, result, Reader);
        SystemCommands = new(_dialect, run, layers, result, _writer, control);
        Steering = new(values, run);
        Integers = new(run.Program, values);
        var statements = new BlockStatements(control, values, run, layers, result, _codes, _calls, _intent, tool, lengths);
        _obstacles = new(control, values, run, layers, result, statements, Switches);

        // A rotary axis that moves along only marks the motion: its place is not followed.
        _straightLetters = (StraightLetters | values.OtherAxes) & ~values.UnknownLetters;
        _axes = BlockWords.LinearAxes | values.OtherAxes;
        _cutLetters = _straightLetters | (CutLetters & ~(values.OtherAxes | values.UnknownLetters));
        run.Returned = _memory.Return;
    }

    public CoordinateLayers Layers { get; }

    public BlockReader Reader { get; }

    public ControlRefusals Refusals { get; }

    public MachineSwitches Switches { get; }

    public SystemCommands SystemCommands { get; }

    public SteeringWords Steering { get; }

    public CompensationWords Compensation { get; }

    public IntegerWords Integers { get; }

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
    public bool TryReadPlain(ReadOnlySpan<byte> text) => _words.TryReadPlain(text, _dialect.Syntax);

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

    /// <summary>The fast path for nearly all blocks: a straight move of plain words in a state without cycles, transformations and the
    /// like. It does what <see cref="Step"/> would do, as a test checks.</summary>
    /// <returns>False if the block may have more than a straight move; then nothing was done.</returns>
    public bool TryRunStraight()
    {
        if ((_words.Present & ~_straightLetters) != 0 || _words.Repeated != 0 || _words.Functions.Length != 0 || !IsStraight())
        {
            return false;
        }

        ref var state = ref _control.State;
        var codes = _words.Codes;
        if (codes.Length > 0)
        {
            var meaning = _dialect.MeaningOf(codes[0]);
            if (codes.Length > 1 || meaning is not (NcMeaning.Rapid or NcMeaning.Line)
                || (_values.ListsIdleMoves && (_words.Present & BlockWords.LinearAxes) == 0))
            {
                return false;
            }

            if (!_refusals.PassStraight(hasCode: true, meaning == NcMeaning.Line))
            {
                return false;
            }

            _control.Mode(meaning == NcMeaning.Rapid ? MotionKind.Rapid : MotionKind.Line);
        }
        else if (state.Mode is not (MotionKind.Rapid or MotionKind.Line) || !_refusals.PassStraight(hasCode: false, isLine: false))
        {
            return false;
        }

        if (_words.Has('F'))
        {
            state.Feed = _words.Value('F') * (state.InchFeed && !state.InverseTime ? ControlState.MmPerInch : 1);
        }

        if ((_words.Present & _axes) != 0)
        {
            if (Integers.Matter && (_words.Integers & BlockWords.LinearAxes) != 0)
            {
                Integers.CountIn(_result.Block);
            }

            var given = _words.Present & BlockWords.LinearAxes;
            var incremental = state.Incremental ? given : 0;
            var flags = (_words.Present & _values.OtherAxes) != 0 ? MotionFlags.OtherAxis : MotionFlags.None;
            _writer.AppendStraight(
                flags, _values.End(state.Position, given, incremental), state.Unknown & ~BlockWords.AxesOf(given & ~incremental));
        }

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
                _writer.Append(_control.State.Mode, flags, _control.State.Position, _control.State.Unknown);
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
                _pole.Set();
                break;
            case AxisUse.Corner:
                _corners.KeepForLast(_intent.Code);
                break;
        }

        if (!_calls.AreNone)
        {
            _calls.RunBehind(Moved);
        }

        _refusals.EndBlock();
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
            _lengths.TakeFromTable();
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
            Layers.Forget();
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
        var inchFeed = _control.State.InchFeed;
        flags |= _codes.ReadCodes() | _codes.ReadFunctions() | _refusals.Read();
        if (_intent.Use is not (AxisUse.Nothing or AxisUse.Corner))
        {
            ReadNumbers(inchFeed);
        }

        if (saves)
        {
            _memory.Save(before);
        }

        return flags;
    }

    private void ReadNumbers(bool inchFeedBefore)
    {
        if (Integers.Matter && _words.Integers != 0)
        {
            Integers.CountIn(_result.Block);
        }

        if (_words.Has('F'))
        {
            // LinuxCNC applies the feed of a block before its units.
            ref var state = ref _control.State;
            var inchFeed = _dialect.Syntax == NcSyntax.LinuxCnc ? inchFeedBefore : state.InchFeed;
            state.Feed = _words.Value('F') * (inchFeed && !state.InverseTime ? ControlState.MmPerInch : 1);
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
            : !_words.HasPolarEnd && _pole.IsPlainArc() ? MotionFlags.PolarEnd
            : MotionFlags.Transformed | MotionFlags.PolarEnd;
        flags |= state.Form == NcMeaning.ThreadCut ? MotionFlags.Cycle : MotionFlags.None;
        var kind = _intent.Probes ? MotionKind.Probe : state.Mode;
        var plane = state.Plane;
        state.WorksInXY = _dialect.BlocksNameMotions ? plane == CoordinatePlane.XY : state.WorksInXY;
        state.Plane = _pole.PlaneOf(_intent);
        var (end, unknown) = _words.HasPolarEnd ? PolarTarget(kind, ref flags) : _intent.AboutPole ? _pole.Target() : _ends.Target();
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
            flags |= _control.SwitchCompensation(state.Plane.Project(state.Position) != state.Plane.Project(end) || EndsSomewhere());
            _corners.Cut(kind, flags, end, unknown, null);
            _writer.Append(kind, flags, end, unknown);
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
        var (given, unknown) = _ends.Target();
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
