namespace ErrorMatching.Nc;

/// <summary>
/// Reads a program as its control would and yields the motions. What it does not understand makes the state unknown until the program
/// states it again, so that nothing is ever guessed silently.
/// </summary>
public sealed partial class NcInterpreter
{
    private const double MmPerInch = 25.4;
    private const int CallCode = -2;

    private readonly NcProgram _program;
    private readonly NcDialect _dialect;
    private readonly BlockWords _words = new();
    private readonly List<NcProblem> _problems = [];
    private readonly List<int> _placeDependents = [];
    private readonly uint _otherAxes;
    private readonly uint _unknownLetters;
    private NcMotion[] _motions;
    private int _count;
    private int _flowBlock = -1;
    private ModalState _state = ModalState.Initial;

    private NcInterpreter(NcProgram program, NcDialect dialect)
    {
        _program = program;
        _dialect = dialect;
        _motions = new NcMotion[Math.Max(16, program.BlockCount)];
        for (var letter = 'A'; letter <= 'Z'; letter++)
        {
            var role = dialect.RoleOf((byte)letter);
            _otherAxes |= role == LetterRole.OtherAxis ? BlockWords.Bit(letter) : 0;
            _unknownLetters |= role == LetterRole.Unknown ? BlockWords.Bit(letter) : 0;
        }
    }

    private enum AxisUse
    {
        Motion,
        Nothing,
        SetOrigin,
        Reference,
        MachineCoordinates,
    }

    /// <summary>Interprets a program.</summary>
    public static NcPath Run(NcProgram program, NcDialect dialect)
    {
        var interpreter = new NcInterpreter(program, dialect);
        for (var i = 0; i < program.BlockCount && interpreter.Step(program[i]); i++)
        {
        }

        return new(program, dialect, interpreter._motions, interpreter._count, interpreter._problems, interpreter._placeDependents, interpreter._flowBlock);
    }

    // Returns false where the program ends.
    private bool Step(NcBlock block)
    {
        _words.Read(_program, block);
        var flags = ReadObstacles(block);
        var (use, code) = ReadCodes();
        var called = false;
        var goesOn = true;
        foreach (var function in _words.Functions)
        {
            called |= _dialect.CallFunctions.Contains(function);
            goesOn &= function is not (2 or 30 or 99);
        }

        if (_words.Has('F'))
        {
            _state.Feed = _words.Value('F') * (_state.Inch ? MmPerInch : 1);
        }

        switch (use)
        {
            case AxisUse.Motion or AxisUse.MachineCoordinates when MovesAxes():
                AddMotion(block, flags, use == AxisUse.MachineCoordinates);
                break;
            case AxisUse.Reference:
                AddReference(block, flags);
                break;
            case AxisUse.SetOrigin:
                _placeDependents.Add(block.Index);
                SetOrigin(code);
                break;
        }

        if (called || code == CallCode)
        {
            _placeDependents.Add(block.Index);
            Forget();
        }

        return goesOn;
    }

