namespace ErrorMatching.Nc;

/// <summary>The computing part of a language with statements of its own: its variables, conditions, jumps and calls.</summary>
internal abstract class LanguageFlow
{
    /// <summary>The flow of a dialect's syntax; null if it has the common statements.</summary>
    public static LanguageFlow? Of(NcDialect dialect, CallStack calls, FlowReport report, FlowMemory memory, FlowCourse course,
        FlowLibrary library, ModalCalls modal, FlowAlarms alarms) => dialect.Syntax switch
        {
            NcSyntax.Klartext => new KlartextFlow(calls, report, memory, course, library, alarms),
            NcSyntax.Okuma => new OkumaFlow(dialect, calls, report, memory, course, library, modal),
            _ => null,
        };

    /// <summary>Executes what a block does before its words are read.</summary>
    /// <param name="block">The block.</param>
    /// <param name="text">Its bytes.</param>
    /// <param name="head">Its head.</param>
    public abstract FlowAction Execute(int block, ReadOnlySpan<byte> text, BlockHead head);

    /// <summary>Computes the value of a word, which ends with the text.</summary>
    /// <returns>False if there is a refusal.</returns>
    public abstract bool TryValue(int block, ReadOnlySpan<byte> text, int at, out NcValue value);
}
