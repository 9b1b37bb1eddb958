namespace ErrorMatching.Nc;

/// <summary>Subroutines of LinuxCNC: <c>o100 call [1] [2]</c>.</summary>
internal sealed class OWords(CallStack calls, FlowReport report, FlowMemory memory, FlowCourse course, FlowLibrary library)
{
    private const int MostArguments = 30;

    public FlowAction Execute(FlowStatement statement, ReadOnlySpan<byte> text)
    {
        switch (statement.Kind)
        {
            case FlowKind.Sub when HasSubInside(statement):
                return report.Refuse(NcRefusalCodes.RefusedByControl, statement.Block,
                    "another subroutine begins before this one ends: the control refuses that. End this one first.");
            case FlowKind.Sub:
                return statement.End is { } end
                    ? course.Jump(statement.Block, end.Block + 1)
                    : report.Refuse(NcRefusalCodes.MissingLabel, statement.Block, "the subroutine has no end.");
            case FlowKind.Call:
                return CallSub(statement, text);
            default:
                return calls.Frames.Count == 1
                    ? report.Refuse(NcRefusalCodes.MissingLabel, statement.Block, "a subroutine ends here that was not called.")
                    : ReturnValue(statement, text);
        }
    }

    private bool HasSubInside(FlowStatement sub)
    {
        for (var block = sub.Block + 1; block < sub.End?.Block; block++)
        {
            if (calls.Unit.Index.StatementAt(block) is { Kind: FlowKind.Sub })
            {
                return true;
            }
        }

        return false;
    }

    private FlowAction ReturnValue(FlowStatement statement, ReadOnlySpan<byte> text)
    {
        var reader = memory.ReaderAt(text, statement.At);
        reader.SkipSpaces();
        if (reader.At < text.Length && text[reader.At] == '[')
        {
            memory.Variables.Return(reader.Bracket());
        }

        FlowMemory.EndOfStatement(ref reader, text);
        return memory.Check(ref reader, statement.Block) ? course.Return(statement.Block) : FlowAction.Stop;
    }

    private FlowAction CallSub(FlowStatement statement, ReadOnlySpan<byte> text)
    {
        var (label, labelEnd, _, keywordEnd) = OWordHead.Read(text, statement.At);
        if (label.Length == 0)
        {
            var number = memory.ReaderAt(text[..labelEnd], statement.At + 1);
            var value = number.Operand();
            if (!memory.Check(ref number, statement.Block)
                || !memory.TryCount(statement.Block, value, "the number of the subroutine", out var count))
            {
                return FlowAction.Stop;
            }

            label = FormattableString.Invariant($"{count}");
        }

        var reader = memory.ReaderAt(text, keywordEnd);
        var arguments = new List<(VariablePlace, NcValue)>();
        FlowMemory.SkipComments(ref reader, text);
        while (reader.Error is null && reader.At < text.Length && text[reader.At] == '[')
        {
            arguments.Add((VariablePlace.Numbered(arguments.Count + 1), reader.Bracket()));
            if (arguments.Count > MostArguments)
            {
                reader.Fail("a subroutine takes at most 30 arguments");
            }

            FlowMemory.SkipComments(ref reader, text);
        }

        FlowMemory.EndOfStatement(ref reader, text);
        if (!memory.Check(ref reader, statement.Block))
        {
            return FlowAction.Stop;
        }

        var index = calls.Unit.Index.Sub(label) is null ? library.Find(label.ToLowerInvariant()) : calls.Unit.Index;
        if (index?.Sub(label) is not { } sub)
        {
            return report.Missing(statement.Block, $"o<{label.ToLowerInvariant()}>");
        }

        if (sub.End is null)
        {
            return report.Refuse(NcRefusalCodes.MissingLabel, statement.Block, "the subroutine that is called has no end.");
        }

        memory.Variables.Return(null);
        return course.Enter(new()
        {
            Unit = index.UnitAt(sub.Block),
            First = sub.Block + 1,
            Caller = statement.Block,
            Arguments = arguments,
        });
    }
}
