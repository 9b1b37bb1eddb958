namespace ErrorMatching.Nc;

/// <content>Siemens DEF, PROC and calls by name.</content>
internal sealed partial class NcFlow
{
    private readonly HashSet<string> _external = new(StringComparer.Ordinal);

    private static VariableType? TypeOf(string word) => word switch
    {
        "REAL" => VariableType.Real,
        "INT" => VariableType.Integer,
        "BOOL" => VariableType.Truth,
        "STRING" => VariableType.Text,
        "CHAR" or "AXIS" or "FRAME" => VariableType.Opaque,
        _ => null,
    };

    // DEF REAL A, B=5, C[10], D[2,3]=(1,2,3)
    private FlowAction Define(int block, ReadOnlySpan<byte> text, int at)
    {
        var reader = ReaderAt(text, at);
        VariableType? type = null;
        for (var words = 0; type is null && words < 6; words++)
        {
            type = TypeOf(Word(ref reader, text));
        }

        if (type is null)
        {
            return Refuse(NcRefusalCodes.BadExpression, block, "DEF names no type that is known (REAL, INT, BOOL, STRING).");
        }

        SkipBrackets(ref reader, text);
        do
        {
            var name = Word(ref reader, text);
            if (name.Length == 0)
            {
                reader.Fail("a name is expected here");
                break;
            }

            var array = Dimensions(ref reader, out var rows, out var columns) ? Variables.Define(name, type.Value, rows, columns) : null;
            if (array is not null && reader.Take((byte)'=') && Initial(block, ref reader, text, array) == FlowAction.Stop)
            {
                return FlowAction.Stop;
            }
        }
        while (reader.Take((byte)','));

        return Check(ref reader, block) ? FlowAction.Continue : FlowAction.Stop;
    }

    private FlowAction Initial(int block, ref ExpressionReader reader, ReadOnlySpan<byte> text, VariableArray array)
    {
        reader.SkipSpaces();
        if (BlockHead.Stands(text, reader.At, "SET"u8) || BlockHead.Stands(text, reader.At, "REP"u8))
        {
            var isRepeated = (text[reader.At] | 0x20) == 'r';
            reader.At += 3;
            return FillArray(block, ref reader, array, 0, isRepeated);
        }

        if (array.Values.Length > 1 && reader.At < text.Length && text[reader.At] == '(')
        {
            return FillArray(block, ref reader, array, 0, isRepeated: false);
        }

        array.Values[0] = array.Converted(reader.Expression());
        return Check(ref reader, block) ? FlowAction.Continue : FlowAction.Stop;
    }

    // (1, 2, 3) into successive elements, or one value into all that follow.
    private FlowAction FillArray(int block, ref ExpressionReader reader, VariableArray array, int from, bool isRepeated)
    {
        if (!reader.Take((byte)'('))
        {
            reader.Fail("\"(\" is expected here");
        }

        var at = from;
        do
        {
            var value = reader.Expression();
            if (reader.Error is null && at >= array.Values.Length)
            {
                reader.Fail("the array has fewer elements");
            }

            if (reader.Error is null)
            {
                array.Values.AsSpan(at, isRepeated ? array.Values.Length - at : 1).Fill(array.Converted(value));
                at += isRepeated ? 0 : 1;
                _changes++;
            }
        }
        while (reader.Error is null && reader.Take((byte)','));

        if (!reader.Take((byte)')'))
        {
            reader.Fail("a bracket is not closed: \")\" is expected here");
        }

        return Check(ref reader, block) ? FlowAction.Continue : FlowAction.Stop;
    }

    private static bool Dimensions(ref ExpressionReader reader, out int rows, out int columns)
    {
        (rows, columns) = (1, 1);
        if (!reader.Take((byte)'['))
        {
            return reader.Error is null;
        }

        var (first, second) = (reader.Expression(), reader.Take((byte)',') ? reader.Expression() : NcValue.Of(1));
        if (!reader.Take((byte)']'))
        {
            reader.Fail("a bracket is not closed: \"]\" is expected here");
        }
        else if (!(first.Number >= 1 && second.Number >= 1 && first.Number * second.Number <= VariableArray.MaxLength))
        {
            reader.Fail("the size of the array is not known, not positive, or too large");
        }

        (rows, columns) = ((int)first.Number, (int)second.Number);
        return reader.Error is null;
    }

