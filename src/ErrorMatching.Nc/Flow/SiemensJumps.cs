namespace ErrorMatching.Nc;

/// <summary>Siemens jumps to labels, and repeated sections: IF, GOTOF, CASE, REPEAT.</summary>
internal sealed class SiemensJumps(CallStack calls, FlowReport report, FlowMemory memory, FlowCourse course, FlowSettings settings)
{
    public FlowAction If(int block, ReadOnlySpan<byte> text, int at)
    {
        var reader = memory.ReaderAt(text, at);
        var value = reader.Expression();
        if (!memory.TryTruth(block, ref reader, value, out var holds))
        {
            return FlowAction.Stop;
        }

        reader.SkipSpaces();
        return GoToLabel(block, text, reader.At, holds, out _);
    }

    // GOTOF LABEL and similar, with the word at a position. If it does not jump, only finds the end of the statement.
    public FlowAction GoToLabel(int block, ReadOnlySpan<byte> text, int at, bool jumps, out int end)
    {
        var length = BlockHead.NameLength(text, at);
        var word = NcText.Decode(text.Slice(at, length)).ToUpperInvariant();
        end = at + length;
        if (word is not ("GOTO" or "GOTOF" or "GOTOB" or "GOTOC" or "GOTOS"))
        {
            return report.Refuse(NcRefusalCodes.BadExpression, block,
                FormattableString.Invariant($"column {at + 1}: a jump (GOTOF, GOTOB, GOTO) is expected here."));
        }

        if (word == "GOTOS")
        {
            return jumps ? course.Jump(block, calls.Unit.First) : FlowAction.Continue;
        }

        if (!TryLabel(block, text, end, out var label, out end))
        {
            return FlowAction.Stop;
        }

        if (!jumps)
        {
            return FlowAction.Continue;
        }

        var target = Target(block, label, word != "GOTOB", word != "GOTOF");
        if (target >= 0 || word == "GOTOC")
        {
            return target >= 0 ? course.Jump(block, target) : FlowAction.Continue;
        }

        var where = word == "GOTOF" ? "behind it" : word == "GOTOB" ? "before it" : "in this program";
        return report.Refuse(NcRefusalCodes.MissingLabel, block, $"the jump goes to {label}, which does not exist {where}.");
    }

    // CASE (value) OF 1 GOTOF A 2 GOTOF B DEFAULT GOTOF C
    public FlowAction Case(int block, ReadOnlySpan<byte> text, int at)
    {
        var reader = memory.ReaderAt(text, at);
        var value = reader.Bracket();
        reader.SkipSpaces();
        if (reader.Error is null && !BlockHead.Stands(text, reader.At, "OF"u8))
        {
            reader.Fail("OF is expected here");
        }

        if (!memory.Check(ref reader, block))
        {
            return FlowAction.Stop;
        }

        if (value.IsUnknown)
        {
            return report.Refuse(NcRefusalCodes.UnknownCondition, block,
                "which way the program goes hangs on a value that only the machine knows.");
        }

        reader.At += 2;
        for (reader.SkipSpaces(); reader.At < text.Length && text[reader.At] != ';'; reader.SkipSpaces())
        {
            var isDefault = BlockHead.Stands(text, reader.At, "DEFAULT"u8);
            reader.At += isDefault ? 7 : 0;
            var candidate = isDefault ? value : reader.Operand();
            reader.SkipSpaces();
            if (!memory.Check(ref reader, block))
            {
                return FlowAction.Stop;
            }

            var holds = ExpressionArithmetic.Apply(ExpressionOperator.Equal, value, candidate, ExpressionEquality.Relative,
                out _).Number != 0;
            var action = GoToLabel(block, text, reader.At, holds, out var end);
            if (holds || action == FlowAction.Stop)
            {
                return action;
            }

            reader.At = end;
        }

        return FlowAction.Continue;
    }

    // REPEAT LABEL P=n, REPEAT FROM TO P=n, REPEATB LABEL P=n: n more passes of a section, then continues after the statement.
    public FlowAction Repeat(int block, ReadOnlySpan<byte> text, int at, bool isOneBlock)
    {
        if (calls.Frame.Regions.TryPeek(out var region) && region.Owner == block && region.Last == block)
        {
            return FlowAction.Continue;
        }

        if (!TryLabel(block, text, at, out var label, out var end))
        {
            return FlowAction.Stop;
        }

        var reader = memory.ReaderAt(text, end);
        reader.SkipSpaces();
        var (first, last) = (Target(block, label, forward: true, backward: true), -1);
        var length = BlockHead.NameLength(text, reader.At);
        var second = NcText.Decode(text.Slice(reader.At, length)).ToUpperInvariant();
        if (length > 1 && second[0] is not 'P' || (length > 1 && second.AsSpan(1).IndexOfAnyExceptInRange('0', '9') >= 0))
        {
            last = Target(first, second, forward: true, backward: false);
            reader.At += length;
            last = last < 0 ? -2 : last;
        }
        else if (isOneBlock)
        {
            last = first;
        }
        else
        {
            last = first < 0 ? -1 : calls.Unit.Index.FindLabel(calls.Unit, first, "ENDLABEL", forward: true, backward: false);
            last = first <= block && (last < 0 || last > block) ? block : last;
        }

        if (first < 0 || last < first)
        {
            return report.Refuse(NcRefusalCodes.MissingLabel, block,
                $"the section {label} that is to be repeated, or its end, does not exist in this program.");
        }

        if (!memory.TryPasses(block, ref reader, out var passes))
        {
            return FlowAction.Stop;
        }

        if (calls.Frame.Regions.Count >= settings.Depth)
        {
            return report.Refuse(NcRefusalCodes.CallTooDeep, block, "too many repeated sections stand in one another.");
        }

        if (passes <= 0)
        {
            return FlowAction.Continue;
        }

        calls.Frame.Regions.Push(new(block, first, last, last == block ? passes + 1 : passes));
        course.Change();
        return last == block ? FlowAction.Continue : course.GoTo(block, first);
    }

    private int Target(int block, string label, bool forward, bool backward)
    {
        var isNumber = label.Length > 1 && label[0] is 'N' or 'n' && label.AsSpan(1).IndexOfAnyExceptInRange('0', '9') < 0
            && label.Length < 14;
        return isNumber
            ? calls.Unit.Index.FindNumber(calls.Unit, block,
                long.Parse(label.AsSpan(1), System.Globalization.CultureInfo.InvariantCulture), forward, backward)
            : calls.Unit.Index.FindLabel(calls.Unit, block, label, forward, backward);
    }

    // A label as written, or the text of a variable or expression.
    private bool TryLabel(int block, ReadOnlySpan<byte> text, int at, out string label, out int end)
    {
        var reader = memory.ReaderAt(text, at);
        reader.SkipSpaces();
        var length = BlockHead.NameLength(text, reader.At);
        label = NcText.Decode(text.Slice(reader.At, length)).ToUpperInvariant();
        end = reader.At + length;
        if (length > 0 && memory.Variables.Find(label) is not { Type: VariableType.Text })
        {
            return true;
        }

        var value = reader.Expression();
        end = reader.At;
        if (!memory.Check(ref reader, block))
        {
            return false;
        }

        label = value.Text ?? "";
        if (value.Kind != NcValueKind.Text)
        {
            report.Refuse(value.IsUnknown ? NcRefusalCodes.UnknownCondition : NcRefusalCodes.BadExpression, block,
                "the target of the jump is no label that can be known here.");
        }

        return report.Refusal is null;
    }
}
