namespace ErrorMatching.Nc;

/// <summary>
/// Executes what a program computes: decides which block runs next, keeps variables and calls, and stops where a program would never end or where only the
/// machine knows how it goes on. A program without such statements need not be given to it at all.
/// </summary>
/// <remarks>
/// A block that <see cref="FlowTrigger"/> names is given to <see cref="Before"/>; where that answers <see cref="FlowAction.Words"/>, its words are read (with
/// <see cref="TryValue"/> for computed ones) and acted on, and then <see cref="Behind"/> is called. Everything else runs from one block to the next.
/// </remarks>
internal sealed partial class NcFlow
{
    private const int SearchedPerStep = 8;

    private readonly FlowSettings _settings;
    private readonly NcDialect _dialect;
    private readonly NcSyntax _syntax;
    private readonly ExpressionSyntax _expressions;
    private readonly NcProgram _program;
    private readonly Stack<FlowFrame> _frames = new();
    private readonly Dictionary<string, FlowIndex?> _library = new(StringComparer.Ordinal);
    private readonly Dictionary<(FlowIndex, int), long> _jumps = [];
    private readonly List<(VariablePlace Place, NcValue Value)> _pending = [];
    private readonly List<NcNote> _notes = [];
    private readonly List<ModalCall> _modalCalls = [];
    private long _changes;
    private long _steps;
    private int _resumed;
    private bool _hasEnded;
    private bool _breaking;

    public NcFlow(NcProgram program, NcDialect dialect, FlowSettings? settings = null)
    {
        _program = program;
        _dialect = dialect;
        _syntax = dialect.Syntax;
        _settings = settings ?? new();
        _expressions = ExpressionSyntax.Of(_syntax);
        Variables = new(_syntax);
    }

    /// <summary>The file in which <see cref="Next"/> stands: the program itself, or one of the library.</summary>
    public NcProgram Program => _frames.Count == 0 ? _program : Unit.Index.Program;

    /// <summary>The block to be executed next.</summary>
    public int Next { get; private set; }

    /// <summary>How many calls the present block is inside of; 0 in the main program.</summary>
    public int Depth => Math.Max(0, _frames.Count - 1);

    /// <summary>Why the program cannot go on; null where it can.</summary>
    public NcRefusal? Refusal { get; private set; }

    /// <summary>What is worth knowing of how the program ran.</summary>
    public IReadOnlyList<NcNote> Notes => _notes;

    public NcVariables Variables { get; }

    /// <summary>True while a macro is called behind every motion: then each block that moves is given to <see cref="Behind"/>.</summary>
    public bool HasModalCall => _frames.Count > 0 && Math.Min(Frame.ModalCalls, _modalCalls.Count) > 0;

    // Files are indexed only when a statement needs it: a straight program with M30 at its end never is.
    private FlowFrame Frame
    {
        get
        {
            if (_frames.Count == 0)
            {
                var main = new FlowIndex(_program, _dialect).Main;
                _frames.Push(new() { Unit = main, First = main.First });
            }

            return _frames.Peek();
        }
    }

    private FlowUnit Unit => Frame.Unit;

    /// <summary>The block that runs first: 0, or the main program's first in an archive that begins with a subprogram.</summary>
    public int First
    {
        get
        {
            var text = _program.BlockCount == 0 ? default : _program.BytesOf(_program[0]);
            text = text[SyntaxBytes.MarkLength(text)..];
            if (_syntax == NcSyntax.Siemens && text.Length > 0 && text[0] == '%' && text.IndexOf("_MPF"u8) < 0)
            {
                _resumed = Unit.First;
            }

            return _resumed;
        }
    }

    /// <summary>Executes what a block does before its words are read: assignments, conditions, jumps, and calls that stand alone.</summary>
    public FlowAction Before(int block)
    {
        if (Refusal is not null || _hasEnded)
        {
            return FlowAction.Stop;
        }

        if (_frames.Count > 0 && block >= Unit.End)
        {
            return AtEnd(block);
        }

        _pending.Clear();
        _scanned = -1;
        Next = block + 1;
        var text = Program.BytesOf(Program[block]);
        var head = BlockHead.Read(text, _syntax);
        if (head.At >= text.Length && head.LabelLength == 0)
        {
            return FlowAction.Continue;
        }

        var depth = Depth;
        var action = Heads(text, head.At) ? Heading(block, text, head.At)
            : MayBeStructure(text, head.At) && Unit.Index.StatementAt(block) is { } statement ? Execute(statement, text)
            : Statement(block, text, head);
        return action == FlowAction.Continue && Depth == depth && Next == block + 1 ? BehindRegion(block) : action;
    }

    /// <summary>Executes what a block does behind its words: the assignments of LinuxCNC, calls, returns and the end of the program.</summary>
    /// <param name="block">The block.</param>
    /// <param name="moved">True if its words moved an axis; a modal macro is then called.</param>
    public FlowAction Behind(int block, bool moved = false)
    {
        if (Refusal is not null || _hasEnded)
        {
            return FlowAction.Stop;
        }

        Next = block + 1;
        HasSteered = false;
        var text = Program.BytesOf(Program[block]);
        var depth = Depth;
        var action = _syntax == NcSyntax.Siemens ? BehindSiemens(block, text) : BehindIso(block, text, moved);
        _scanned = -1;
        return action == FlowAction.Continue && Depth == depth && Next == block + 1 ? BehindRegion(block) : action;
    }

    /// <summary>Goes on where a file's last block has been executed: in the calling program, or nowhere.</summary>
    public FlowAction AtEnd() => AtEnd(Program.BlockCount);

