namespace ErrorMatching.Nc;

/// <summary>Statements of Fanuc custom macro: IF and GOTO.</summary>
internal sealed class IsoStatements(FlowReport report, FlowMemory memory, FlowCourse course, FlowAlarms alarms, IsoWords words)
{
    public FlowAction Execute(int block, ReadOnlySpan<byte> text, int at)
    {
        if (BlockHead.Stands(text, at, "GOTO"u8))
        {
            return GoTo(block, memory.ReaderAt(text, at + 4));
        }

        if (!BlockHead.Stands(text, at, "IF"u8))
        {
            return words.Assign(block, text, at);
        }

        var reader = memory.ReaderAt(text, at + 2);
        var value = reader.Bracket();
        if (value.IsUnknown && reader.Error is null && alarms.OnlyRaisesAlarm(block, text, reader.At))
        {
            return FlowAction.Continue;
        }

        if (!memory.TryTruth(block, ref reader, value, out var holds))
        {
            return FlowAction.Stop;
        }

        reader.SkipSpaces();
        if (BlockHead.Stands(text, reader.At, "THEN"u8))
        {
            reader.At += 4;
            reader.SkipSpaces();
        }

        if (BlockHead.Stands(text, reader.At, "GOTO"u8))
        {
            reader.At += 4;
            return holds ? GoTo(block, reader) : FlowAction.Continue;
        }

        if (reader.At >= text.Length || (text[reader.At] != '#' && !SyntaxBytes.IsLetter(text[reader.At])))
        {
            return report.Refuse(
                NcRefusalCodes.BadExpression,
                block,
                FormattableString.Invariant($"column {reader.At + 1}: GOTO, an assignment or words are expected behind a condition."));
        }

        return holds ? words.AssignBehind(block, text, reader.At) : FlowAction.Continue;
    }

    private FlowAction GoTo(int block, ExpressionReader reader)
    {
        var value = reader.Operand();
        return memory.Check(ref reader, block) && memory.TryCount(block, value, "the target of the jump", out var number)
            ? course.JumpToNumber(block, number) : FlowAction.Stop;
    }
}
