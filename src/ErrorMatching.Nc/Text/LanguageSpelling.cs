namespace ErrorMatching.Nc;

/// <summary>The spelling of a language whose blocks are statements, not letters with numbers. It splits its blocks itself, into tokens
/// of the same kinds, so that nothing behind it knows the language.</summary>
internal abstract class LanguageSpelling
{
    private static readonly LanguageSpelling Klartext = new KlartextSpelling();

    /// <summary>The spelling of a syntax; null if its blocks are letters with numbers.</summary>
    public static LanguageSpelling? Of(NcSyntax syntax) => syntax == NcSyntax.Klartext ? Klartext : null;

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

    /// <summary>True for the keyword that begins a program.</summary>
    public abstract bool IsHeading(ReadOnlySpan<byte> keyword);

    /// <summary>The label that a keyword defines, without quotation marks; empty if it defines none.</summary>
    public abstract ReadOnlySpan<byte> LabelOf(ReadOnlySpan<byte> keyword);

    /// <summary>A comment, as a line of its own.</summary>
    public abstract string CommentLine(string text);
}
