namespace ErrorMatching.Nc;

/// <summary>In what the controls of one family (<see cref="NcSyntax"/>) differ from others beyond their spelling, each with its own name:
/// what follows a block asks for these, and never for the family.</summary>
/// <remarks>What differs between two controls of a family is data of their dialects. Immutable.</remarks>
internal sealed record ControlWays
{
    private static readonly ControlWays Iso = new(NcSyntax.Iso) { SemicolonMayEndBlock = true, CutsToMachinePlaces = false };
    private static readonly ControlWays Okuma = new(NcSyntax.Okuma) { SemicolonMayEndBlock = true };
    private static readonly ControlWays Klartext = new(NcSyntax.Klartext);

    private static readonly ControlWays Siemens = new(NcSyntax.Siemens)
    {
        AssignmentsAreWords = true,
        CallsByAddress = true,
        CallsToolsByName = true,
        OffsetsBelongToTools = true,
        DropsCornerOffPlane = true,
    };

    // LinuxCNC, Interpreter sources interp_convert.cc and interp_cycles.cc; its manual, "G-codes".
    private static readonly ControlWays LinuxCnc = new(NcSyntax.LinuxCnc)
    {
        SpacesInNumbers = true,
        ReadsFeedBeforeUnits = true,
        ListsIdleMoves = true,
        RetractsToR = true,
        OffsetsForOneBlock = true,
        WorkOffsetsTurn = true,
        HasOneShift = true,
    };

    private ControlWays(NcSyntax syntax) => HasCodes = LanguageSpelling.HasCodesIn(syntax);

    /// <summary>Moves are letters with numbers (<c>G1 X10</c>), and modal; elsewhere each block is a statement.</summary>
    public bool HasCodes { get; }

    /// <summary>Spaces may stand inside a number: <c>X1 0</c> is 10.</summary>
    public bool SpacesInNumbers { get; private init; }

    /// <summary>A semicolon may end a block, so that words behind it are executed; elsewhere it always begins a comment.</summary>
    public bool SemicolonMayEndBlock { get; private init; }

    /// <summary>An assignment stands among the words of a block and can be one of them (<c>X=10</c>); elsewhere only the flow executes
    /// assignments.</summary>
    public bool AssignmentsAreWords { get; private init; }

    /// <summary>An address calls a program by its number: <c>L100</c>.</summary>
    public bool CallsByAddress { get; private init; }

    /// <summary>A tool can have a name: <c>T="MILL_8"</c>.</summary>
    public bool CallsToolsByName { get; private init; }

    /// <summary>Each tool has its own offsets, from D1 on; elsewhere one table has those of all tools.</summary>
    public bool OffsetsBelongToTools { get; private init; }

    /// <summary>The feed of a block counts in the units before it, although the block changes them.</summary>
    public bool ReadsFeedBeforeUnits { get; private init; }

    /// <summary>There is a motion for each step of a cycle and for each block with a straight move, even if it leads nowhere.</summary>
    public bool ListsIdleMoves { get; private init; }

    /// <summary>Cycles retract to R before a program chooses (G99); elsewhere to where they began (G98).</summary>
    public bool RetractsToR { get; private init; }

    /// <summary>The offset of a tool's radius (D) is for its own block; elsewhere it stays selected.</summary>
    public bool OffsetsForOneBlock { get; private init; }

    /// <summary>Work offsets can turn the part (G10 L2 R).</summary>
    public bool WorkOffsetsTurn { get; private init; }

    /// <summary>G52 and G92 set one shift; elsewhere that of G52 is added on top and kept separately.</summary>
    public bool HasOneShift { get; private init; }

    /// <summary>A move to a place of the machine (G53) is a cut in G1; elsewhere always a rapid.</summary>
    public bool CutsToMachinePlaces { get; private init; } = true;

    /// <summary>A chamfer or rounding before a move that leaves the plane alone is not inserted.</summary>
    public bool DropsCornerOffPlane { get; private init; }

    /// <summary>The ways of a family.</summary>
    public static ControlWays Of(NcSyntax syntax) => syntax switch
    {
        NcSyntax.Iso => Iso,
        NcSyntax.LinuxCnc => LinuxCnc,
        NcSyntax.Siemens => Siemens,
        NcSyntax.Klartext => Klartext,
        NcSyntax.Okuma => Okuma,
        _ => throw new System.Diagnostics.UnreachableException($"{syntax}"),
    };
}
