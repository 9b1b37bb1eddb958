using System.Globalization;
using System.Text;

namespace ErrorMatching.Nc;

/// <content>
/// What the roles of a dialect do to the run of a program. All are decided here; one that has no way of its own is refused.
/// </content>
internal sealed partial class NcFlow
{
    /// <summary>True if the block last given to <see cref="Behind"/> had a word that steers, and it was executed.</summary>
    public bool HasSteered { get; private set; }

    /// <summary>Refuses a call that cannot be executed, or a block with two words that steer.</summary>
    public FlowAction RefuseCall(int block, string word) => Refuse(
        NcRefusalCodes.MissingProgram,
        block,
        $"{word} calls a program in a way that is not followed, or one that is looked for elsewhere: what it does is not known. "
            + "Put its blocks in the place of the call.");

    /// <summary>Passes over a block that is not executed.</summary>
    public FlowAction Skip(int block)
    {
        if (_frames.Count > 0 && block >= Unit.End)
        {
            return AtEnd(block);
        }

        Next = block + 1;
        return BehindRegion(block);
    }

    private FlowAction Steer(int block, FunctionRole role, long function, NcValue program)
    {
        HasSteered = true;
        return (role, _syntax) switch
        {
            (FunctionRole.ProgramEnd or FunctionRole.Return, NcSyntax.Siemens) => Returned(block),
            (FunctionRole.ProgramEnd, _) => Ended(),
            (FunctionRole.Return, _) => ReturnTo(block, program),
            (FunctionRole.Call, NcSyntax.Iso or NcSyntax.LinuxCnc) => CallNumber(block, program),
            (FunctionRole.LocalCall, NcSyntax.Iso or NcSyntax.LinuxCnc) => CallLocal(block, program),
            _ => RefuseCall(block, FormattableString.Invariant($"M{function}")),
        };
    }

    private FlowAction Steer(int block, NcMeaning meaning, int tenths, int argumentsAt)
    {
        HasSteered = true;
        return (meaning, _syntax) switch
        {
            (NcMeaning.Call, NcSyntax.Iso) => CallMacro(block, argumentsAt, modal: false),
            (NcMeaning.ModalCall, NcSyntax.Iso) => CallMacro(block, argumentsAt, modal: true),
            (NcMeaning.ModalCallOff, NcSyntax.Iso) => EndModal(),
            _ => RefuseCall(block, "G" + (tenths / 10m).ToString(CultureInfo.InvariantCulture)),
        };
    }

    // The word that steers among those of the block: a code before functions, since what stands behind it is its arguments.
    private FlowAction SteerByWords(int block, bool moved)
    {
        if (TryMacroCode(block, out var meaning, out var tenths, out var at))
        {
            return Steer(block, meaning, tenths, at);
        }

        var (found, function, program) = (FunctionRole.Harmless, 0L, NcValue.Vacant);
        foreach (var (letter, value) in _words)
        {
            if (letter == 'P')
            {
                program = value;
            }
            else if (letter == 'M')
            {
                if (!TryCount(block, value, "the number of the M function", out var number))
                {
                    return FlowAction.Stop;
                }

                var role = _dialect.FunctionOf((int)Math.Clamp(number, -1, int.MaxValue));
                if (role.Steers() && found.Steers() && role != found)
                {
                    var message = FormattableString.Invariant(
                        $"M{function} and M{number} each say how the program goes on; the block can have one of them.");
                    return Refuse(NcRefusalCodes.BadExpression, block, message);
                }

                (found, function) = role.Steers() ? (role, number) : (found, function);
            }
        }

        return Refusal is not null ? FlowAction.Stop
            : found.Steers() ? Steer(block, found, function, program)
            : moved && HasModalCall ? CallModal(block)
            : FlowAction.Continue;
    }

    // M97 P100: the blocks of this program from N100 on.
    private FlowAction CallLocal(int block, NcValue program)
    {
        if (!TryProgram(block, program, isLocal: true, out var number, out var passes))
        {
            return FlowAction.Stop;
        }

        if (passes == 0)
        {
            return FlowAction.Continue;
        }

        var target = Unit.Index.FindNumber(Unit, block, number);
        if (target < 0)
        {
            var message = FormattableString.Invariant($"the call goes to block N{number}, which does not exist in this program.");
            return Refuse(NcRefusalCodes.MissingLabel, block, message);
        }

        // From the block found on round the program the next of that number is itself.
        if (Unit.Index.FindNumber(Unit, target, number) != target)
        {
            var message = FormattableString.Invariant($"the call goes to block N{number}, which stands more than once in this program.");
            return Refuse(NcRefusalCodes.BlockAmbiguous, block, message);
        }

        return Enter(new() { Unit = Unit, First = target, Caller = block, Passes = passes });
    }

    // A word that is no program but the control's own.
    private bool IsWord(string name)
    {
        var word = Encoding.UTF8.GetBytes(name);
        return _dialect.MeaningOf(word) != NcMeaning.Unknown || _dialect.RoleOf(word) != LetterRole.Unknown
            || _dialect.IsFlow(word) || _dialect.IsMachineProgram(word);
    }
}
