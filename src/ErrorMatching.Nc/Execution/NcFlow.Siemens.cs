namespace ErrorMatching.Nc;

/// <content>Statements of Siemens: jumps, CASE, REPEAT of a section, assignments.</content>
internal sealed partial class NcFlow
{
    private FlowAction Siemens(int block, ReadOnlySpan<byte> text, BlockHead head)
    {
        var length = BlockHead.NameLength(text, head.At);
        var end = head.At + length;
        var word = length is > 1 and <= 8 ? NcText.Decode(text.Slice(head.At, length)).ToUpperInvariant() : "";
        switch (word)
        {
            case "IF": return IfGoTo(block, text, end);
            case "GOTO" or "GOTOF" or "GOTOB" or "GOTOC" or "GOTOS": return GoToLabel(block, text, head.At, jumps: true, out _);
            case "CASE": return Case(block, text, end);
            case "REPEAT" or "REPEATB": return RepeatSection(block, text, end, isOneBlock: word.Length == 7);
            case "DEF": return Define(block, text, end);
            case "PROC": return FlowAction.Continue;
            case "EXTERN": return DeclareExternal(text, end);
            case "RET": return Returned(block);
            default: return CallOrAssign(block, text, head.At, length);
        }
    }

    private FlowAction CallOrAssign(int block, ReadOnlySpan<byte> text, int at, int length)
    {
        var meaning = _dialect.MeaningOf(text.Slice(at, length));
        return meaning == NcMeaning.Call ? CallText(block, text, at + length)
            : meaning.Steers() ? RefuseCall(block, NcText.Decode(text.Slice(at, length)))
            : IsCall(text, at, length) ? CallNamed(block, text, at, length)
            : AssignSiemens(block, text, at);
    }

    private FlowAction IfGoTo(int block, ReadOnlySpan<byte> text, int at)
    {
        var reader = ReaderAt(text, at);
        var value = reader.Expression();
        if (!TryTruth(block, ref reader, value, out var holds))
        {
            return FlowAction.Stop;
        }

        reader.SkipSpaces();
        return GoToLabel(block, text, reader.At, holds, out _);
    }

    // GOTOF LABEL and its kind; the word stands at a place. Where it does not jump, only the end of the statement is looked for.
    private FlowAction GoToLabel(int block, ReadOnlySpan<byte> text, int at, bool jumps, out int end)
    {
        var length = BlockHead.NameLength(text, at);
        var word = NcText.Decode(text.Slice(at, length)).ToUpperInvariant();
        end = at + length;
        if (word is not ("GOTO" or "GOTOF" or "GOTOB" or "GOTOC" or "GOTOS"))
        {
            return Refuse(NcRefusalCodes.BadExpression, block, FormattableString.Invariant($"column {at + 1}: a jump (GOTOF, GOTOB, GOTO) is expected here."));
        }

        if (word == "GOTOS")
        {
            return jumps ? Jump(block, Unit.First) : FlowAction.Continue;
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
        return target >= 0 ? Jump(block, target)
            : word == "GOTOC" ? FlowAction.Continue
            : Refuse(NcRefusalCodes.MissingLabel, block, $"the jump goes to {label}, which does not exist {(word == "GOTOF" ? "behind it" : word == "GOTOB" ? "before it" : "in this program")}.");
    }

    private int Target(int block, string label, bool forward, bool backward)
    {
        var isNumber = label.Length > 1 && label[0] is 'N' or 'n' && label.AsSpan(1).IndexOfAnyExceptInRange('0', '9') < 0 && label.Length < 14;
        return isNumber
            ? Unit.Index.FindNumber(Unit, block, long.Parse(label.AsSpan(1), System.Globalization.CultureInfo.InvariantCulture), forward, backward)
            : Unit.Index.FindLabel(Unit, block, label, forward, backward);
    }

    // A label as written, or the text that a variable or expression holds.
    private bool TryLabel(int block, ReadOnlySpan<byte> text, int at, out string label, out int end)
    {
        var reader = ReaderAt(text, at);
        reader.SkipSpaces();
        var length = BlockHead.NameLength(text, reader.At);
        label = NcText.Decode(text.Slice(reader.At, length)).ToUpperInvariant();
        end = reader.At + length;
        if (length > 0 && Variables.Find(label) is not { Type: VariableType.Text })
        {
            return true;
        }

        var value = reader.Expression();
        end = reader.At;
        if (!Check(ref reader, block))
        {
            return false;
        }

        label = value.Text ?? "";
        if (value.Kind != NcValueKind.Text)
        {
            Refuse(value.IsUnknown ? NcRefusalCodes.UnknownCondition : NcRefusalCodes.BadExpression, block, "the target of the jump is no label that can be known here.");
        }

        return Refusal is null;
    }

    // CASE (value) OF 1 GOTOF A 2 GOTOF B DEFAULT GOTOF C
    private FlowAction Case(int block, ReadOnlySpan<byte> text, int at)
    {
        var reader = ReaderAt(text, at);
        var value = reader.Bracket();
        reader.SkipSpaces();
        if (reader.Error is null && !BlockHead.Stands(text, reader.At, "OF"u8))
        {
            reader.Fail("OF is expected here");
        }

        if (!Check(ref reader, block))
        {
            return FlowAction.Stop;
        }

        if (value.IsUnknown)
        {
            return Refuse(NcRefusalCodes.UnknownCondition, block, "which way the program goes hangs on a value that only the machine knows.");
        }

        reader.At += 2;
        for (reader.SkipSpaces(); reader.At < text.Length && text[reader.At] != ';'; reader.SkipSpaces())
        {
            var isDefault = BlockHead.Stands(text, reader.At, "DEFAULT"u8);
            reader.At += isDefault ? 7 : 0;
            var candidate = isDefault ? value : reader.Operand();
            reader.SkipSpaces();
            if (!Check(ref reader, block))
            {
                return FlowAction.Stop;
            }

            var holds = ExpressionArithmetic.Apply(ExpressionOperator.Equal, value, candidate, ExpressionEquality.Relative, out _).Number != 0;
            var action = GoToLabel(block, text, reader.At, holds, out var end);
            if (holds || action == FlowAction.Stop)
            {
                return action;
            }

            reader.At = end;
        }

        return FlowAction.Continue;
    }

    // REPEAT LABEL P=n, REPEAT FROM TO P=n, REPEATB LABEL P=n: n more passes of a section, then on behind the statement.
    private FlowAction RepeatSection(int block, ReadOnlySpan<byte> text, int at, bool isOneBlock)
    {
        if (Frame.Regions.TryPeek(out var region) && region.Owner == block && region.Last == block)
        {
            return FlowAction.Continue;
        }

        if (!TryLabel(block, text, at, out var label, out var end))
        {
            return FlowAction.Stop;
        }

        var reader = ReaderAt(text, end);
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
            last = first < 0 ? -1 : Unit.Index.FindLabel(Unit, first, "ENDLABEL", forward: true, backward: false);
            last = first <= block && (last < 0 || last > block) ? block : last;
        }

        if (first < 0 || last < first)
        {
            return Refuse(NcRefusalCodes.MissingLabel, block, $"the section {label} that is to be repeated, or its end, does not exist in this program.");
        }

        if (!TryPasses(block, ref reader, out var passes))
        {
            return FlowAction.Stop;
        }

        if (Frame.Regions.Count >= _settings.Depth)
        {
            return Refuse(NcRefusalCodes.CallTooDeep, block, "too many repeated sections stand in one another.");
        }

        if (passes <= 0)
        {
            return FlowAction.Continue;
        }

        Frame.Regions.Push(new(block, first, last, last == block ? passes + 1 : passes));
        _changes++;
        return last == block ? FlowAction.Continue : GoTo(block, first);
    }

