namespace ErrorMatching.Nc;

/// <summary>The spelling of a language with statements of its own. It splits its blocks itself, into tokens of the same kinds, so that
/// nothing behind it knows the language.</summary>
internal abstract class LanguageSpelling
{
    private static readonly LanguageSpelling Klartext = new KlartextSpelling();
    private static readonly LanguageSpelling Okuma = new OkumaSpelling();

    /// <summary>The spelling of a syntax; null if the common tokenizer reads it.</summary>
    public static LanguageSpelling? Of(NcSyntax syntax) =>
        syntax == NcSyntax.Klartext ? Klartext : syntax == NcSyntax.Okuma ? Okuma : null;

    /// <summary>True if moves are letters with numbers in a syntax; false if each block is a statement.</summary>
    public static bool HasCodesIn(NcSyntax syntax) => Of(syntax) is not { HasCodes: false };

    /// <summary>True if moves are letters with numbers, as on ISO controls: a block of plain words needs no tokens then, and motions and
    /// increments are modal.</summary>
    public abstract bool HasCodes { get; }

    /// <summary>The token that begins at a position.</summary>
    /// <param name="text">The block.</param>
    /// <param name="at">The position, before the block's end.</param>
    /// <param name="place">What may follow there, and then behind the token.</param>
    public abstract NcToken TokenAt(in BlockScanner text, int at, ref BlockPlace place);

    /// <summary>The name by which a dialect states the meaning of a keyword: without spaces and arguments, in any case.</summary>
    public abstract ReadOnlySpan<byte> NameOf(ReadOnlySpan<byte> keyword);

    /// <summary>True for a keyword that has words behind it, such as coordinates; other keywords contain all up to their comment.</summary>
    /// <param name="name">Its name.</param>
    public abstract bool HasWords(ReadOnlySpan<byte> name);

    /// <summary>True for a keyword that calls or defines a tool.</summary>
    /// <param name="name">Its name.</param>
    public abstract bool NamesTool(ReadOnlySpan<byte> name);

    /// <summary>True for an M function that is a keyword, because it is the control's own and not the machine's.</summary>
    public abstract bool IsKeyword(int function);

    /// <summary>True for the keyword or name that begins a program.</summary>
    public abstract bool IsHeading(ReadOnlySpan<byte> keyword);

    /// <summary>The name of the program that begins at a position, in capitals; empty at the mark of a file; null if none begins
    /// there.</summary>
    public abstract string? ProgramAt(ReadOnlySpan<byte> text, int at);

    /// <summary>The name at the head of a program, if a statement states it; null if not.</summary>
    public virtual string? HeadAt(ReadOnlySpan<byte> text, int at) => ProgramAt(text, at);

    /// <summary>The label that a keyword or name defines, without quotation marks; empty if it defines none.</summary>
    public abstract ReadOnlySpan<byte> LabelOf(ReadOnlySpan<byte> keyword);

    /// <summary>A comment, as a line of its own.</summary>
    public abstract string CommentLine(string text);
}

/// <summary>A place in a block of a language: what may follow there.</summary>
internal enum BlockPlace : byte
{
    /// <summary>Before the block number.</summary>
    Number,

    /// <summary>Before the statement.</summary>
    Statement,

    /// <summary>Among the words after the statement.</summary>
    Words,

    /// <summary>Behind a statement that may continue in the next line.</summary>
    Continued,

    /// <summary>Among the words of a tool call, where an axis stands without a coordinate.</summary>
    Tool,

    /// <summary>Behind the word of a chamfer, whose length has no letter.</summary>
    Chamfer,
}
