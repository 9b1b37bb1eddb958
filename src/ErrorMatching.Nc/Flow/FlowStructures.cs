namespace ErrorMatching.Nc;

/// <summary>Branches and loops over several blocks, common to all families.</summary>
internal sealed class FlowStructures(
    NcSyntax syntax,
    CallStack calls,
    FlowReport report,
    FlowMemory memory,
    FlowCourse course,
    FlowAlarms alarms,
    OWords words)
{
    private bool _breaking;

    /// <summary>True if a break out of a loop still ends another one.</summary>
    public bool IsBreaking => _breaking;

    public FlowAction Execute(FlowStatement statement, ReadOnlySpan<byte> text)
    {
        var block = statement.Block;
        if (statement.Kind is FlowKind.Call or FlowKind.Return or FlowKind.Sub or FlowKind.EndSub)
        {
            return words.Execute(statement, text);
        }

        if (statement.Start?.End is not { } end)
        {
            return report.Refuse(NcRefusalCodes.MissingLabel, block,
                "a branch or loop is not complete here: its begin or its end is missing, or too many stand in one another.");
        }

        var start = statement.Start;
        switch (statement.Kind)
        {
            case FlowKind.If: return Branch(statement, text);
            case FlowKind.ElseIf or FlowKind.Else: return course.Jump(block, end.Block + 1);
            case FlowKind.While: return While(statement, text, end);
            case FlowKind.EndWhile: return course.Jump(block, start.Block);
            case FlowKind.EndLoop: return course.Jump(block, start.Block + 1);
            case FlowKind.Until when _breaking: return LeaveUntil(block);
            case FlowKind.Until: return Until(statement, text, start);
            case FlowKind.Repeat: return BeginRepeat(statement, text, end);
            case FlowKind.EndRepeat: return EndRepeat(statement, start);
            case FlowKind.For: return For(statement, text, end, begins: true);
            case FlowKind.EndFor: return For(start, calls.Program.BytesOf(calls.Program[start.Block]), statement, begins: false);
            case FlowKind.Break:
                _breaking = syntax == NcSyntax.LinuxCnc && start.Kind == FlowKind.While;
                return course.Jump(block, end.Block + 1);
            case FlowKind.Continue: return course.Jump(block, start.Kind == FlowKind.While ? start.Block : end.Block);
            default: return FlowAction.Continue;
        }
    }

    // Measured with rs274: a break out of a while loop also ends the next do loop at its end, whatever its condition.
    private FlowAction LeaveUntil(int block)
    {
        _breaking = false;
        report.Note("loop-left", block,
            "LinuxCNC 2.9 leaves this loop whatever its condition says, since a break out of a while loop before it still counts here. "
                + "Set a variable for the while loop's condition instead of the break.");
        return course.Jump(block, block + 1);
    }

    private FlowAction While(FlowStatement statement, ReadOnlySpan<byte> text, FlowStatement end) =>
        Condition(statement, text, out var goesOn)
            ? course.Jump(statement.Block, goesOn ? statement.Block + 1 : end.Block + 1)
            : FlowAction.Stop;

    private FlowAction Until(FlowStatement statement, ReadOnlySpan<byte> text, FlowStatement start)
    {
        var block = statement.Block;
        return Condition(statement, text, out var holds)
            ? course.Jump(block, holds == (syntax == NcSyntax.LinuxCnc) ? start.Block + 1 : block + 1)
            : FlowAction.Stop;
    }

    private bool Condition(FlowStatement statement, ReadOnlySpan<byte> text, out bool truth)
    {
        var reader = memory.ReaderAt(text, statement.At);
        var value = syntax == NcSyntax.Siemens ? reader.Expression() : reader.Bracket();
        if (syntax == NcSyntax.LinuxCnc)
        {
            FlowMemory.EndOfStatement(ref reader, text);
        }

        return memory.TryTruth(statement.Block, ref reader, value, out truth);
    }

    private FlowAction Branch(FlowStatement statement, ReadOnlySpan<byte> text)
    {
        for (var branch = statement; ; branch = branch.Branch!)
        {
            if (branch.Kind is FlowKind.Else or FlowKind.EndIf)
            {
                return course.Jump(statement.Block, branch.Block + 1);
            }

            var condition = ReferenceEquals(branch, statement) ? text : calls.Program.BytesOf(calls.Program[branch.Block]);
            if (alarms.OnlyStops(branch, condition))
            {
                return course.Jump(statement.Block, branch.Branch!.Block + 1);
            }

            if (!Condition(branch, condition, out var holds))
            {
                return FlowAction.Stop;
            }

            if (holds)
            {
                return course.Jump(statement.Block, branch.Block + 1);
            }
        }
    }

    private FlowAction BeginRepeat(FlowStatement statement, ReadOnlySpan<byte> text, FlowStatement end)
    {
        var reader = memory.ReaderAt(text, statement.At);
        var value = reader.Bracket();
        FlowMemory.EndOfStatement(ref reader, text);
        if (!memory.Check(ref reader, statement.Block)
            || !memory.TryCount(statement.Block, value, "the number of repetitions", out var passes))
        {
            return FlowAction.Stop;
        }

        calls.Frame.Counters[statement.Block] = passes;
        course.Change();
        return course.Jump(statement.Block, passes > 0 ? statement.Block + 1 : end.Block + 1);
    }

    private FlowAction EndRepeat(FlowStatement statement, FlowStatement start)
    {
        var left = calls.Frame.Counters.GetValueOrDefault(start.Block) - 1;
        calls.Frame.Counters[start.Block] = left;
        course.Change();
        return course.Jump(statement.Block, left > 0 ? start.Block + 1 : statement.Block + 1);
    }

    // FOR i = a TO b .. ENDFOR: the end value is computed at each pass; i increases by one.
    private FlowAction For(FlowStatement start, ReadOnlySpan<byte> text, FlowStatement end, bool begins)
    {
        var from = begins ? start.Block : end.Block;
        var reader = memory.ReaderAt(text, start.At);
        var counter = reader.Place();
        if (!reader.Take((byte)'='))
        {
            reader.Fail("\"=\" is expected here");
        }

        var first = reader.Expression();
        reader.SkipSpaces();
        if (reader.Error is null && !BlockHead.Stands(text, reader.At, "TO"u8))
        {
            reader.Fail("TO is expected here");
        }

        reader.At += 2;
        var last = reader.Error is null ? reader.Expression() : NcValue.Unknown;
        if (!memory.Check(ref reader, from))
        {
            return FlowAction.Stop;
        }

        var value = begins ? first : memory.Variables.Read(counter, out _);
        if (counter.Kind == VariableKind.Machine || !value.IsNumber || !last.IsNumber)
        {
            return report.Refuse(NcRefusalCodes.UnknownCondition, from,
                "how often the loop runs hangs on a value that only the machine knows.");
        }

        value = begins ? value : NcValue.Of(value.Number + 1);
        return memory.Assigned(from, counter, value, start.At) == FlowAction.Stop ? FlowAction.Stop
            : course.Jump(from, value.Number > last.Number ? end.Block + 1 : start.Block + 1);
    }
}
