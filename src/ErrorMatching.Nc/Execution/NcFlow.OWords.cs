namespace ErrorMatching.Nc;

/// <content>Subroutines of LinuxCNC: <c>o100 call [1] [2]</c>.</content>
internal sealed partial class NcFlow
{
    private const int MostArguments = 30;

    private FlowAction OWord(FlowStatement statement, ReadOnlySpan<byte> text)
    {
        switch (statement.Kind)
        {
            case FlowKind.Sub:
                return statement.End is { } end
                    ? Jump(statement.Block, end.Block + 1)
                    : Refuse(NcRefusalCodes.MissingLabel, statement.Block, "the subroutine has no end.");
            case FlowKind.Call:
                return CallSub(statement, text);
            default:
                return _frames.Count == 1
                    ? Refuse(NcRefusalCodes.MissingLabel, statement.Block, "a subroutine ends here that was not called.")
                    : ReturnValue(statement, text);
        }
    }

    private FlowAction ReturnValue(FlowStatement statement, ReadOnlySpan<byte> text)
    {
        var reader = ReaderAt(text, statement.At);
        reader.SkipSpaces();
        if (reader.At < text.Length && text[reader.At] == '[')
        {
            Variables.Return(reader.Bracket());
        }

        EndOfStatement(ref reader, text);
        return Check(ref reader, statement.Block) ? Return(statement.Block) : FlowAction.Stop;
    }

    // Comments stand anywhere behind the keyword and count for nothing.
    private static void SkipComments(ref ExpressionReader reader, ReadOnlySpan<byte> text)
    {
        for (reader.SkipSpaces(); reader.At < text.Length && text[reader.At] == '('; reader.SkipSpaces())
        {
            var close = text[reader.At..].IndexOf((byte)')');
            reader.At = close < 0 ? text.Length : reader.At + close + 1;
        }
    }

    // The control stops at anything else.
    private static void EndOfStatement(ref ExpressionReader reader, ReadOnlySpan<byte> text)
    {
        SkipComments(ref reader, text);
        if (reader.Error is null && reader.At < text.Length && text[reader.At] != ';')
        {
            reader.Fail("the statement should end here");
        }
    }

    private FlowAction CallSub(FlowStatement statement, ReadOnlySpan<byte> text)
    {
        var (label, labelEnd, _, keywordEnd) = FlowIndex.OWordAt(text, statement.At);
        if (label.Length == 0)
        {
            var number = ReaderAt(text[..labelEnd], statement.At + 1);
            var value = number.Operand();
            if (!Check(ref number, statement.Block) || !TryCount(statement.Block, value, "the number of the subroutine", out var count))
            {
                return FlowAction.Stop;
            }

            label = FormattableString.Invariant($"{count}");
        }

        var reader = ReaderAt(text, keywordEnd);
        var arguments = new List<(VariablePlace, NcValue)>();
        SkipComments(ref reader, text);
        while (reader.Error is null && reader.At < text.Length && text[reader.At] == '[')
        {
            arguments.Add((VariablePlace.Numbered(arguments.Count + 1), reader.Bracket()));
            if (arguments.Count > MostArguments)
            {
                reader.Fail("a subroutine takes at most 30 arguments");
            }

            SkipComments(ref reader, text);
        }

        EndOfStatement(ref reader, text);
        if (!Check(ref reader, statement.Block))
        {
            return FlowAction.Stop;
        }

        var index = Unit.Index.Sub(label) is null ? FromLibrary(label.ToLowerInvariant()) : Unit.Index;
        if (index?.Sub(label) is not { } sub)
        {
            return Missing(statement.Block, $"o<{label.ToLowerInvariant()}>");
        }

        if (sub.End is null)
        {
            return Refuse(NcRefusalCodes.MissingLabel, statement.Block, "the subroutine that is called has no end.");
        }

        Variables.Return(null);
        return Enter(new() { Unit = index.UnitAt(sub.Block), First = sub.Block + 1, Caller = statement.Block, Arguments = arguments });
    }
}
