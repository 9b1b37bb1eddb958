using System.Globalization;

namespace ErrorMatching.Nc;

/// <summary>Applies a dialect's flow roles to the run of a program. It handles all of them; a role without a handler is refused.</summary>
internal sealed class FlowSteering(
    NcDialect dialect,
    FlowReport report,
    FlowMemory memory,
    FlowCourse course,
    MacroCalls macros,
    IsoWords words,
    ModalCalls modal)
{
    /// <summary>True if the block last given to <see cref="ExecuteCalls"/> had a flow word that was executed.</summary>
    public bool HasSteered { get; private set; }

    /// <summary>Executes what a block does after its words.</summary>
    public FlowAction ExecuteCalls(int block, ReadOnlySpan<byte> text, bool moved)
    {
        HasSteered = false;
        return dialect.Syntax == NcSyntax.Siemens ? BehindSiemens(block, text)
            : LanguageSpelling.Of(dialect.Syntax) is not null ? BehindTokens(block, text, moved)
            : words.TryFinish(block, text) ? SteerByWords(block, moved)
            : FlowAction.Stop;
    }

    private FlowAction BehindSiemens(int block, ReadOnlySpan<byte> text)
    {
        for (var at = 0; at < text.Length && text[at] != ';';)
        {
            var length = BlockHead.NameLength(text, at);
            if (length > 1 && (text[at] | 0x20) == 'm' && BlockHead.NumberAt(text, at + 1) is var number && number.Length == length - 1
                && dialect.FunctionOf((int)Math.Min(number.Value, int.MaxValue)) is var role && role.Steers())
            {
                return Steer(block, role, number.Value, NcValue.Vacant);
            }

            // Digits belong to what they follow: the 3 of 1EX3 is not a word.
            at += Math.Max(1, length);
            if (text[at - 1] == '"' && text[at..].IndexOf((byte)'"') is >= 0 and var close)
            {
                at += close + 1;
            }
        }

        return FlowAction.Continue;
    }

    // The words of a language are its tokens, and none is an argument of another.
    private FlowAction BehindTokens(int block, ReadOnlySpan<byte> text, bool moved)
    {
        foreach (ref readonly var token in new NcTokenizer(text, 0, text.Length, dialect.Syntax))
        {
            if (token is { Kind: NcTokenKind.Word, Letter: (byte)'M' }
                && dialect.FunctionOf((int)Math.Clamp(token.Number.Digits, -1, int.MaxValue)) is var role && role.Steers())
            {
                return Steer(block, role, token.Number.Digits, NcValue.Vacant);
            }
        }

        return moved && modal.AreActive ? modal.Call(block) : FlowAction.Continue;
    }

    private FlowAction Steer(int block, FunctionRole role, long function, NcValue program)
    {
        HasSteered = true;
        return (role, dialect.Syntax) switch
        {
            (FunctionRole.ProgramEnd or FunctionRole.Return, NcSyntax.Siemens) => course.ReturnOrEnd(block),
            (FunctionRole.ProgramEnd, _) => course.Ended(),
            (FunctionRole.Return, _) => macros.ReturnTo(block, program),
            (FunctionRole.Call, NcSyntax.Iso or NcSyntax.LinuxCnc) => macros.CallNumber(block, program),
            (FunctionRole.LocalCall, NcSyntax.Iso or NcSyntax.LinuxCnc) => macros.CallLocal(block, program),
            (FunctionRole.MachineJump, _) => report.Refuse(NcRefusalCodes.UnknownCondition, block,
                FormattableString.Invariant($"M{function} goes on where an input of the machine says; the program does not say it.")),
            _ => report.RefuseCall(block, FormattableString.Invariant($"M{function}")),
        };
    }

    private FlowAction Steer(int block, NcMeaning meaning, int tenths, int argumentsAt)
    {
        HasSteered = true;
        return (meaning, dialect.Syntax) switch
        {
            (NcMeaning.Call, NcSyntax.Iso) => macros.CallMacro(block, argumentsAt, modal: false),
            (NcMeaning.ModalCall, NcSyntax.Iso) => macros.CallMacro(block, argumentsAt, modal: true),
            (NcMeaning.ModalCallOff, NcSyntax.Iso) => modal.End(),
            _ => report.RefuseCall(block, "G" + (tenths / 10m).ToString(CultureInfo.InvariantCulture)),
        };
    }

    // Executes the flow word of the block: a code before functions, because the words after it are its arguments.
    private FlowAction SteerByWords(int block, bool moved)
    {
        if (TryMacroCode(block, out var meaning, out var tenths, out var at))
        {
            return Steer(block, meaning, tenths, at);
        }

        var (found, function, program) = (FunctionRole.Harmless, 0L, NcValue.Vacant);
        foreach (var (letter, value) in words.Collected)
        {
            if (letter == 'P')
            {
                program = value;
            }
            else if (letter == 'M')
            {
                if (!memory.TryCount(block, value, "the number of the M function", out var number))
                {
                    return FlowAction.Stop;
                }

                var role = dialect.FunctionOf((int)Math.Clamp(number, -1, int.MaxValue));
                if (role.Steers() && found.Steers() && role != found)
                {
                    var message = FormattableString.Invariant(
                        $"M{function} and M{number} each say how the program goes on; the block can have one of them.");
                    return report.Refuse(NcRefusalCodes.BadExpression, block, message);
                }

                (found, function) = role.Steers() ? (role, number) : (found, function);
            }
        }

        return report.Refusal is not null ? FlowAction.Stop
            : found.Steers() ? Steer(block, found, function, program)
            : moved && modal.AreActive ? modal.Call(block)
            : FlowAction.Continue;
    }

    // A call code among the collected words, and the start of its arguments.
    private bool TryMacroCode(int block, out NcMeaning meaning, out int tenths, out int at)
    {
        (meaning, tenths, at) = (NcMeaning.Unknown, 0, 0);
        for (var i = 0; i < words.Collected.Count; i++)
        {
            if (words.Collected[i].Letter != 'G' || !memory.TryCount(block, words.Collected[i].Value, "the number of a G code", out _))
            {
                continue;
            }

            tenths = (int)Math.Clamp(Math.Round(10 * words.Collected[i].Value.Number), -1, DialectTables.Codes);
            meaning = dialect.MeaningOf(tenths);
            if (meaning.Steers() && tenths == 10 * words.Collected[i].Value.Number)
            {
                at = i + 1;
                return true;
            }
        }

        return false;
    }
}
