namespace ErrorMatching.Nc;

/// <summary>The spelling of a family of controls: the meaning of parentheses, brackets and names.</summary>
public enum NcSyntax : byte
{
    /// <summary>ISO and Fanuc: <c>( )</c> encloses a comment, <c>[ ]</c> an expression, <c>#100</c> is a variable.</summary>
    Iso,

    /// <summary>LinuxCNC: like ISO, with named variables <c>#&lt;depth&gt;</c>, O words, and comments after <c>;</c>.</summary>
    LinuxCnc,

    /// <summary>Siemens: <c>;</c> begins a comment, <c>( )</c> encloses expressions and arguments, <c>R1</c> and names are variables,
    /// <c>X=</c> assigns an address.</summary>
    Siemens,

    /// <summary>Heidenhain Klartext: a block begins with its number and a path function or a statement (<c>12 L X+10 IY-5 R0 FMAX</c>),
    /// <c>;</c> begins a comment, <c>Q1</c> is a variable.</summary>
    Klartext,

    /// <summary>Okuma OSP: letters with numbers, <c>( )</c> encloses a comment, <c>[ ]</c> an expression, <c>VC1</c> and names are
    /// variables, <c>X=VC1</c> assigns an address, <c>NABC</c> names a block.</summary>
    Okuma,
}
