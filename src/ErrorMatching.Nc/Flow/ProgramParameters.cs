namespace ErrorMatching.Nc;

/// <summary>The parameters that a Siemens subprogram declares: <c>PROC NAME(REAL A, VAR INT B, REAL C=5)</c>.</summary>
internal sealed class ProgramParameters(NcSyntax syntax, FlowReport report, FlowMemory memory)
{
    // Assigns the arguments of a call to the parameters of PROC, which is the first statement of the subprogram.
    public FlowAction Bind(FlowUnit unit, List<(NcValue Value, VariablePlace? Place)> values, List<(VariablePlace, VariablePlace)> results)
    {
        results.Clear();
        var program = unit.Index.Program;
        for (var block = unit.First; block < unit.End; block++)
        {
            var text = program.BytesOf(program[block]);
            var at = BlockHead.Read(text, syntax).At;
            if (at >= text.Length || text[at] is (byte)';' or (byte)'%')
            {
                continue;
            }

            if (!BlockHead.Stands(text, at, "PROC"u8))
            {
                break;
            }

            return BindParameters(block, text, at + 4, values, results);
        }

        return values.Count == 0
            ? FlowAction.Continue
            : report.Refuse(
                NcRefusalCodes.BadExpression, unit.First, "the program is called with arguments and has no PROC with parameters.");
    }

    private FlowAction BindParameters(
        int block,
        ReadOnlySpan<byte> text,
        int at,
        List<(NcValue Value, VariablePlace? Place)> values,
        List<(VariablePlace, VariablePlace)> results)
    {
        var reader = memory.ReaderAt(text, at);
        var count = 0;
        FlowMemory.Word(ref reader, text);
        if (reader.Take((byte)'('))
        {
            while (reader.Error is null && !reader.Take((byte)')'))
            {
                BindOne(ref reader, text, count < values.Count ? values[count] : default, results);
                count++;
                if (!reader.Take((byte)',') && reader.At < text.Length && text[reader.At] != ')')
                {
                    reader.Fail("\",\" or \")\" is expected here");
                }
            }
        }

        if (reader.Error is null && values.Count > count)
        {
            reader.Fail("the program is called with more arguments than it has parameters");
        }

        return memory.Check(ref reader, block) ? FlowAction.Continue : FlowAction.Stop;
    }

    private void BindOne(
        ref ExpressionReader reader,
        ReadOnlySpan<byte> text,
        (NcValue Value, VariablePlace? Place) given,
        List<(VariablePlace, VariablePlace)> results)
    {
        var word = FlowMemory.Word(ref reader, text);
        var isReference = word == "VAR";
        word = isReference ? FlowMemory.Word(ref reader, text) : word;
        if (FlowMemory.TypeOf(word) is not { } type)
        {
            reader.Fail("the type of a parameter (REAL, INT, BOOL, STRING) is expected here");
            return;
        }

        FlowMemory.SkipBrackets(ref reader, text);
        var name = FlowMemory.Word(ref reader, text);
        if (reader.Error is not null || name.Length == 0)
        {
            reader.Fail("the name of a parameter is expected here");
            return;
        }

        FlowMemory.SkipBrackets(ref reader, text);
        var parameter = memory.Variables.Define(name, type, 1, 1);
        var preset = reader.Take((byte)'=') ? reader.Expression() : parameter.Values[0];
        parameter.Values[0] = parameter.Converted(given.Value.IsVacant ? preset : given.Value);
        if (isReference && given.Place is { } outside)
        {
            results.Add((VariablePlace.Named(name), outside));
        }
    }
}