    private MotionFlags ReadObstacles(NcBlock block)
    {
        var flags = MotionFlags.None;
        foreach (var keyword in _words.Keywords)
        {
            var word = NcText.Decode(_program.Bytes.Span.Slice(keyword.Start, keyword.Length)).ToUpperInvariant();
            var name = new string(word.TakeWhile(char.IsAsciiLetter).ToArray());
            if (_dialect.FlowKeywords.Contains(name))
            {
                _flowBlock = _flowBlock < 0 ? block.Index : _flowBlock;
            }
            else
            {
                flags |= Unknown(block, word);
            }

            Forget();
        }

        if (_words.Invalid.Length > 0)
        {
            flags |= Unknown(block, NcText.Decode(_program.Bytes.Span.Slice(_words.Invalid.Start, _words.Invalid.Length)));
            _state.Unsure = Unsure.All;
        }

        var strange = (_words.Present | _words.Computed) & _unknownLetters;
        for (var letter = 'A'; strange != 0 && letter <= 'Z'; letter++)
        {
            if ((strange & BlockWords.Bit(letter)) != 0)
            {
                flags |= Unknown(block, letter.ToString());
            }
        }

        if ((_words.Computed & (BlockWords.Bit('G') | BlockWords.Bit('M'))) != 0)
        {
            Forget();
        }

        if (_words.AssignsSystemVariable)
        {
            _state.Frame++;
            _state.Unknown = AxisSet.All;
            _placeDependents.Add(block.Index);
        }

        const uint Geometry = (1u << 23) | (1u << 24) | (1u << 25) | (1u << 8) | (1u << 9) | (1u << 10) | (1u << 17);
        if ((_words.Repeated & Geometry) != 0)
        {
            _problems.Add(new("repeated-word", block.Index, "A coordinate stands twice in the block; which one counts depends on the control."));
            flags |= MotionFlags.UnknownWord;
        }

        flags |= (_words.Computed & Geometry) != 0 ? MotionFlags.Expression : MotionFlags.None;
        flags |= _words.HasCornerWord ? MotionFlags.CornerWord : MotionFlags.None;
        return flags | (((_words.Present | _words.Computed) & _otherAxes) != 0 ? MotionFlags.OtherAxis : MotionFlags.None);
    }

    private MotionFlags Unknown(NcBlock block, string what)
    {
        _problems.Add(new("unknown-word", block.Index, $"\"{what}\" is not known to the dialect {_dialect.Name}."));
        return MotionFlags.UnknownWord;
    }

    // After a call or an unknown statement nothing is certain until it is stated again.
    private void Forget()
    {
        _state.Unsure = Unsure.All;
        _state.Unknown = AxisSet.All;
        _state.CycleActive = false;
    }

    private bool MovesAxes()
    {
        const uint Linear = (1u << 23) | (1u << 24) | (1u << 25);
        const uint Arc = (1u << 8) | (1u << 9) | (1u << 10);
        var given = _words.Present | _words.Computed;
        var arc = _state.Mode is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise && !_state.CycleActive;
        return (given & (Linear | _otherAxes)) != 0 || (arc && (given & Arc) != 0);
    }

    private void Append(in NcMotion motion)
    {
        if (_count == _motions.Length)
        {
            Array.Resize(ref _motions, _motions.Length * 2);
        }

        _motions[_count++] = motion with { Start = motion.UnknownStart.KnownPartOf(motion.Start), End = motion.UnknownEnd.KnownPartOf(motion.End) };
        _state.Position = motion.End;
        _state.Unknown = motion.UnknownEnd;
    }

    private void AddReference(NcBlock block, MotionFlags flags)
    {
        var named = GivenAxes();
        named = named == AxisSet.None ? AxisSet.All : named;
        Append(new(block.Index, MotionKind.Reference, _state.Plane, flags | ModeFlags(), _state.Position, _state.Position, default, 0, _state.Feed, _state.Frame, _state.Unknown, _state.Unknown | named));
    }

    private void SetOrigin(int code)
    {
        _state.Frame++;
        if (code == 920)
        {
            _state.Position = new(_words.Has('X') ? Scaled('X') : _state.Position.X, _words.Has('Y') ? Scaled('Y') : _state.Position.Y, _words.Has('Z') ? Scaled('Z') : _state.Position.Z);
            _state.Unknown &= ~GivenAxes();
        }
        else
        {
            _state.Unknown = AxisSet.All;
        }
    }

    private AxisSet GivenAxes()
    {
        var given = _words.Present | _words.Computed;
        return ((given & BlockWords.Bit('X')) != 0 ? AxisSet.X : AxisSet.None) | ((given & BlockWords.Bit('Y')) != 0 ? AxisSet.Y : AxisSet.None) | ((given & BlockWords.Bit('Z')) != 0 ? AxisSet.Z : AxisSet.None);
    }

    private double Scaled(char letter) => _state.Inch ? Sum(0, _words.Value(letter) * MmPerInch) : _words.Value(letter);

    // Sums of increments, as exact as the control's: the double nearest to the decimal, ten digits behind the point.
    private static double Sum(double start, double increment) => Math.Round(start + increment, 10);
}