    // P=3, P3 or P=R1 behind a call or REPEAT; 1 where there is none.
    private bool TryPasses(int block, ref ExpressionReader reader, out long passes)
    {
        passes = 1;
        if (!reader.Take((byte)'P') && !reader.Take((byte)'p'))
        {
            return Check(ref reader, block);
        }

        reader.Take((byte)'=');
        var value = reader.Expression();
        return Check(ref reader, block) && TryCount(block, value, "the number of repetitions", out passes);
    }

    private FlowAction Returned(int block) => _frames.Count > 1 ? Return(block) : Ended();

    private FlowAction BehindSiemens(int block, ReadOnlySpan<byte> text)
    {
        for (var at = 0; at < text.Length && text[at] != ';';)
        {
            var length = BlockHead.NameLength(text, at);
            if (length > 1 && (text[at] | 0x20) == 'm' && BlockHead.NumberAt(text, at + 1) is var number && number.Length == length - 1
                && _dialect.FunctionOf((int)Math.Min(number.Value, int.MaxValue)) is var role && role.Steers())
            {
                return Steer(block, role, number.Value, NcValue.Vacant);
            }

            // Digits belong to what they follow: the 3 of 1EX3 is no word.
            at += Math.Max(1, length);
            if (text[at - 1] == '"' && text[at..].IndexOf((byte)'"') is >= 0 and var close)
            {
                at += close + 1;
            }
        }

        return FlowAction.Continue;
    }

    // Assignments in their order; all else is left to the interpreter.
    private FlowAction AssignSiemens(int block, ReadOnlySpan<byte> text, int at)
    {
        var hasWords = false;
        var reader = ReaderAt(text, at);
        for (reader.SkipSpaces(); reader.Error is null && reader.At < text.Length && text[reader.At] != ';'; reader.SkipSpaces())
        {
            var (start, length) = (reader.At, BlockHead.NameLength(text, reader.At));
            if (text[start] == '"')
            {
                var close = text[(start + 1)..].IndexOf((byte)'"');
                reader.At = close < 0 ? text.Length : start + close + 2;
                continue;
            }

            if (length == 0 || !IsVariable(text, start, length))
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

        return !Check(ref reader, block) ? FlowAction.Stop : hasWords ? FlowAction.Words : FlowAction.Continue;
    }

    private bool IsVariable(ReadOnlySpan<byte> text, int at, int length)
    {
        if ((text[at] | 0x20) == 'r' && (length > 1 ? BlockHead.NumberAt(text, at + 1).Length == length - 1 : at + 1 < text.Length && text[at + 1] == '['))
        {
            return true;
        }

        return Variables.Names.Known(text.Slice(at, length)) is { } name && Variables.Knows(name);
    }

    private FlowAction AssignValue(int block, ref ExpressionReader reader, ReadOnlySpan<byte> text, VariablePlace place, int column)
    {
        reader.SkipSpaces();
        var isSet = BlockHead.Stands(text, reader.At, "SET"u8);
        if (place.Kind is VariableKind.Named or VariableKind.Element && (isSet || BlockHead.Stands(text, reader.At, "REP"u8)) && Variables.Find(place.Name!) is { } array)
        {
            reader.At += 3;
            return FillArray(block, ref reader, array, place.Number, isRepeated: !isSet);
        }

        var value = reader.Expression();
        return Check(ref reader, block) ? Assigned(block, place, value, column) : FlowAction.Stop;
    }
}
