namespace ErrorMatching.Nc;

/// <summary>Assignments to Q parameters and the functions FN 0 to FN 38 of Klartext.</summary>
internal sealed class KlartextFunctions(
    CallStack calls, FlowReport report, FlowMemory memory, FlowCourse course, FlowAlarms alarms)
{
    /// <summary>Difference up to which two unequal values could be equal on the control, whose numbers have fewer digits.</summary>
    private const double Close = 1e-6;

    /// <summary>Q1 = formula.</summary>
    public FlowAction Assign(int block, ReadOnlySpan<byte> text, int at)
    {
        var reader = new KlartextFormula(text, at, memory.Variables);
        var place = reader.Parameter();
        reader.Expect((byte)'=');
        var isText = KlartextFormula.IsText(place);
        var value = isText ? NcValue.Unknown : reader.Formula();
        return (isText || Ends(ref reader)) && Check(ref reader, block)
            ? memory.Assigned(block, place, value, at)
            : Refused(ref reader, block);
    }

    /// <summary>FN with a number.</summary>
    public FlowAction Execute(int block, ReadOnlySpan<byte> text, int at, string number)
    {
        var colon = text[at..].IndexOf((byte)':');
        var reader = new KlartextFormula(text, colon < 0 ? text.Length : at + colon + 1, memory.Variables);
        switch (number)
        {
            case "0" or "1" or "2" or "3" or "4" or "5" or "6" or "7" or "8":
                return Compute(block, ref reader, number);
            case "9" or "10" or "11" or "12":
                return JumpIf(block, ref reader, number);
            case "13" or "18" or "28":
                return Forget(block, ref reader, number);
            case "14":
                return report.Refuse(NcRefusalCodes.BadExpression, block, "the program stops here with an error (FN 14).");
            case "15" or "16" or "20" or "26" or "27" or "38":
                // Output, and waiting.
                return FlowAction.Continue;
            case "17" or "19" or "29":
                // Values of the system and of the machine: offsets, too.
                memory.Variables.Write(VariablePlace.Machine, NcValue.Unknown);
                return FlowAction.Continue;
            default:
                return report.Refuse(NcRefusalCodes.BadExpression, block, $"what FN {number} does is not known.");
        }
    }

    /// <summary>The block of a label; -1 if the program has none.</summary>
    public int TargetOf(string label) =>
        calls.Unit.Index.FindLabel(calls.Unit, calls.Unit.First - 1, label, forward: true, backward: false);

    public FlowAction MissingLabel(int block, string label) =>
        report.Refuse(NcRefusalCodes.MissingLabel, block, $"it goes to label {label}, which does not exist in this program.");

    /// <summary>True if there is no error; otherwise sets the refusal.</summary>
    public bool Check(ref KlartextFormula reader, int block)
    {
        if (reader.Error is not null)
        {
            report.Refuse(NcRefusalCodes.BadExpression, block, reader.ErrorAt + 1, reader.Error + ".");
        }

        return report.Refusal is null;
    }

    private FlowAction Compute(int block, ref KlartextFormula reader, string number)
    {
        var place = reader.Parameter();
        reader.Expect((byte)'=');
        var value = number switch
        {
            "5" or "6" or "7" => reader.Function(number == "5" ? "SQRT" : number == "6" ? "SIN" : "COS"),
            "0" => reader.SignedOperand(),
            _ => Binary(ref reader, number),
        };
        return Ends(ref reader) && Check(ref reader, block) ? memory.Assigned(block, place, value, reader.At) : Refused(ref reader, block);
    }

    private static NcValue Binary(ref KlartextFormula reader, string number)
    {
        var a = reader.SignedOperand();
        switch (number)
        {
            case "1": reader.Expect((byte)'+'); break;
            case "2": reader.Expect((byte)'-'); break;
            case "3": reader.Expect((byte)'*'); break;
            case "4": reader.ExpectDivision(); break;
            default: reader.ExpectWord("LEN"); break;
        }

        var b = reader.SignedOperand();
        return number switch
        {
            "1" => reader.Apply(ExpressionOperator.Add, a, b),
            "2" => reader.Apply(ExpressionOperator.Subtract, a, b),
            "3" => reader.Apply(ExpressionOperator.Multiply, a, b),
            "4" => reader.Apply(ExpressionOperator.Divide, a, b),
            _ => a.IsNumber && b.IsNumber ? NcValue.Of(Math.Sqrt((a.Number * a.Number) + (b.Number * b.Number))) : NcValue.Unknown,
        };
    }

    // FN 9: IF +Q1 EQU +Q2 GOTO LBL 5
    private FlowAction JumpIf(int block, ref KlartextFormula reader, string number)
    {
        reader.ExpectWord("IF");
        var a = reader.SignedOperand();
        reader.ExpectWord(number switch { "9" => "EQU", "10" => "NE", "11" => "GT", _ => "LT" });
        var b = reader.SignedOperand();
        reader.ExpectWord("GOTO");
        reader.ExpectWord("LBL");
        var label = reader.Label();
        if (!Ends(ref reader) || !Check(ref reader, block))
        {
            return Refused(ref reader, block);
        }

        memory.HasComputed = true;
        var difference = a.Number - b.Number;
        var isClose = difference != 0 && Math.Abs(difference) < Close * Math.Max(1, Math.Abs(a.Number));
        if (a.IsNumber && b.IsNumber && isClose)
        {
            return report.Refuse(NcRefusalCodes.UnknownCondition, block,
                "which way the program goes hangs on the last digits of a computed value.");
        }

        if ((!a.IsNumber || !b.IsNumber) && TargetOf(label) is >= 0 and var end && alarms.OnlyStopsFrom(end, block))
        {
            return FlowAction.Continue;
        }

        var either = false;
        if ((!a.IsNumber || !b.IsNumber) && !memory.TryEitherWay(block, out either))
        {
            return FlowAction.Stop;
        }

        var holds = !a.IsNumber || !b.IsNumber ? either
            : number switch { "9" => difference == 0, "10" => difference != 0, "11" => difference > 0, _ => difference < 0 };
        return !holds ? FlowAction.Continue
            : TargetOf(label) is >= 0 and var target ? course.Jump(block, target)
            : MissingLabel(block, label);
    }

    // Functions whose result only the machine knows, or whose definition has no source: each parameter that is named becomes unknown.
    private FlowAction Forget(int block, ref KlartextFormula reader, string number)
    {
        reader.TakeWord("SYSREAD");
        reader.TakeWord("TABREAD");
        var place = reader.Parameter();
        reader.Expect((byte)'=');
        return Check(ref reader, block) ? memory.Assigned(block, place, NcValue.Unknown, reader.At)
            : report.Refuse(NcRefusalCodes.BadExpression, block, $"FN {number} names no parameter for its result.");
    }

    private static bool Ends(ref KlartextFormula reader)
    {
        if (reader.Error is null && !reader.IsAtEnd)
        {
            reader.Fail("the statement should end here");
        }

        return reader.Error is null;
    }

    private FlowAction Refused(ref KlartextFormula reader, int block)
    {
        Check(ref reader, block);
        return FlowAction.Stop;
    }
}
