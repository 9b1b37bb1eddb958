namespace ErrorMatching.Nc;

/// <summary>The computing part of a language whose blocks are statements: its variables, conditions, jumps and calls.</summary>
internal abstract class LanguageFlow
{
    /// <summary>The flow of a syntax; null if its blocks are letters with numbers.</summary>
    public static LanguageFlow? Of(NcSyntax syntax, CallStack calls, FlowReport report, FlowMemory memory, FlowCourse course,
        FlowLibrary library) =>
        syntax == NcSyntax.Klartext ? new KlartextFlow(calls, report, memory, course, library) : null;

    /// <summary>Executes what a block does before its words are read.</summary>
    /// <param name="block">The block.</param>
    /// <param name="text">Its bytes.</param>
    /// <param name="head">Its head.</param>
    public abstract FlowAction Execute(int block, ReadOnlySpan<byte> text, BlockHead head);

    /// <summary>Computes the value of a word, which ends with the text.</summary>
    /// <returns>False if there is a refusal.</returns>
    public abstract bool TryValue(int block, ReadOnlySpan<byte> text, int at, out NcValue value);
}
