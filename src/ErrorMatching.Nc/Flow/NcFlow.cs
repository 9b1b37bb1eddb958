using System.Globalization;
using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Executes the computing part of a program: determines the next block, and keeps variables and calls. Stops if a program would
/// never end, or if only the machine knows how it continues. A program without such statements does not need it.</summary>
/// <remarks>
/// Give a block for which <see cref="FlowTrigger"/> is true to <see cref="ExecuteStatements"/>. If that returns
/// <see cref="FlowAction.Words"/>, read its words (with <see cref="TryValue"/> for computed ones), apply them, and then call
/// <see cref="ExecuteCalls"/>. All other blocks run in sequence.
/// </remarks>
internal sealed class NcFlow
{
    private readonly NcProgram _program;
    private readonly NcDialect _dialect;
    private readonly NcSyntax _syntax;
    private readonly CallStack _calls;
    private readonly FlowReport _report;
    private readonly FlowMemory _memory;
    private readonly FlowCourse _course;
    private readonly FlowStructures _structures;
    private readonly IsoWords _words;
    private readonly IsoStatements _iso;
    private readonly SiemensStatements _siemens;
    private readonly LanguageFlow? _language;
    private readonly ModalCalls _modal;
    private readonly FlowSteering _steering;

    // The blocks before this one say nothing; null if nobody asked yet.
    private int? _headed;

    public NcFlow(NcProgram program, NcDialect dialect, FlowSettings? settings = null)
    {
        settings ??= new();
        (_program, _dialect, _syntax) = (program, dialect, dialect.Syntax);
        _calls = new(program, dialect);
        _report = new(_calls);
        _memory = new(_syntax, _report, dialect.Assumed, settings.Decide);
        _course = new(_syntax, _calls, _report, _memory, new(_syntax, _report, _memory), settings);

        var library = new FlowLibrary(dialect, settings);
        var alarms = new FlowAlarms(_syntax, _calls, _report, _memory);
        _structures = new(_syntax, _calls, _report, _memory, _course, alarms, new(_calls, _report, _memory, _course, library));
        _words = new(_syntax, _calls, _report, _memory, _course);
        _iso = new(_report, _memory, _course, alarms, _words);
        _modal = new(_calls, _report, _course, settings);
        var macros = new MacroCalls(dialect, _calls, _report, _memory, _course, library, _words, _modal);
        _steering = new(dialect, _report, _memory, _course, macros, _words, _modal);

        _language = LanguageFlow.Of(dialect, _calls, _report, _memory, _course, library, _modal, alarms);
        var arrays = new SiemensArrays(_report, _memory, _course);
        var assignments = new SiemensAssignments(_memory, arrays);
        var named = new SiemensCalls(dialect, _calls, _report, _memory, _course, library, assignments);
        _siemens = new(dialect, _course, _report, new(_calls, _report, _memory, _course, settings), arrays, named, assignments);
    }

    /// <summary>The file that contains <see cref="Next"/>: the program itself, or one of the library.</summary>
    public NcProgram Program => _calls.Program;

    /// <summary>The next block to execute.</summary>
    public int Next => _course.Next;

    /// <summary>Names of the programs that were called.</summary>
    public IReadOnlySet<string> Called => _calls.Called;

    /// <summary>Call depth of the current block; 0 in the main program.</summary>
    public int Depth => _calls.Depth;

    /// <summary>Why the program cannot continue; null if it can.</summary>
    public Refusal? Refusal => _report.Refusal;

    /// <summary>Notes on how the program ran.</summary>
    public IReadOnlyList<NcNote> Notes => _report.Notes;

    public NcVariables Variables => _memory.Variables;

    /// <summary>True while a macro is called after every motion: then give each block that moves to <see cref="ExecuteCalls"/>.</summary>
    public bool HasModalCall => _modal.AreActive;

    /// <summary>Start of the words of the block last given to <see cref="ExecuteStatements"/>, from the start of the block: behind its
    /// condition if it has one; otherwise 0.</summary>
    public int WordsFrom => _words.From;

    /// <summary>True if the block last given to <see cref="ExecuteCalls"/> had a flow word that was executed.</summary>
    public bool HasSteered => _steering.HasSteered;

    /// <summary>The block that runs first: 0, or the main program's first in an archive that begins with a subprogram.</summary>
    public int First
    {
        get
        {
            var text = _program.BlockCount == 0 ? default : _program.BytesOf(_program[0]);
            text = text[SyntaxBytes.MarkLength(text)..];
            if (_syntax == NcSyntax.Siemens && text.Length > 0 && text[0] == '%' && text.IndexOf("_MPF"u8) < 0)
            {
                _course.Begin(_calls.Unit.First);
            }

            return _course.Begun;
        }
    }

    /// <summary>A text for all that decides what runs next, but for variables: equal for equal places in runs of the same
    /// program.</summary>
    /// <param name="block">The block that runs next.</param>
    public string PlaceAt(int block)
    {
        _ = _calls.Frame;
        var text = new StringBuilder(FormattableString.Invariant($"{block} {_structures.IsBreaking}"));
        foreach (var frame in _calls.Frames)
        {
            text.Append(CultureInfo.InvariantCulture,
                $"|{frame.Unit.Name} {frame.First} {frame.Caller} {frame.Passes} {frame.ModalCalls}");
            foreach (var (loop, left) in frame.Counters.OrderBy(c => c.Key))
            {
                text.Append(CultureInfo.InvariantCulture, $" {loop}:{left}");
            }

            foreach (var region in frame.Regions)
            {
                text.Append(CultureInfo.InvariantCulture, $" {region.Owner}-{region.First}-{region.Last}-{region.Passes}");
            }
        }

        return text.ToString();
    }

