using System.Text;

namespace ErrorMatching.Nc;

/// <summary>Siemens calls by name.</summary>
internal sealed class SiemensCalls(
    NcDialect dialect,
    CallStack calls,
    FlowReport report,
    FlowMemory memory,
    FlowCourse course,
    FlowLibrary library,
    SiemensAssignments assignments)
{
    private readonly HashSet<string> _external = new(StringComparer.Ordinal);

    public FlowAction DeclareExternal(ReadOnlySpan<byte> text, int at)
    {
        var reader = memory.ReaderAt(text, at);
        _external.Add(FlowIndex.PlainName(FlowMemory.Word(ref reader, text)));
        return FlowAction.Continue;
    }

    /// <summary>A name alone or with arguments: at least two letters, or L with a number.</summary>
    public static bool IsCall(ReadOnlySpan<byte> text, int at, int length)
    {
        if (length < 2 || (SyntaxBytes.IsDigit(text[at + 1]) && (text[at] | 0x20) != 'l'))
        {
            return false;
        }

        var behind = at + length;
        while (behind < text.Length && text[behind] is (byte)' ' or (byte)'\t')
        {
            behind++;
        }

        return behind >= text.Length || text[behind] is (byte)'(' or (byte)';' or (byte)'P' or (byte)'p';
    }

    public FlowAction CallText(int block, ReadOnlySpan<byte> text, int at)
    {
        var reader = memory.ReaderAt(text, at);
        var value = reader.Expression();
        if (!memory.Check(ref reader, block))
        {
            return FlowAction.Stop;
        }

        return value.Kind == NcValueKind.Text
            ? CallProgram(block, text, reader.At, FlowIndex.PlainName(value.Text!), mustExist: true)
            : report.Refuse(NcRefusalCodes.UnknownCondition, block, "which program is called is a value that only the machine knows.");
    }

    public FlowAction CallNamed(int block, ReadOnlySpan<byte> text, int at, int length)
    {
        var name = FlowIndex.PlainName(NcText.Decode(text.Slice(at, length)));
        var mustExist = _external.Contains(name) || ((text[at] | 0x20) == 'l' && BlockHead.NumberAt(text, at + 1).Length == length - 1);
        return CallProgram(block, text, at + length, name, mustExist);
    }

    private FlowAction CallProgram(int block, ReadOnlySpan<byte> text, int at, string name, bool mustExist)
    {
        var unit = calls.Unit.Index.Unit(name);
        if (unit is null && !mustExist && IsWord(name))
        {
            return WordsOf(block, text, at);
        }

        unit ??= library.Find(name) is { } index ? index.Unit(name) ?? index.Main : null;
        if (unit is null)
        {
            return mustExist ? report.Missing(block, name) : WordsOf(block, text, at);
        }

        var reader = memory.ReaderAt(text, at);
        var values = new List<(NcValue Value, VariablePlace? Place)>();
        if (reader.Take((byte)'('))
        {
            ReadArguments(ref reader, text, values);
        }

        if (!memory.TryPasses(block, ref reader, out var passes))
        {
            return FlowAction.Stop;
        }

        reader.SkipSpaces();
        if (reader.At < text.Length && text[reader.At] != ';')
        {
            reader.Fail("the call should end here");
            memory.Check(ref reader, block);
            return FlowAction.Stop;
        }

        if (passes <= 0)
        {
            return FlowAction.Continue;
        }

        return course.Enter(new()
        {
            Unit = unit,
            First = unit.First,
            Caller = block,
            Passes = passes,
            Arguments = [],
            Parameters = values,
        });
    }

    private FlowAction WordsOf(int block, ReadOnlySpan<byte> text, int at) =>
        assignments.Assign(block, text, at) == FlowAction.Stop ? FlowAction.Stop : FlowAction.Words;

    private void ReadArguments(ref ExpressionReader reader, ReadOnlySpan<byte> text, List<(NcValue, VariablePlace?)> values)
    {
        while (reader.Error is null && !reader.Take((byte)')'))
        {
            reader.SkipSpaces();
            if (reader.At < text.Length && text[reader.At] == ',')
            {
                reader.At++;
                values.Add((NcValue.Vacant, null));
                continue;
            }

            // A parameter by reference needs the variable itself: an argument that is only a variable.
            var start = reader.At;
            var length = BlockHead.NameLength(text, start);
            VariablePlace? place = null;
            if (length > 0 && memory.IsVariable(text, start, length))
            {
                place = reader.Place();
                reader.SkipSpaces();
                place = reader.At < text.Length && text[reader.At] is (byte)',' or (byte)')' ? place : null;
                reader.At = start;
            }

            values.Add((reader.Expression(), place));
            reader.SkipSpaces();
            if (reader.At < text.Length && text[reader.At] == ',')
            {
                reader.At++;
            }
            else if (reader.At >= text.Length || text[reader.At] != ')')
            {
                reader.Fail("a bracket is not closed: \")\" is expected here");
            }
        }
    }

    // A word of the control itself, not a program.
    private bool IsWord(string name)
    {
        var word = Encoding.UTF8.GetBytes(name);
        return dialect.MeaningOf(word) != NcMeaning.Unknown || dialect.RoleOf(word) != LetterRole.Unknown
            || dialect.IsFlow(word) || dialect.IsMachineProgram(word);
    }
}
