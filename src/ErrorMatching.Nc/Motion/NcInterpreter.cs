using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>
/// Reads a program as its control would and yields the motions. What it does not understand makes the state unknown until the program
/// states it again, so that nothing is ever guessed silently.
/// </summary>
public sealed partial class NcInterpreter
{
    private const double MmPerInch = 25.4;
    private const int ToolChange = 6;
    private const uint LinearAxes = (1u << 23) | (1u << 24) | (1u << 25);
    private const uint CenterWords = (1u << 8) | (1u << 9) | (1u << 10);
    private const uint GeometryWords = LinearAxes | CenterWords | (1u << 17) | (0x3Fu << 26);

    private readonly NcProgram _program;
    private readonly NcDialect _dialect;
    private readonly BlockWords _words = new();
    private readonly List<NcProblem> _problems = [];
    private readonly HashSet<NcProblem> _said = [];
    private readonly List<(int Block, int Joint)> _placeDependents = [];
    private readonly List<int> _toolChanges = [];
    private readonly NcMotions _motions;
    private readonly uint _otherAxes;
    private readonly uint _unknownLetters;
    private readonly uint _straightLetters;
    private readonly uint _cutLetters;
    private readonly uint _lengthLetters;
    private ModalState _state = ModalState.Initial;

    // The block that motions belong to: the one being executed, or the one in this file that called a program of another file.
    private int _block;

    private NcInterpreter(NcProgram program, NcDialect dialect, NcMotions motions, Func<string, NcProgram?>? library, CancellationToken cancellation)
    {
        _program = program;
        _text = program;
        _library = library;
        _cancellation = cancellation;
        _dialect = dialect;
        _countsIntegers = dialect.NotesNumbersWithoutPoint;
        _state.RetractsToR = dialect.Syntax == NcSyntax.LinuxCnc;
        _motions = motions;
        for (var letter = 'A'; letter <= 'Z'; letter++)
        {
            var role = dialect.RoleOf((byte)letter);
            _otherAxes |= role == LetterRole.OtherAxis ? BlockWords.Bit(letter) : 0;
            _unknownLetters |= role == LetterRole.Unknown ? BlockWords.Bit(letter) : 0;
            _lengthLetters |= role is LetterRole.Axis or LetterRole.Center or LetterRole.Radius ? BlockWords.Bit(letter) : 0;
        }

        _straightLetters = StraightLetters & ~(_otherAxes | _unknownLetters);
        _cutLetters = _straightLetters | (CutLetters & ~(_otherAxes | _unknownLetters));
    }

    private enum AxisUse
    {
        Motion,
        Nothing,
        Origin,
        Reference,
        MachineCoordinates,
    }

    /// <summary>Interprets a program that stands alone.</summary>
    /// <param name="program">The program; it is read in the dialect's syntax.</param>
    /// <param name="dialect">The control that it is for.</param>
    public static NcPath Run(NcProgram program, NcDialect dialect) => Run(program, dialect, null, CancellationToken.None);

    /// <summary>Interprets a program.</summary>
    /// <param name="program">The program; it is read in the dialect's syntax.</param>
    /// <param name="dialect">The control that it is for.</param>
    /// <param name="library">Finds a called program that is not in the file, by its name (<c>O1002</c>, <c>L10</c>, <c>POCKET</c>); null where there is none. Null instead of it: no other program is known.</param>
    /// <param name="cancellation">Ends a long run.</param>
    /// <exception cref="OperationCanceledException">The run was canceled.</exception>
    public static NcPath Run(NcProgram program, NcDialect dialect, Func<string, NcProgram?>? library, CancellationToken cancellation) =>
        new NcInterpreter(program.In(dialect.Syntax), dialect, new(), library, cancellation).Run();

    private void Step()
    {
        (_use, _code, _family, _probes, _hasUnknownCode) = (AxisUse.Motion, NcMeaning.Unknown, 0, false, false);
        var flags = ReadObstacles();
        var modes = ModesRole();
        if (modes == FunctionRole.RestoreModes)
        {
            flags |= RestoreModes();
        }

        var saves = modes is FunctionRole.SaveModes or FunctionRole.SaveModesOfCall;
        var before = saves ? Modes(atReturn: modes == FunctionRole.SaveModesOfCall) : default;
        var inchFeed = _state.InchFeed;
        flags |= ReadCodes() | ReadFunctions();

        if (_countsIntegers && _words.Integers != 0 && _use != AxisUse.Nothing)
        {
            CountIntegers();
        }

        if (_words.Has('F') && _use != AxisUse.Nothing)
        {
            // LinuxCNC takes the feed of a block before its units.
            inchFeed = _dialect.Syntax == NcSyntax.LinuxCnc ? inchFeed : _state.InchFeed;
            _state.Feed = _words.Value('F') * (inchFeed && !_state.InverseTime ? MmPerInch : 1);
        }

        if (saves)
        {
            SaveModes(before);
        }

        switch (_use)
        {
            case AxisUse.Motion when MovesAxes():
                Move(flags);
                break;
            case AxisUse.Motion when ListsIdleMoves && StatesStraightMotion():
                // LinuxCNC goes where it stands.
                Append(_state.Mode, flags, _state.Position, _state.Unknown);
                break;
            case AxisUse.MachineCoordinates when MovesAxes():
                MoveInMachine(flags);
                break;
            case AxisUse.Reference:
                ReturnToReference(flags);
                break;
            case AxisUse.Origin:
                if (_code is NcMeaning.SetPosition or NcMeaning.SetOffset or NcMeaning.Rotation or NcMeaning.Scaling or NcMeaning.OpaqueTransform)
                {
                    DependOnPlace();
                }

                SetOrigin(_code);
                break;
        }

        if (_cycleCall is not null || _modalCycle is not null || _nextCycleIsModal)
        {
            RunCycleCalls();
        }
    }

