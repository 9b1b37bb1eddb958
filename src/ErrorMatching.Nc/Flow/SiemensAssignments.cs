namespace ErrorMatching.Nc;

/// <summary>Siemens assignments, in order; the interpreter handles all other words of their block.</summary>
internal sealed class SiemensAssignments(FlowMemory memory, SiemensArrays arrays)
{
    /// <summary>Makes the assignments of a block.</summary>
    public FlowAction Assign(int block, ReadOnlySpan<byte> text, int at)
    {
        var hasWords = false;
        var reader = memory.ReaderAt(text, at);
        for (reader.SkipSpaces(); reader.Error is null && reader.At < text.Length && text[reader.At] != ';'; reader.SkipSpaces())
        {
            var (start, length) = (reader.At, BlockHead.NameLength(text, reader.At));
            if (text[start] == '"')
            {
                var close = text[(start + 1)..].IndexOf((byte)'"');
                reader.At = close < 0 ? text.Length : start + close + 2;
                continue;
            }

            if (length == 0 || !memory.IsVariable(text, start, length))
            {
                hasWords = true;
                reader.At += Math.Max(1, length);
                continue;
            }

            var place = reader.Place();
            reader.SkipSpaces();
            if (reader.At + 1 >= text.Length || text[reader.At] != '=' || text[reader.At + 1] == '=')
            {
                hasWords = true;
                continue;
            }

            reader.At++;
            if (AssignValue(block, ref reader, text, place, start) == FlowAction.Stop)
            {
                return FlowAction.Stop;
            }
        }

        return !memory.Check(ref reader, block) ? FlowAction.Stop : hasWords ? FlowAction.Words : FlowAction.Continue;
    }

    private FlowAction AssignValue(int block, ref ExpressionReader reader, ReadOnlySpan<byte> text, VariablePlace place, int column)
    {
        reader.SkipSpaces();
        var isSet = BlockHead.Stands(text, reader.At, "SET"u8);
        if (place.Kind is VariableKind.Named or VariableKind.Element && (isSet || BlockHead.Stands(text, reader.At, "REP"u8))
            && memory.Variables.Find(place.Name!) is { } array)
        {
            reader.At += 3;
            return arrays.Fill(block, ref reader, array, place.Number, isRepeated: !isSet);
        }

        var value = reader.Expression();
        return memory.Check(ref reader, block) ? memory.Assigned(block, place, value, column) : FlowAction.Stop;
    }
}
