using System.Globalization;

namespace ErrorMatching.Nc;

/// <summary>Variables, branches and calls of Okuma OSP: <c>VC1=5</c>, <c>IF [VC1 EQ 5] NLAP</c>, <c>GOTO NLAP</c>,
/// <c>CALL O100 Q2 PA=1</c>, <c>RTS</c>, <c>MODIN O100</c> and <c>MODOUT</c>.</summary>
internal sealed class OkumaFlow(
    NcDialect dialect,
    CallStack calls,
    FlowReport report,
    FlowMemory memory,
    FlowCourse course,
    FlowLibrary library,
    ModalCalls modal)
    : LanguageFlow
{
    // The blocks before this one say nothing.
    private int _silent;

    public override FlowAction Execute(int block, ReadOnlySpan<byte> text, BlockHead head)
    {
        var (assigns, computes, hasWords) = (false, false, false);
        foreach (ref readonly var token in new NcTokenizer(text, 0, text.Length, NcSyntax.Okuma))
        {
            if (token.Start < head.At || token.Kind is NcTokenKind.Space or NcTokenKind.Comment)
            {
                continue;
            }

            if (token.Kind == NcTokenKind.Percent
                || (token.Start == head.At && token is { Kind: NcTokenKind.Label } or { Kind: NcTokenKind.Word, Letter: (byte)'O' }))
            {
                if (BeginsAnother(block))
                {
                    return course.AtEnd(block);
                }
            }
            else if (token.Kind == NcTokenKind.Keyword && token.Start == head.At
                && dialect.MeaningOf(text[token.Start..(token.Start + BlockHead.NameLength(text, token.Start))]) == NcMeaning.OpaqueCall)
            {
                return Statement(block, text[..token.End], token.Start);
            }
            else if (token.Kind == NcTokenKind.Assignment)
            {
                assigns = true;
                if (Assign(block, text[..token.End], token.Start) == FlowAction.Stop)
                {
                    return FlowAction.Stop;
                }
            }
            else
            {
                hasWords = true;
                computes |= token.Kind == NcTokenKind.ExpressionWord;
            }
        }

        return assigns && computes
            ? report.Refuse(NcRefusalCodes.BadExpression, block,
                "a block that sets a variable also computes a word: which comes first is not known. Begin a block for the variable.")
            : hasWords ? FlowAction.Words : FlowAction.Continue;
    }

    public override bool TryValue(int block, ReadOnlySpan<byte> text, int at, out NcValue value)
    {
        var reader = new OkumaFormula(text, at, memory.Variables);
        value = reader.Sum();
        value = value.IsNumber ? value : NcValue.Unknown;
        return Ends(ref reader, block);
    }

    // The start of another program ends this one. Without a call, the index of the file is not needed to know it.
    private bool BeginsAnother(int block)
    {
        if (calls.Frames.Count > 0)
        {
            return block >= calls.Unit.End;
        }

        for (; _silent < block; _silent++)
        {
            var text = calls.Program.BytesOf(calls.Program[_silent]);
            var at = BlockHead.Read(text, NcSyntax.Okuma).At;
            if (at < text.Length && text[at] is not ((byte)'$' or (byte)'%' or (byte)';'))
            {
                return true;
            }
        }

        return false;
    }

    private FlowAction Assign(int block, ReadOnlySpan<byte> text, int at)
    {
        var reader = new OkumaFormula(text, at, memory.Variables);
        var place = reader.Place();
        reader.Expect((byte)'=');
        var value = reader.Value();
        if (!Ends(ref reader, block))
        {
            return FlowAction.Stop;
        }

        // Signals and messages of the machine change no offset.
        var name = text.Slice(at, BlockHead.NameLength(text, at));
        return place.Kind == VariableKind.Machine && dialect.RoleOf(name) == LetterRole.Harmless
            ? FlowAction.Continue
            : memory.Assigned(block, place, value, at);
    }

    private FlowAction Statement(int block, ReadOnlySpan<byte> text, int at)
    {
        var reader = new OkumaFormula(text, at, memory.Variables);
        switch (reader.Name())
        {
            case "IF":
                return If(block, ref reader);
            case "GOTO":
                return GoTo(block, ref reader, holds: true);
            case "CALL" when !modal.AreActive:
                return Call(block, ref reader, isModal: false);
            case "MODIN" when !modal.AreActive:
                return Call(block, ref reader, isModal: true);
            case "MODOUT":
                return Ends(ref reader, block) ? modal.End() : FlowAction.Stop;
            case "RTS" when !modal.AreActive:
                return Ends(ref reader, block) ? course.ReturnOrEnd(block) : FlowAction.Stop;
            case var name:
                return report.RefuseCall(block, modal.AreActive ? $"{name} while MODIN is active" : name);
        }
    }

    // IF [VC1 EQ 5] NLAP, also with GOTO.
    private FlowAction If(int block, ref OkumaFormula reader)
    {
        var value = reader.Bracket();
        if (!Check(ref reader, block))
        {
            return FlowAction.Stop;
        }

        memory.HasComputed = true;
        var holds = value.Number != 0;
        if (!value.IsNumber && !memory.TryEitherWay(block, out holds))
        {
            return FlowAction.Stop;
        }

        reader.TakeWord("GOTO");
        return GoTo(block, ref reader, holds);
    }

    private FlowAction GoTo(int block, ref OkumaFormula reader, bool holds)
    {
        var name = NameWith(ref reader, 'N', "the name of a block, such as N100 or NLAP, is expected here");
        return !Ends(ref reader, block) ? FlowAction.Stop : holds ? Jump(block, name) : FlowAction.Continue;
    }

    private FlowAction Jump(int block, string name)
    {
        var isNumber = long.TryParse(name.AsSpan(1), NumberStyles.None, CultureInfo.InvariantCulture, out var number);
        var index = calls.Unit.Index;
        int Find(int from) => isNumber ? index.FindNumber(calls.Unit, from, number) : index.FindLabel(calls.Unit, from, name);
        var target = Find(block);
        return target < 0
            ? report.Refuse(NcRefusalCodes.MissingLabel, block, $"the jump goes to {name}, which does not exist in this program.")
            : Find(target) != target
            ? report.Refuse(NcRefusalCodes.BlockAmbiguous, block, $"the jump goes to {name}, which stands more than once in this program.")
            : course.Jump(block, target);
    }

    // CALL O100 Q2 PA=1 PB=VC1
    private FlowAction Call(int block, ref OkumaFormula reader, bool isModal)
    {
        var name = NameWith(ref reader, 'O', "the name of a program, such as O100, is expected here");
        var (passes, arguments) = (NcValue.Of(1), new List<(VariablePlace, NcValue)>());
        while (reader.Error is null && !reader.IsAtEnd)
        {
            if (reader.TakeRepeats(out var repeats))
            {
                passes = repeats;
                continue;
            }

            var place = reader.Place();
            reader.Expect((byte)'=');
            var value = reader.Value();
            if (place.Name is not { } argument || argument[0] == '_')
            {
                reader.Fail("only names can be set for a called program");
            }

            arguments.Add((place, value));
        }

        if (!Check(ref reader, block) || !memory.TryCount(block, passes, "the number of repetitions", out var count))
        {
            return FlowAction.Stop;
        }

        if (count < 1)
        {
            return report.Refuse(NcRefusalCodes.BadExpression, block, "the call has a number of repetitions that is not positive.");
        }

        if ((calls.Unit.Index.Unit(name) ?? library.Find(name)?.Unit(name)) is not { } unit)
        {
            return report.Missing(block, name);
        }

        return isModal ? modal.Begin(block, unit, count, arguments)
            : course.Enter(new() { Unit = unit, First = unit.First, Caller = block, Passes = count, Arguments = arguments });
    }

    // A name that begins with a letter and goes on; the reader fails at any other.
    private static string NameWith(ref OkumaFormula reader, char letter, string expected)
    {
        var at = reader.At;
        var name = reader.Name();
        if (name.Length < 2 || name[0] != letter)
        {
            reader.At = at;
            reader.Fail(expected);
        }

        return name;
    }

    private bool Ends(ref OkumaFormula reader, int block)
    {
        if (reader.Error is null && !reader.IsAtEnd)
        {
            reader.Fail("the statement should end here");
        }

        return Check(ref reader, block);
    }

    private bool Check(ref OkumaFormula reader, int block)
    {
        if (reader.Error is not null)
        {
            report.Refuse(NcRefusalCodes.BadExpression, block, reader.ErrorAt + 1, reader.Error + ".");
        }

        return report.Refusal is null;
    }
}
