namespace ErrorMatching.Nc;

/// <summary>Siemens statements, by their first word.</summary>
internal sealed class SiemensStatements(
    NcDialect dialect,
    FlowCourse course,
    FlowReport report,
    SiemensJumps jumps,
    SiemensArrays arrays,
    SiemensCalls named,
    SiemensAssignments assignments)
{
    public FlowAction Execute(int block, ReadOnlySpan<byte> text, BlockHead head)
    {
        var length = BlockHead.NameLength(text, head.At);
        var end = head.At + length;
        var word = length is > 1 and <= 8 ? NcText.Decode(text.Slice(head.At, length)).ToUpperInvariant() : "";
        switch (word)
        {
            case "IF": return jumps.If(block, text, end);
            case "GOTO" or "GOTOF" or "GOTOB" or "GOTOC" or "GOTOS": return jumps.GoToLabel(block, text, head.At, jumps: true, out _);
            case "CASE": return jumps.Case(block, text, end);
            case "REPEAT" or "REPEATB": return jumps.Repeat(block, text, end, isOneBlock: word.Length == 7);
            case "DEF": return arrays.Define(block, text, end);
            case "PROC": return FlowAction.Continue;
            case "EXTERN": return named.DeclareExternal(text, end);
            case "RET": return course.ReturnOrEnd(block);
            default: return CallOrAssign(block, text, head.At, length);
        }
    }

    private FlowAction CallOrAssign(int block, ReadOnlySpan<byte> text, int at, int length)
    {
        var meaning = dialect.MeaningOf(text.Slice(at, length));
        return meaning == NcMeaning.Call ? named.CallText(block, text, at + length)
            : meaning.Steers() ? report.RefuseCall(block, NcText.Decode(text.Slice(at, length)))
            : SiemensCalls.IsCall(text, at, length) ? named.CallNamed(block, text, at, length)
            : assignments.Assign(block, text, at);
    }
}