    /// <summary>Computes the value of a word, as it is before the block's own assignments take effect in LinuxCNC.</summary>
    /// <param name="block">The block.</param>
    /// <param name="start">First byte of the value, counted from the start of the program; an equals sign before it is passed over.</param>
    /// <param name="length">Number of bytes of the value; it must be used up.</param>
    /// <param name="decimals">Decimals of the address's least increment, to which ROUND rounds in a Fanuc address; 0 where the address has none.</param>
    /// <param name="value">The value; vacant where the word is as if not written.</param>
    /// <returns>False where <see cref="Refusal"/> says what is wrong.</returns>
    public bool TryValue(int block, int start, int length, int decimals, out NcValue value)
    {
        var place = Program[block];
        var text = Program.Bytes.Span[place.Start..(start + length)];
        var reader = new ExpressionReader(text, start - place.Start, _expressions, Variables) { RoundDecimals = _syntax == NcSyntax.Iso ? decimals : 0 };
        reader.Take((byte)'=');
        value = _syntax == NcSyntax.Siemens ? reader.Expression() : reader.Operand();
        reader.SkipSpaces();
        if (reader.Error is null && reader.At < text.Length)
        {
            reader.Fail("the value should end here");
        }

        return Check(ref reader, block);
    }

    private FlowAction AtEnd(int block)
    {
        if (_frames.Count <= 1)
        {
            return Ended();
        }

        if (_syntax == NcSyntax.Iso)
        {
            Note("no-return", Math.Min(block, Program.BlockCount) - 1, "The subprogram ends without M99; it is taken to return here.");
        }

        return Return(block - 1);
    }

    private FlowAction Ended()
    {
        _hasEnded = true;
        return FlowAction.Stop;
    }

    // A percent sign, or the number of a program.
    private bool Heads(ReadOnlySpan<byte> text, int at) =>
        at < text.Length && (text[at] == '%' || (_syntax == NcSyntax.Iso && (text[at] | 0x20) == 'o' && BlockHead.NumberAt(text, at + 1).Length > 0));

    // The beginning of the next program is the end of the one that runs. What an index knows is not asked here: behind its end no block is met.
    private FlowAction Heading(int block, ReadOnlySpan<byte> head, int headAt)
    {
        var first = _frames.Count == 0 && _syntax == NcSyntax.Iso ? Leader.BlocksOf(_program, _dialect) : 0;
        for (var i = block - 1; _frames.Count == 0 && i >= first; i--)
        {
            var text = _program.BytesOf(_program[i]);
            var at = BlockHead.Read(text, _syntax).At;
            if (at < text.Length && text[at] != ';' && text[at] != '%')
            {
                return Ended();
            }
        }

        // What stands behind the number of a program is executed.
        var number = BlockHead.NumberAt(head, headAt + 1);
        return head[headAt] == '%' ? FlowAction.Continue : Macro(block, head, number.Start + number.Length);
    }

    // Structures begin with a word of letters, or with an O word.
    private bool MayBeStructure(ReadOnlySpan<byte> text, int at) =>
        at + 1 < text.Length && SyntaxBytes.IsLetter(text[at]) && (SyntaxBytes.IsLetter(text[at + 1]) || (_syntax == NcSyntax.LinuxCnc && (text[at] | 0x20) == 'o'));

    private FlowAction Statement(int block, ReadOnlySpan<byte> text, BlockHead head) => _syntax switch
    {
        NcSyntax.Siemens => Siemens(block, text, head),
        NcSyntax.Iso => Macro(block, text, head.At),
        _ => Assign(block, text, head.At),
    };

    private ExpressionReader ReaderAt(ReadOnlySpan<byte> text, int at) => new(text, at, _expressions, Variables);

    // True where nothing is wrong; else the refusal is set.
    private bool Check(ref ExpressionReader reader, int block)
    {
        if (reader.Error is not null)
        {
            Refuse(NcRefusalCodes.BadExpression, block, FormattableString.Invariant($"column {reader.ErrorAt + 1}: {reader.Error}."));
        }

        return Refusal is null;
    }

    /// <summary>Ends the run at a block for a reason.</summary>
    public FlowAction Refuse(string code, int block, string message)
    {
        var main = InProgram(block);
        if (ReferenceEquals(Program, _program))
        {
            Refusal ??= _program.BlockCount == 0 ? new(code, "", 0, message) : NcRefusal.At(_program, Math.Clamp(main, 0, _program.BlockCount - 1), code, message);
        }
        else
        {
            // The file that the setter named has the block that calls; the message says where in the other one.
            var name = Unit.Name.Length > 0 ? Unit.Name : "the called program";
            var where = Program.BlockCount == 0 ? "" : $", {Program.NameOf(Program[Math.Clamp(block, 0, Program.BlockCount - 1)])}";
            Refusal ??= NcRefusal.At(_program, main, code, $"in {name}{where}: {message}");
        }

        return FlowAction.Stop;
    }

    private void Note(string code, int block, string message)
    {
        block = InProgram(block);
        if (!_notes.Exists(n => n.Code == code && n.Block == block))
        {
            _notes.Add(new(code, block, 1, message));
        }
    }

    // A block of a program in another file stands for the block of this one that called it.
    private int InProgram(int block)
    {
        foreach (var frame in _frames)
        {
            block = ReferenceEquals(frame.Unit.Index.Program, _program) ? block : frame.Caller;
        }

        return block;
    }

    private FlowAction Assigned(int block, VariablePlace place, NcValue value, int column)
    {
        var error = Variables.Write(place, value);
        return error is null ? FlowAction.Continue : Refuse(NcRefusalCodes.BadExpression, block, FormattableString.Invariant($"column {column + 1}: {error}."));
    }
}