    private bool Moved => _use == AxisUse.Motion && MovesAxes();

    private void DependOnPlace() => _placeDependents.Add((_block, _motions.Length));

    private bool MovesAxes()
    {
        var given = _words.Present | _words.Computed;
        var arc = _state.Mode is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise && _state.Cycle == NcMeaning.Unknown;
        var axes = _state.Cycle == NcMeaning.Unknown ? LinearAxes : LinearAxes | BlockWords.Bit('R');
        return (given & (axes | _otherAxes)) != 0 || _words.IsPolar || (arc && (given & CenterWords) != 0);
    }

    private bool StatesStraightMotion()
    {
        foreach (var code in _words.Codes)
        {
            if (_dialect.MeaningOf(code) is NcMeaning.Rapid or NcMeaning.Line)
            {
                return true;
            }
        }

        return false;
    }

    private void Append(MotionKind kind, MotionFlags flags, Point3 end, AxisSet unknownEnd, Point2 center = default, int turns = 0)
    {
        var start = Work(_state.Position, _state.Unknown);
        var to = Work(end, unknownEnd);
        _motions.Add(new(_block, kind, _state.Plane, flags | ModeFlags(), start.Place, to.Place, center, turns, _state.Feed, _state.Frame, start.Unknown, to.Unknown));
        _state.Position = end;
        _state.Unknown = unknownEnd;
    }

    private MotionFlags ModeFlags() =>
        (_state.Inch ? MotionFlags.Inch : MotionFlags.None)
        | (_state.Incremental ? MotionFlags.Incremental : MotionFlags.None)
        | (_state.AbsoluteCenters ? MotionFlags.AbsoluteCenter : MotionFlags.None)
        | _state.Compensation
        | (IsTransformed ? MotionFlags.Transformed : MotionFlags.None)
        | (_state.ModalRounding != 0 ? MotionFlags.CornerWord : MotionFlags.None)
        | (_state.Unsure != Unsure.None ? MotionFlags.UnsureMode : MotionFlags.None);

    // After a call or an unknown statement nothing is certain until it is stated again.
    private void Forget()
    {
        _state.Unsure = Unsure.All;
        _state.Unknown = AxisSet.All;
        _state.Cycle = NcMeaning.Unknown;
        ForgetOrigins();
    }

    private AxisSet GivenAxes() => AxesOf(_words.Present | _words.Computed);

    private static AxisSet AxesOf(uint letters) => (AxisSet)((letters >> 23) & 7);

    /// <summary>A word as a length in mm.</summary>
    private double Length(byte letter)
    {
        var value = _words.Value(letter);
        if (_dialect.IntegersAreIncrements && (_words.Integers & BlockWords.Bit(letter)) != 0)
        {
            value /= Math.Pow(10, LeastDecimals);
        }

        return _state.Inch ? Sum(0, value * MmPerInch) : value;
    }

    private double Length(char letter) => Length((byte)letter);

    /// <summary>A word as an angle in degrees; without a point it counts thousandths, or finer, where lengths do.</summary>
    private double Degrees(char letter) =>
        _words.Value(letter) / (_dialect.IntegersAreIncrements && (_words.Integers & BlockWords.Bit(letter)) != 0 ? Math.Pow(10, _dialect.MetricDecimals) : 1);

    private int LeastDecimals => _state.Inch ? _dialect.InchDecimals : _dialect.MetricDecimals;

    // Sums of increments, as exact as the control's: the double nearest to the decimal, ten digits behind the point.
    private static double Sum(double start, double increment) => Math.Round(start + increment, 10);

    private MotionFlags Problem(string code, string message, MotionFlags flag)
    {
        // Once, however often the block runs.
        var problem = new NcProblem(code, _block, message);
        if (_said.Add(problem))
        {
            _onlyCuts = false;
            _problems.Add(problem);
        }

        return flag;
    }
}
