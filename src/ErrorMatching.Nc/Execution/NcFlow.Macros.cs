namespace ErrorMatching.Nc;

/// <content>Fanuc custom macro: IF, GOTO, and the calls M98, G65, G66.</content>
internal sealed partial class NcFlow
{
    // Local variables of the letters A to Z; 0 where a letter is no argument (Fanuc, argument specification I).
    private static ReadOnlySpan<byte> LocalOfLetter => [1, 2, 3, 7, 8, 9, 0, 11, 4, 5, 6, 0, 13, 0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26];

    private FlowAction Macro(int block, ReadOnlySpan<byte> text, int at)
    {
        if (BlockHead.Stands(text, at, "GOTO"u8))
        {
            return GoTo(block, ReaderAt(text, at + 4));
        }

        if (!BlockHead.Stands(text, at, "IF"u8))
        {
            return Assign(block, text, at);
        }

        var reader = ReaderAt(text, at + 2);
        var value = reader.Bracket();
        if (value.IsUnknown && reader.Error is null && OnlyRaisesAlarm(block, text, reader.At))
        {
            return FlowAction.Continue;
        }

        if (!TryTruth(block, ref reader, value, out var holds))
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

        if (reader.At >= text.Length || text[reader.At] != '#')
        {
            return Refuse(NcRefusalCodes.BadExpression, block, FormattableString.Invariant($"column {reader.At + 1}: GOTO, or THEN with an assignment, is expected behind a condition."));
        }

        return holds ? Assign(block, text, reader.At) : FlowAction.Continue;
    }

    private FlowAction GoTo(int block, ExpressionReader reader)
    {
        var value = reader.Operand();
        return Check(ref reader, block) && TryCount(block, value, "the target of the jump", out var number) ? JumpToNumber(block, number) : FlowAction.Stop;
    }

    // A code that calls among the collected words, and where its arguments begin.
    private bool TryMacroCode(int block, out NcMeaning meaning, out int tenths, out int at)
    {
        (meaning, tenths, at) = (NcMeaning.Unknown, 0, 0);
        for (var i = 0; i < _words.Count; i++)
        {
            if (_words[i].Letter != 'G' || !TryCount(block, _words[i].Value, "the number of a G code", out _))
            {
                continue;
            }

            tenths = (int)Math.Clamp(Math.Round(10 * _words[i].Value.Number), -1, DialectTables.Codes);
            meaning = _dialect.MeaningOf(tenths);
            if (meaning.Steers() && tenths == 10 * _words[i].Value.Number)
            {
                at = i + 1;
                return true;
            }
        }

        return false;
    }

    private FlowAction CallNumber(int block, NcValue program)
    {
        if (!TryProgram(block, program, isLocal: false, out var number, out var passes))
        {
            return FlowAction.Stop;
        }

        if (passes == 0)
        {
            return FlowAction.Continue;
        }

        return UnitOf(number) is { } unit ? Enter(new() { Unit = unit, First = unit.First, Caller = block, Passes = passes }) : Missing(block, FlowIndex.NumberName(number));
    }

    private FlowAction CallMacro(int block, int at, bool modal)
    {
        var program = NcValue.Vacant;
        foreach (var (letter, value) in _words)
        {
            program = letter == 'P' ? value : program;
        }

        if (!TryProgram(block, program, isLocal: false, out var number, out var passes))
        {
            return FlowAction.Stop;
        }

        if (UnitOf(number) is not { } unit)
        {
            return Missing(block, FlowIndex.NumberName(number));
        }

        var arguments = Arguments(at);
        if (!modal)
        {
            return Enter(new() { Unit = unit, First = unit.First, Caller = block, Passes = passes, Arguments = arguments });
        }

        _modalCalls.Add(new(unit, passes, arguments));
        Frame.ModalCalls = _modalCalls.Count;
        _changes++;
        return _modalCalls.Count > _settings.Depth ? Refuse(NcRefusalCodes.CallTooDeep, block, "too many modal calls are active.") : FlowAction.Continue;
    }

    private FlowAction EndModal()
    {
        if (_modalCalls.Count > 0)
        {
            _modalCalls.RemoveAt(_modalCalls.Count - 1);
            _changes++;
        }

        Frame.ModalCalls = Math.Min(Frame.ModalCalls, _modalCalls.Count);
        return FlowAction.Continue;
    }

    private FlowAction CallModal(int block)
    {
        var level = Math.Min(Frame.ModalCalls, _modalCalls.Count) - 1;
        var call = _modalCalls[level];
        return Enter(new() { Unit = call.Unit, First = call.Unit.First, Caller = block, Passes = call.Passes, Arguments = call.Arguments, IsModalMacro = true, ModalCalls = level });
    }

    // Number and repetitions of a call. M98 P51002 is the older form of M98 P1002 L5.
    private bool TryProgram(int block, NcValue program, bool isLocal, out long number, out long passes)
    {
        (number, passes) = (0, 1);
        if (program.IsVacant)
        {
            Refuse(NcRefusalCodes.BadExpression, block, $"the call names no {(isLocal ? "block" : "program")}: P is missing.");
            return false;
        }

        if (!TryCount(block, program, "the number of the called program", out number))
        {
            return false;
        }

        var hasCount = false;
        foreach (var (letter, value) in _words)
        {
            if (letter == 'L' && !value.IsVacant)
            {
                hasCount = true;
                if (!TryCount(block, value, "the number of repetitions", out passes))
                {
                    return false;
                }
            }
        }

        if (!isLocal && !hasCount && number > 9999 && UnitOf(number) is null)
        {
            (passes, number) = (number / 10_000, number % 10_000);
        }

        // LinuxCNC calls nothing with L0.
        if (passes < (_syntax == NcSyntax.LinuxCnc ? 0 : 1) || number < 0)
        {
            Refuse(NcRefusalCodes.BadExpression, block, "the call has a number of repetitions, or of a program, that is not positive.");
        }

        return Refusal is null;
    }

    private FlowUnit? UnitOf(long number)
    {
        var name = FlowIndex.NumberName(number);
        return Unit.Index.Unit(name) ?? (FromLibrary(_syntax == NcSyntax.LinuxCnc ? name[1..].TrimStart('0') : name) is { } index ? index.Unit(name) ?? index.Main : null);
    }

    // Letters to local variables. A second I, J, K belongs to the next three variables (argument specification II).
    private List<(VariablePlace, NcValue)> Arguments(int at)
    {
        var (arguments, set, last) = (new List<(VariablePlace, NcValue)>(), 0, 0);
        foreach (var (letter, value) in _words.Skip(at))
        {
            var local = letter is >= (byte)'A' and <= (byte)'Z' ? LocalOfLetter[letter - 'A'] : 0;
            if (letter is (byte)'I' or (byte)'J' or (byte)'K')
            {
                set += local <= last ? 1 : 0;
                last = local;
                local += 3 * set;
            }

            if (local is > 0 and <= 33)
            {
                arguments.Add((VariablePlace.Numbered(local), value));
            }
        }

        return arguments;
    }
}
