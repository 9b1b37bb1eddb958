namespace ErrorMatching.Nc;

/// <summary>Variables that a Siemens program defines (DEF), and values of arrays.</summary>
internal sealed class SiemensArrays(FlowReport report, FlowMemory memory, FlowCourse course)
{
    // DEF REAL A, B=5, C[10], D[2,3]=(1,2,3)
    public FlowAction Define(int block, ReadOnlySpan<byte> text, int at)
    {
        var reader = memory.ReaderAt(text, at);
        VariableType? type = null;
        for (var words = 0; type is null && words < 6; words++)
        {
            type = FlowMemory.TypeOf(FlowMemory.Word(ref reader, text));
        }

        if (type is null)
        {
            return report.Refuse(NcRefusalCodes.BadExpression, block, "DEF names no type that is known (REAL, INT, BOOL, STRING).");
        }

        FlowMemory.SkipBrackets(ref reader, text);
        do
        {
            var name = FlowMemory.Word(ref reader, text);
            if (name.Length == 0)
            {
                reader.Fail("a name is expected here");
                break;
            }

            var array = Dimensions(ref reader, out var rows, out var columns) ? memory.Variables.Define(name, type.Value, rows, columns)
                : null;
            if (array is not null
                && (course.CountElements(block, array.Values.Length) == FlowAction.Stop
                    || (reader.Take((byte)'=') && Initial(block, ref reader, text, array) == FlowAction.Stop)))
            {
                return FlowAction.Stop;
            }
        }
        while (reader.Take((byte)','));

        return memory.Check(ref reader, block) ? FlowAction.Continue : FlowAction.Stop;
    }

    // (1, 2, 3) into successive elements, or one value into all following ones.
    public FlowAction Fill(int block, ref ExpressionReader reader, VariableArray array, int from, bool isRepeated)
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
                var count = isRepeated ? array.Values.Length - at : 1;
                if (course.CountElements(block, count) == FlowAction.Stop)
                {
                    return FlowAction.Stop;
                }

                array.Values.AsSpan(at, count).Fill(array.Converted(value));
                at += isRepeated ? 0 : 1;
                course.Change();
            }
        }
        while (reader.Error is null && reader.Take((byte)','));

        if (!reader.Take((byte)')'))
        {
            reader.Fail("a bracket is not closed: \")\" is expected here");
        }

        return memory.Check(ref reader, block) ? FlowAction.Continue : FlowAction.Stop;
    }

    private FlowAction Initial(int block, ref ExpressionReader reader, ReadOnlySpan<byte> text, VariableArray array)
    {
        reader.SkipSpaces();
        if (BlockHead.Stands(text, reader.At, "SET"u8) || BlockHead.Stands(text, reader.At, "REP"u8))
        {
            var isRepeated = (text[reader.At] | 0x20) == 'r';
            reader.At += 3;
            return Fill(block, ref reader, array, 0, isRepeated);
        }

        if (array.Values.Length > 1 && reader.At < text.Length && text[reader.At] == '(')
        {
            return Fill(block, ref reader, array, 0, isRepeated: false);
        }

        array.Values[0] = array.Converted(reader.Expression());
        return memory.Check(ref reader, block) ? FlowAction.Continue : FlowAction.Stop;
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
}