    private static string Word(ref ExpressionReader reader, ReadOnlySpan<byte> text)
    {
        reader.SkipSpaces();
        var length = BlockHead.NameLength(text, reader.At);
        var word = NcText.Decode(text.Slice(reader.At, length)).ToUpperInvariant();
        reader.At += length;
        return word;
    }

    private static void SkipBrackets(ref ExpressionReader reader, ReadOnlySpan<byte> text)
    {
        if (reader.Take((byte)'['))
        {
            var close = text[reader.At..].IndexOf((byte)']');
            reader.At = close < 0 ? text.Length : reader.At + close + 1;
        }
    }

    private FlowAction DeclareExternal(ReadOnlySpan<byte> text, int at)
    {
        var reader = ReaderAt(text, at);
        _external.Add(FlowIndex.PlainName(Word(ref reader, text)));
        return FlowAction.Continue;
    }

    // A name that stands alone or with arguments: two letters at least, or L with a number.
    private static bool IsCall(ReadOnlySpan<byte> text, int at, int length)
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

    private FlowAction CallText(int block, ReadOnlySpan<byte> text, int at)
    {
        var reader = ReaderAt(text, at);
        var value = reader.Expression();
        if (!Check(ref reader, block))
        {
            return FlowAction.Stop;
        }

        return value.Kind == NcValueKind.Text
            ? CallProgram(block, text, reader.At, FlowIndex.PlainName(value.Text!), mustExist: true)
            : Refuse(NcRefusalCodes.UnknownCondition, block, "which program is called is a value that only the machine knows.");
    }

    private FlowAction CallNamed(int block, ReadOnlySpan<byte> text, int at, int length)
    {
        var name = FlowIndex.PlainName(NcText.Decode(text.Slice(at, length)));
        var mustExist = _external.Contains(name) || ((text[at] | 0x20) == 'l' && BlockHead.NumberAt(text, at + 1).Length == length - 1);
        return CallProgram(block, text, at + length, name, mustExist);
    }

    private FlowAction CallProgram(int block, ReadOnlySpan<byte> text, int at, string name, bool mustExist)
    {
        var unit = Unit.Index.Unit(name);
        if (unit is null && !mustExist && IsWord(name))
        {
            return WordsOf(block, text, at);
        }

        unit ??= FromLibrary(name) is { } index ? index.Unit(name) ?? index.Main : null;
        if (unit is null)
        {
            return mustExist ? Missing(block, name) : WordsOf(block, text, at);
        }

        var reader = ReaderAt(text, at);
        var values = new List<(NcValue Value, VariablePlace? Place)>();
        if (reader.Take((byte)'('))
        {
            ReadArguments(ref reader, text, values);
        }

        if (!TryPasses(block, ref reader, out var passes))
        {
            return FlowAction.Stop;
        }

        reader.SkipSpaces();
        if (reader.At < text.Length && text[reader.At] != ';')
        {
            reader.Fail("the call should end here");
            Check(ref reader, block);
            return FlowAction.Stop;
        }

        if (passes <= 0)
        {
            return FlowAction.Continue;
        }

        return Enter(new() { Unit = unit, First = unit.First, Caller = block, Passes = passes, Arguments = [], Parameters = values });
    }

    private FlowAction WordsOf(int block, ReadOnlySpan<byte> text, int at) =>
        AssignSiemens(block, text, at) == FlowAction.Stop ? FlowAction.Stop : FlowAction.Words;

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

            // A parameter by reference needs the variable itself: whatever is one alone.
            var start = reader.At;
            var length = BlockHead.NameLength(text, start);
            VariablePlace? place = null;
            if (length > 0 && IsVariable(text, start, length))
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
}