    /// <summary>Executes what a block does before its words are read: assignments, conditions, jumps, and calls without other
    /// words.</summary>
    public FlowAction ExecuteStatements(int block)
    {
        if (Refusal is not null || _course.HasEnded)
        {
            return FlowAction.Stop;
        }

        if (_calls.Frames.Count > 0 && block >= _calls.Unit.End)
        {
            return _course.AtEnd(block);
        }

        _words.Begin();
        _course.Next = block + 1;
        var text = Program.BytesOf(Program[block]);
        var head = BlockHead.Read(text, _syntax);
        if (head.At >= text.Length && head.LabelLength == 0)
        {
            return FlowAction.Continue;
        }

        var depth = Depth;
        var action = _language is not null ? _language.Execute(block, text, head)
            : Heads(text, head.At) ? Heading(block, text, head.At)
            : MayBeStructure(text, head.At) && _calls.Unit.Index.StatementAt(block) is { } statement ? _structures.Execute(statement, text)
            : Statement(block, text, head);
        return BehindRegion(block, depth, action);
    }

    /// <summary>Executes what a block does after its words: the assignments of LinuxCNC, calls, returns and the end of the
    /// program.</summary>
    /// <param name="block">The block.</param>
    /// <param name="moved">True if its words moved an axis; a modal macro is then called.</param>
    public FlowAction ExecuteCalls(int block, bool moved = false)
    {
        if (Refusal is not null || _course.HasEnded)
        {
            return FlowAction.Stop;
        }

        _course.Next = block + 1;
        var depth = Depth;
        var action = _steering.ExecuteCalls(block, Program.BytesOf(Program[block]), moved);
        _words.End();
        return BehindRegion(block, depth, action);
    }

    /// <summary>Skips a block that is not executed.</summary>
    public FlowAction Skip(int block)
    {
        if (_calls.Frames.Count > 0 && block >= _calls.Unit.End)
        {
            return _course.AtEnd(block);
        }

        _course.Next = block + 1;
        return _course.BehindRegion(block);
    }

    /// <summary>Continues after a file's last block: in the calling program, or the run ends.</summary>
    public FlowAction AtEnd() => _course.AtEnd(Program.BlockCount);

    /// <summary>Computes the value of a word; in LinuxCNC, before the block's own assignments take effect.</summary>
    /// <param name="block">The block.</param>
    /// <param name="start">First byte of the value, from the start of the program; skips an equals sign before the value.</param>
    /// <param name="length">Number of bytes of the value; all must be used.</param>
    /// <param name="decimals">Decimals of the address's least increment, to which ROUND rounds in a Fanuc address; 0 if the address has
    /// none.</param>
    /// <param name="value">The value; vacant if the word counts as not written.</param>
    /// <returns>False if <see cref="Refusal"/> is set.</returns>
    public bool TryValue(int block, int start, int length, int decimals, out NcValue value)
    {
        var place = Program[block];
        var text = Program.Bytes.Span[place.Start..(start + length)];
        return _language?.TryValue(block, text, start - place.Start, out value)
            ?? _memory.TryValue(block, text, start - place.Start, decimals, out value);
    }

    /// <summary>Ends the run at a block with a reason.</summary>
    public FlowAction Refuse(string code, int block, string message) => _report.Refuse(code, block, message);

    /// <summary>Refuses a call that cannot be executed, or a block with two flow words.</summary>
    public FlowAction RefuseCall(int block, string word) => _report.RefuseCall(block, word);

    // If the block led nowhere else, a repeated section can end after it.
    private FlowAction BehindRegion(int block, int depth, FlowAction action) =>
        action == FlowAction.Continue && Depth == depth && Next == block + 1 ? _course.BehindRegion(block) : action;

    // A percent sign, or the number of a program.
    private bool Heads(ReadOnlySpan<byte> text, int at) =>
        at < text.Length && (text[at] == '%'
            || (_syntax == NcSyntax.Iso && BlockHead.ProgramAt(text, at).Name is not null));

    // The start of the next program ends the current one. If there is an index, it already limits the blocks to those of the program.
    private FlowAction Heading(int block, ReadOnlySpan<byte> head, int headAt)
    {
        if (_calls.Frames.Count == 0)
        {
            for (_headed ??= _syntax == NcSyntax.Iso ? Leader.BlocksOf(_program, _dialect) : 0; _headed < block; _headed++)
            {
                var text = _program.BytesOf(_program[_headed.Value]);
                var at = BlockHead.Read(text, _syntax).At;
                if (at < text.Length && text[at] != ';' && text[at] != '%')
                {
                    return _course.Ended();
                }
            }
        }

        // Statements after the number or name of a program are executed.
        return head[headAt] == '%' ? FlowAction.Continue : _iso.Execute(block, head, BlockHead.ProgramAt(head, headAt).End);
    }

    // Structures begin with a word of letters or with an O word.
    private bool MayBeStructure(ReadOnlySpan<byte> text, int at) =>
        at + 1 < text.Length && SyntaxBytes.IsLetter(text[at])
            && (SyntaxBytes.IsLetter(text[at + 1]) || (_syntax == NcSyntax.LinuxCnc && (text[at] | 0x20) == 'o'));

    private FlowAction Statement(int block, ReadOnlySpan<byte> text, BlockHead head) => _syntax switch
    {
        NcSyntax.Siemens => _siemens.Execute(block, text, head),
        NcSyntax.Iso => _iso.Execute(block, text, head.At),
        _ => _words.Assign(block, text, head.At),
    };
}
