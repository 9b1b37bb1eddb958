namespace ErrorMatching.Nc;

/// <summary>Blocks of ISO controls and LinuxCNC: assignments, and words that affect calls.</summary>
internal sealed class IsoWords(NcSyntax syntax, CallStack calls, FlowReport report, FlowMemory memory, FlowCourse course)
{
    /// <summary>The variable that raises an alarm.</summary>
    public const int AlarmVariable = 3000;

    private readonly List<(byte Letter, NcValue Value)> _words = [];
    private readonly List<(VariablePlace Place, NcValue Value)> _pending = [];
    private int _scanned = -1;

    // No block before this one has a word of an axis.
    private int _still;

    /// <summary>The words of the block with their values, in order; letter 0 is a word of several letters.</summary>
    public List<(byte Letter, NcValue Value)> Collected => _words;

    /// <summary>The name in angle brackets among the words, in capitals; null if there is none.</summary>
    public string? ProgramName { get; private set; }

    /// <summary>Start of the block's words, from the start of the block: behind its condition if it has one; otherwise 0.</summary>
    public int From { get; private set; }

    /// <summary>Begins a block.</summary>
    public void Begin()
    {
        _pending.Clear();
        _scanned = -1;
        From = 0;
    }

    /// <summary>Ends a block: its words are read again the next time it runs.</summary>
    public void End() => _scanned = -1;

    /// <summary>Makes LinuxCNC's assignments after the words of a block; false if there is a refusal.</summary>
    public bool TryFinish(int block, ReadOnlySpan<byte> text)
    {
        if (_scanned != block && Assign(block, text, BlockHead.Read(text, syntax).At) == FlowAction.Stop)
        {
            return false;
        }

        foreach (var (place, value) in _pending)
        {
            if (memory.Assigned(block, place, value, 0) == FlowAction.Stop)
            {
                return false;
            }
        }

        _pending.Clear();
        return true;
    }

    /// <summary>Makes the assignments of a block (LinuxCNC: stores them until its words are read) and collects its words with their
    /// values.</summary>
    public FlowAction Assign(int block, ReadOnlySpan<byte> text, int at)
    {
        _words.Clear();
        ProgramName = null;
        _scanned = block;
        var reader = memory.ReaderAt(text, at);
        for (reader.SkipSpaces(); reader.Error is null && reader.At < text.Length; reader.SkipSpaces())
        {
            var c = text[reader.At];
            if (c == ';')
            {
                break;
            }

            if (c == '(')
            {
                var length = text[reader.At..].IndexOf((byte)')');
                reader.At = length < 0 ? text.Length : reader.At + length + 1;
            }
            else if (syntax == NcSyntax.Iso && BlockHead.BracketedName(text, reader.At) is { Name: { } name, End: var end })
            {
                (ProgramName, reader.At) = (name, end);
            }
            else if (c == '$' && syntax == NcSyntax.LinuxCnc)
            {
                reader.At++;
                reader.Operand();
            }
            else if (c == '#')
            {
                if (AssignOne(block, ref reader) == FlowAction.Stop)
                {
                    return FlowAction.Stop;
                }
            }
            else if (SyntaxBytes.IsLetter(c) || (c is (byte)'@' or (byte)'^' && syntax == NcSyntax.LinuxCnc))
            {
                ReadWord(text, ref reader);
            }
            else
            {
                reader.At++;
            }
        }

        return !memory.Check(ref reader, block)
            ? FlowAction.Stop
            : _words.Count > 0 || _pending.Count > 0
            ? FlowAction.Words
            : FlowAction.Continue;
    }

    /// <summary>The same for the words behind a condition.</summary>
    public FlowAction AssignBehind(int block, ReadOnlySpan<byte> text, int at)
    {
        From = at;
        return Assign(block, text, at);
    }

    private FlowAction AssignOne(int block, ref ExpressionReader reader)
    {
        var column = reader.At;
        var place = reader.Place();
        if (!reader.Take((byte)'='))
        {
            reader.Fail("\"=\" is expected here");
        }

        var value = reader.Expression();
        reader.SkipSpaces();
        if (syntax == NcSyntax.Iso && reader.Error is null && SyntaxBytes.IsLetter(reader.Text.Peek()))
        {
            // Controls raise an alarm or pass over it; the words would be lost.
            reader.Fail("a word stands behind an assignment; begin a block for it");
        }

        if (!memory.Check(ref reader, block))
        {
            return FlowAction.Stop;
        }

        if (syntax == NcSyntax.LinuxCnc)
        {
            _pending.Add((place, value));
            return FlowAction.Continue;
        }

        if (place is { Kind: VariableKind.Numbered, Number: AlarmVariable } && !value.IsVacant && value.Number != 0)
        {
            if (IsLock(block))
            {
                const string locked = "The program raises an alarm here (#3000) before it moves, until this block is taken out. What is "
                    + "shown is what it does then.";
                report.Note("program-alarm", block, locked);
                return FlowAction.Continue;
            }

            report.Note("program-alarm", block, "The program raises an alarm here (#3000) and ends.");
            return course.Ended();
        }

        memory.HasComputed = true;
        return memory.Assigned(block, place, value, column);
    }

    // A guard depends on something before it. An alarm that nothing leads to, not even a motion, is a lock: it is removed once the
    // program is complete.
    private bool IsLock(int block)
    {
        if (calls.Depth > 0 || course.HasJumped || memory.HasComputed)
        {
            return false;
        }

        for (; _still < block && !HasAxisWord(_still); _still++)
        {
        }

        return _still >= block;
    }

    private bool HasAxisWord(int block)
    {
        foreach (var token in calls.Program.Tokens(calls.Program[block]))
        {
            if (token.Kind == NcTokenKind.Word && token.Letter is (>= (byte)'U' and <= (byte)'Z') or (>= (byte)'A' and <= (byte)'C'))
            {
                return true;
            }
        }

        return false;
    }

    private void ReadWord(ReadOnlySpan<byte> text, ref ExpressionReader reader)
    {
        var letter = (byte)(text[reader.At++] & ~0x20);
        reader.SkipSpaces();
        var name = BlockHead.NameLength(text, reader.At);
        var next = reader.At < text.Length ? text[reader.At] : (byte)0;
        if (name == 0 && next is (byte)'#' or (byte)'[' or (byte)'-' or (byte)'+' or (byte)'.' or (>= (byte)'0' and <= (byte)'9'))
        {
            _words.Add((letter, reader.Operand()));
        }
        else if (name > 1 && syntax == NcSyntax.LinuxCnc)
        {
            _words.Add((letter, reader.Operand()));
        }
        else
        {
            // A word of several letters that is not a flow statement: the interpreter handles it.
            _words.Add((0, NcValue.Vacant));
            reader.At = name > 0 ? text.Length : reader.At;
        }
    }
}
