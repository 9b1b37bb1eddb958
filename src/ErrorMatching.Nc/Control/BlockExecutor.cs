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
    private readonly CycleCalls _calls;
    private readonly MachineMoves _machine;
    private readonly ModeMemory _memory;
    private readonly OriginCodes _origins;
    private readonly BlockCodes _codes;
    private readonly BlockObstacles _obstacles;
    private readonly uint _straightLetters;
    private readonly uint _cutLetters;

    public BlockExecutor(ControlState control, ProgramRun run, RunResult result)
    {
        (_control, _run, _result, _dialect) = (control, run, result, run.Dialect);
        var values = _values = new(_dialect, control);
        var layers = Layers = new(control, result, run);
        var steps = new CycleSteps();
        (_words, _transforms) = (values.Words, layers.Transforms);
        _writer = new(control, layers, result);
        _ends = new(control, values, layers, _intent);
        _corners = new(control, values, layers, result, _writer);
        _arcs = new(control, values, layers, result, _writer, _corners);
        _canned = new(control, values, result, _writer, _ends, new(control, values, _writer), steps);
        _calls = new(control, run, result, _writer, _corners, new(control, _writer, steps), new(control, steps));
        _machine = new(control, values, layers, result, _writer, _intent, _ends, _corners);

        var transforms = new TransformCodes(control, values, layers, result);
        var lengths = new ToolLengthCodes(control, values, layers);
        var offsets = new OffsetCodes(control, values, layers);
        _memory = new(control, values, run, layers, result, offsets, lengths, transforms);
        _origins = new(_intent, layers, result, _corners, new(values, layers), offsets, lengths, transforms);
        _codes = new(control, values, run, layers, result, _intent, offsets, lengths, transforms, _machine, _canned, _memory,
            new(control, values, result));

        Reader = new(values, run);
        Switches = new(values, run, layers, result, Reader);
        Steering = new(values, run);
        Integers = new(run.Program, values);
        _obstacles = new(control, values, run, layers, result, new(control, values, run, layers, result, _codes, _calls), Switches);

        _straightLetters = StraightLetters & ~(values.OtherAxes | values.UnknownLetters);
        _cutLetters = _straightLetters | (CutLetters & ~(values.OtherAxes | values.UnknownLetters));
        run.Returned = _memory.Return;
    }

    public CoordinateLayers Layers { get; }

    public BlockReader Reader { get; }

    public MachineSwitches Switches { get; }

    public SteeringWords Steering { get; }

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

            _control.Mode(meaning == NcMeaning.Rapid ? MotionKind.Rapid : MotionKind.Line);
        }
        else if (state.Mode is not (MotionKind.Rapid or MotionKind.Line))
        {
            return false;
        }

        if (_words.Has('F'))
        {
            state.Feed = _words.Value('F') * (state.InchFeed && !state.InverseTime ? ControlState.MmPerInch : 1);
        }

        if ((_words.Present & BlockWords.LinearAxes) != 0)
        {
            if (Integers.Matter && (_words.Integers & BlockWords.LinearAxes) != 0)
            {
                Integers.CountIn(_result.Block);
            }

            var given = _words.Present & BlockWords.LinearAxes;
            var incremental = state.Incremental ? given : 0;
            _writer.AppendStraight(_values.End(state.Position, given, incremental),
                state.Unknown & ~BlockWords.AxesOf(given & ~incremental));
        }

        return true;
    }

    /// <summary>Executes any words that were just read.</summary>
    public void Step()
    {
        _intent.Begin();
        var flags = ReadModes();
        switch (_intent.Use)
        {
            case AxisUse.Motion when _values.MovesAxes():
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
            case AxisUse.Origin:
                _origins.Run();
                break;
        }

        if (!_calls.AreNone)
        {
            _calls.RunBehind(Moved);
        }
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
        flags |= _codes.ReadCodes() | _codes.ReadFunctions();
        if (_intent.Use != AxisUse.Nothing)
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

        flags |= _words.IsPolar ? MotionFlags.Transformed : MotionFlags.None;
        flags |= state.Form == NcMeaning.ThreadCut ? MotionFlags.Cycle : MotionFlags.None;
        var kind = _intent.Probes ? MotionKind.Probe : state.Mode;
        var (end, unknown) = _ends.Target();
        if (kind is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise)
        {
            _arcs.Turn(kind, flags, end, unknown);
        }
        else
        {
            flags |= _control.SwitchCompensation(state.Plane.Project(state.Position) != state.Plane.Project(end));
            _corners.Cut(kind, flags, end, unknown, null);
            _writer.Append(kind, flags, end, unknown);
        }

        _corners.Keep(kind);
        if (kind == MotionKind.Probe)
        {
            state.Unknown |= _values.GivenAxes();
        }
    }
}
