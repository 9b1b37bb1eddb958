namespace ErrorMatching.Nc;

/// <summary>
/// Reads a program as its control would and yields the motions. What it does not understand makes the state unknown until the program
/// states it again, so that nothing is ever guessed silently.
/// </summary>
public sealed partial class NcInterpreter
{
    private const double MmPerInch = 25.4;
    private const int CallCode = -2;

    private readonly NcProgram program;
    private readonly NcDialect dialect;
    private readonly BlockWords words = new();
    private readonly List<NcProblem> problems = [];
    private readonly List<int> placeDependents = [];
    private readonly uint otherAxes;
    private readonly uint unknownLetters;
    private NcMotion[] motions;
    private int count;
    private int flowBlock = -1;
    private ModalState state = ModalState.Initial;

    private NcInterpreter(NcProgram program, NcDialect dialect)
    {
        this.program = program;
        this.dialect = dialect;
        motions = new NcMotion[Math.Max(16, program.BlockCount)];
        for (var letter = 'A'; letter <= 'Z'; letter++)
        {
            var role = dialect.RoleOf((byte)letter);
            otherAxes |= role == LetterRole.OtherAxis ? BlockWords.Bit(letter) : 0;
            unknownLetters |= role == LetterRole.Unknown ? BlockWords.Bit(letter) : 0;
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

        return new(program, dialect, interpreter.motions, interpreter.count, interpreter.problems, interpreter.placeDependents, interpreter.flowBlock);
    }

    // Returns false where the program ends.
    private bool Step(NcBlock block)
    {
        words.Read(program, block);
        var flags = ReadObstacles(block);
        var (use, code) = ReadCodes();
        var called = false;
        var goesOn = true;
        foreach (var function in words.Functions)
        {
            called |= dialect.CallFunctions.Contains(function);
            goesOn &= function is not (2 or 30 or 99);
        }

        if (words.Has('F'))
        {
            state.Feed = words.Value('F') * (state.Inch ? MmPerInch : 1);
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
                placeDependents.Add(block.Index);
                SetOrigin(code);
                break;
        }

        if (called || code == CallCode)
        {
            placeDependents.Add(block.Index);
            Forget();
        }

        return goesOn;
    }

    private MotionFlags ReadObstacles(NcBlock block)
    {
        var flags = MotionFlags.None;
        foreach (var keyword in words.Keywords)
        {
            var word = NcText.Decode(program.Bytes.Span.Slice(keyword.Start, keyword.Length)).ToUpperInvariant();
            var name = new string(word.TakeWhile(char.IsAsciiLetter).ToArray());
            if (dialect.FlowKeywords.Contains(name))
            {
                flowBlock = flowBlock < 0 ? block.Index : flowBlock;
            }
            else
            {
                flags |= Unknown(block, word);
            }

            Forget();
        }

        if (words.Invalid.Length > 0)
        {
            flags |= Unknown(block, NcText.Decode(program.Bytes.Span.Slice(words.Invalid.Start, words.Invalid.Length)));
            state.Unsure = Unsure.All;
        }

        var strange = (words.Present | words.Computed) & unknownLetters;
        for (var letter = 'A'; strange != 0 && letter <= 'Z'; letter++)
        {
            if ((strange & BlockWords.Bit(letter)) != 0)
            {
                flags |= Unknown(block, letter.ToString());
            }
        }

        if ((words.Computed & (BlockWords.Bit('G') | BlockWords.Bit('M'))) != 0)
        {
            Forget();
        }

        if (words.AssignsSystemVariable)
        {
            state.Frame++;
            state.Unknown = AxisSet.All;
            placeDependents.Add(block.Index);
        }

        const uint Geometry = (1u << 23) | (1u << 24) | (1u << 25) | (1u << 8) | (1u << 9) | (1u << 10) | (1u << 17);
        if ((words.Repeated & Geometry) != 0)
        {
            problems.Add(new("repeated-word", block.Index, "A coordinate stands twice in the block; which one counts depends on the control."));
            flags |= MotionFlags.UnknownWord;
        }

        flags |= (words.Computed & Geometry) != 0 ? MotionFlags.Expression : MotionFlags.None;
        flags |= words.HasCornerWord ? MotionFlags.CornerWord : MotionFlags.None;
        return flags | (((words.Present | words.Computed) & otherAxes) != 0 ? MotionFlags.OtherAxis : MotionFlags.None);
    }

    private MotionFlags Unknown(NcBlock block, string what)
    {
        problems.Add(new("unknown-word", block.Index, $"\"{what}\" is not known to the dialect {dialect.Name}."));
        return MotionFlags.UnknownWord;
    }

    // After a call or an unknown statement nothing is certain until it is stated again.
    private void Forget()
    {
        state.Unsure = Unsure.All;
        state.Unknown = AxisSet.All;
        state.CycleActive = false;
    }

    private bool MovesAxes()
    {
        const uint Linear = (1u << 23) | (1u << 24) | (1u << 25);
        const uint Arc = (1u << 8) | (1u << 9) | (1u << 10);
        var given = words.Present | words.Computed;
        var arc = state.Mode is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise && !state.CycleActive;
        return (given & (Linear | otherAxes)) != 0 || (arc && (given & Arc) != 0);
    }

    private void Append(in NcMotion motion)
    {
        if (count == motions.Length)
        {
            Array.Resize(ref motions, motions.Length * 2);
        }

        motions[count++] = motion with { Start = motion.UnknownStart.KnownPartOf(motion.Start), End = motion.UnknownEnd.KnownPartOf(motion.End) };
        state.Position = motion.End;
        state.Unknown = motion.UnknownEnd;
    }

    private void AddReference(NcBlock block, MotionFlags flags)
    {
        var named = GivenAxes();
        named = named == AxisSet.None ? AxisSet.All : named;
        Append(new(block.Index, MotionKind.Reference, state.Plane, flags | ModeFlags(), state.Position, state.Position, default, 0, state.Feed, state.Frame, state.Unknown, state.Unknown | named));
    }

    private void SetOrigin(int code)
    {
        state.Frame++;
        if (code == 920)
        {
            state.Position = new(words.Has('X') ? Scaled('X') : state.Position.X, words.Has('Y') ? Scaled('Y') : state.Position.Y, words.Has('Z') ? Scaled('Z') : state.Position.Z);
            state.Unknown &= ~GivenAxes();
        }
        else
        {
            state.Unknown = AxisSet.All;
        }
    }

    private AxisSet GivenAxes()
    {
        var given = words.Present | words.Computed;
        return ((given & BlockWords.Bit('X')) != 0 ? AxisSet.X : AxisSet.None) | ((given & BlockWords.Bit('Y')) != 0 ? AxisSet.Y : AxisSet.None) | ((given & BlockWords.Bit('Z')) != 0 ? AxisSet.Z : AxisSet.None);
    }

    private double Scaled(char letter) => state.Inch ? Sum(0, words.Value(letter) * MmPerInch) : words.Value(letter);

    // Sums of increments, as exact as the control's: the double nearest to the decimal, ten digits behind the point.
    private static double Sum(double start, double increment) => Math.Round(start + increment, 10);
}
