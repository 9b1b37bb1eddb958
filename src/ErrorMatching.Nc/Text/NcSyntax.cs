namespace ErrorMatching.Nc;

/// <summary>How a family of controls spells: what parentheses, brackets and names are.</summary>
public enum NcSyntax : byte
{
    /// <summary>ISO and Fanuc: <c>( )</c> encloses a comment, <c>[ ]</c> an expression, <c>#100</c> is a variable.</summary>
    Iso,

    /// <summary>LinuxCNC: like ISO, with named variables <c>#&lt;depth&gt;</c>, O words, and comments behind <c>;</c>.</summary>
    LinuxCnc,

    /// <summary>Siemens: <c>;</c> begins a comment, <c>( )</c> encloses expressions and arguments, <c>R1</c> and names are variables,
    /// <c>X=</c> assigns an address.</summary>
    Siemens,
}
