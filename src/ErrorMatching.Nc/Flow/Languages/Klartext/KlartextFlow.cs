namespace ErrorMatching.Nc;

/// <summary>Labels, repeats, calls and Q parameters of Heidenhain Klartext.</summary>
internal sealed class KlartextFlow(
    CallStack calls, FlowReport report, FlowMemory memory, FlowCourse course, FlowLibrary library, FlowAlarms alarms)
    : LanguageFlow
{
    private readonly KlartextFunctions _functions = new(calls, report, memory, course, alarms);

    public override FlowAction Execute(int block, ReadOnlySpan<byte> text, BlockHead head)
    {
        foreach (ref readonly var token in new NcTokenizer(text, 0, text.Length, NcSyntax.Klartext))
        {
            if (token.Start < head.At)
            {
                continue;
            }

            var statement = text[..token.End];
            return token.Kind switch
            {
                NcTokenKind.Assignment => _functions.Assign(block, statement, token.Start),
                NcTokenKind.Keyword => Statement(block, statement, token.Start, head),
                _ => FlowAction.Words,
            };
        }

        return FlowAction.Words;
    }

    public override bool TryValue(int block, ReadOnlySpan<byte> text, int at, out NcValue value)
    {
        var reader = new KlartextFormula(text, at, memory.Variables);
        value = reader.SignedOperand();
        return _functions.Check(ref reader, block);
    }

    private FlowAction Statement(int block, ReadOnlySpan<byte> text, int at, BlockHead head)
    {
        var keyword = text[at..];
        var name = NcText.Decode(LanguageSpelling.Of(NcSyntax.Klartext)!.NameOf(keyword)).ToUpperInvariant();
        switch (name)
        {
            case "LBL":
                return text.Slice(head.LabelAt, head.LabelLength).SequenceEqual("0"u8) && calls.Frames.Count > 1 && calls.Frame.IsPart
                    ? course.Return(block)
                    : FlowAction.Continue;
            case "CALLLBL":
                return CallLabel(block, text, at);
            case "CALLPGM":
                return CallProgram(block, keyword);
            case "ENDPGM":
                return calls.Frames.Count > 1 && calls.Frame.IsPart ? course.Ended() : course.ReturnOrEnd(block);
            case "SELPGM" or "CALLSELECTED" or "IF" or "DECLARE":
                return report.RefuseCall(block, name);
            default:
                return name.StartsWith("FN", StringComparison.Ordinal) && name.Length > 2
                    ? _functions.Execute(block, text, at, name[2..])
                    : FlowAction.Words;
        }
    }

    // CALL LBL 5 executes the part from the label to the next LBL 0. With REP n, the section from the label to this block runs n more
    // times.
    private FlowAction CallLabel(int block, ReadOnlySpan<byte> text, int at)
    {
        var reader = new KlartextFormula(text, at, memory.Variables);
        reader.TakeWord("CALL");
        reader.TakeWord("LBL");
        var label = reader.Label();
        var repeats = reader.TakeWord("REP");
        var count = repeats ? reader.SignedOperand() : NcValue.Zero;
        if (repeats && reader.Take((byte)'/'))
        {
            // REP 3/3 shows how many are left.
            reader.SignedOperand();
        }

        if (!_functions.Check(ref reader, block) || !memory.TryCount(block, count, "the number of repeats", out var passes))
        {
            return FlowAction.Stop;
        }

        if (_functions.TargetOf(label) is not (>= 0 and var target))
        {
            return _functions.MissingLabel(block, label);
        }

        if (!repeats)
        {
            return course.Enter(new() { Unit = calls.Unit, First = target + 1, Caller = block, IsPart = true });
        }

        if (target > block)
        {
            return report.Refuse(NcRefusalCodes.MissingLabel, block, $"the section from label {label} does not end here: it begins later.");
        }

        var counters = calls.Frame.Counters;
        var left = counters.GetValueOrDefault(block, passes);
        course.Change();
        if (left <= 0)
        {
            counters.Remove(block);
            return FlowAction.Continue;
        }

        counters[block] = left - 1;
        return course.GoTo(block, target);
    }

    // Q parameters are common to all programs, QL parameters belong to one.
    private FlowAction CallProgram(int block, ReadOnlySpan<byte> keyword)
    {
        var name = NcText.Decode(keyword).Trim();
        name = name[(name.IndexOf("PGM", StringComparison.OrdinalIgnoreCase) + 3)..].Trim(' ', '\t', '"');
        name = name.EndsWith(".H", StringComparison.OrdinalIgnoreCase) ? name[..^2] : name;
        if (name.Length == 0 || name.AsSpan().IndexOfAny("\\/:") >= 0)
        {
            return report.RefuseCall(block, "CALL PGM with a folder");
        }

        var file = library.Find(name.ToUpperInvariant());
        if (file is not null && UnitOf(file.Program) is { } unit && UnitOf(calls.Program) is { } own && unit != own)
        {
            return report.RefuseCall(block, "CALL PGM of a program in another unit");
        }

        return file is not null
            ? course.Enter(new() { Unit = file.Main, First = file.Main.First, Caller = block, Arguments = [] })
            : report.Missing(block, name);
    }

    // The last word of the heading; null if there is none.
    private static string? UnitOf(NcProgram program)
    {
        for (var i = 0; i < program.BlockCount; i++)
        {
            var words = program.TextOf(program[i]).Split(';')[0].ToUpperInvariant().Split(' ', StringSplitOptions.RemoveEmptyEntries);
            var begin = Array.IndexOf(words, "BEGIN");
            if (begin is 0 or 1 && words[^1] is "MM" or "INCH")
            {
                return words[^1];
            }

            if (words.Length > 0)
            {
                return null;
            }
        }

        return null;
    }
}
