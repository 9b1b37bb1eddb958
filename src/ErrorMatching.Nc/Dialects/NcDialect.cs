namespace ErrorMatching.Nc;

/// <summary>A control's language as data: the meaning of its codes, words and letters, its increments and tolerances. Behavior of a whole
/// family with the same spelling (<see cref="NcSyntax"/>) is in <see cref="ControlWays"/> and in
/// the flow of its language; differences between controls are here.</summary>
/// <remarks>Immutable. Built-in dialects come from <see cref="NcDialects.Named"/>, a shop's own from <see cref="NcDialects.Read"/>; both
/// are JSON files of the same form (<see cref="NcDialects.Schema"/>).</remarks>
public sealed class NcDialect
{
    private readonly DialectTables _tables;
    private readonly Lazy<IReadOnlyList<DialectFact>> _facts;
    private readonly Lazy<IReadOnlySet<int>> _callFunctions;

    internal NcDialect(
        string name, string description, DialectTables tables, IReadOnlyList<DialectFile> files, Func<IReadOnlyList<DialectFact>> facts)
    {
        (Name, Description, _tables, Files, _facts) = (name, description, tables, files, new(facts));
        BlockSkip = tables.BlockSkip;
        Ways = ControlWays.Of(tables.Syntax);
        _callFunctions = new(() => new HashSet<int>(Enumerable.Range(0, DialectTables.Functions).Where(f => Calls(tables.FunctionOf[f]))));
    }

    /// <summary>Name in jobs and on the command line; for a shop's own dialect, the name in its file.</summary>
    public string Name { get; }

    /// <summary>Its purpose, in a sentence.</summary>
    public string Description { get; }

    /// <summary>The shop's files from which it was read, the requested one first; empty for a built-in dialect.</summary>
    public IReadOnlyList<DialectFile> Files { get; }

    /// <summary>Syntax of its programs.</summary>
    public NcSyntax Syntax => _tables.Syntax;

    /// <summary>In what its family differs from other controls beyond the spelling.</summary>
    internal ControlWays Ways { get; }

    /// <summary>True if moves are letters with numbers (<c>G1 X10</c>), false if blocks are statements of a language.</summary>
    public bool HasCodes => Ways.HasCodes;

    /// <summary>True if each block with a motion names it, and each word says whether it is an increment: neither is modal.</summary>
    internal bool BlocksNameMotions => !HasCodes;

    /// <summary>True if a coordinate without a point counts least increments (<c>X100</c> is 0.1 mm), false if it counts millimeters or
    /// inches.</summary>
    public bool IntegersAreIncrements => _tables.IntegersAreIncrements;

    /// <summary>True if results report how coordinates without a point were read: machines of this kind differ, or the dialect's own file
    /// makes them count increments.</summary>
    public bool NotesNumbersWithoutPoint => _tables.NotesNumbersWithoutPoint || _tables.IntegersAreIncrements;

    /// <summary>True if a semicolon ends a block, so that words after it form another one; false if it begins a comment.</summary>
    public bool SemicolonEndsBlock => _tables.SemicolonEndsBlock;

    /// <summary>State of the block skip switches.</summary>
    public BlockSkip BlockSkip { get; private init; }

    /// <summary>The radii that the control uses for cutter compensation, as far as somebody stated them.</summary>
    public ToolRadii ToolRadii { get; private init; } = ToolRadii.None;

    /// <summary>Values of variables that only the machine knows, as far as somebody stated them.</summary>
    public AssumedValues Assumed { get; private init; } = AssumedValues.None;

    /// <summary>Decimals of the least increment in millimeters.</summary>
    public int MetricDecimals => _tables.MetricDecimals;

    /// <summary>Decimals of the least increment in inches.</summary>
    public int InchDecimals => _tables.InchDecimals;

    /// <summary>Largest difference of an arc's two radii that the control is assumed to accept, mm.</summary>
    public double ArcMismatchMm => _tables.ArcMismatchMm;

    /// <summary>The same as a fraction of the radius; the larger of both applies.</summary>
    public double ArcMismatchOfRadius => _tables.ArcMismatchOfRadius;

    /// <summary>Letter of the number of turns of an arc, including the first; 0 if the control has none.</summary>
    public byte TurnsLetter => _tables.TurnsLetter;

    /// <summary>Letters with which a pecking cycle varies its pecks, so that they are not followed, one bit each; bit 0 is A. K among
    /// them is no number of repetitions.</summary>
    public uint PeckLetters => _tables.PeckLetters;

    /// <summary>Letter of the block number at which a called program begins (M98 P100 H20); 0 if the control has none.</summary>
    public byte SequenceLetter => _tables.SequenceLetter;

    /// <summary>True if digits in front of the last four of a program number are repetitions (M98 P51002).</summary>
    public bool RepeatsInNumber => _tables.RepeatsInNumber;

    /// <summary>Letter of the number of a work offset beside its code.</summary>
    public byte WorkOffsetLetter => _tables.WorkOffsetLetter;

    /// <summary>The work offset that is active before a program chooses one: its code times ten.</summary>
    internal int FirstWorkOffset => _tables.FirstWorkOffset;

    /// <summary>True if a line that begins with a dollar sign is a command to the control, not a block.</summary>
    public bool SystemLines => _tables.SystemLines;

    /// <summary>True if programs can have variables, expressions, branches and calls.</summary>
    public bool HasMacros => _tables.HasMacros;

    /// <summary>True if comments that are written have capital letters, digits, spaces and a few signs only; false if any
    /// printable ASCII.</summary>
    public bool CommentCapitals => _tables.CommentCapitals;

    /// <summary>Most characters of a comment, with what encloses it.</summary>
    public int CommentLength => _tables.CommentLength;

    /// <summary>By what the control names its programs.</summary>
    public ProgramNaming ProgramNaming => _tables.ProgramNaming;

    /// <summary>How the control leads the tool's center under cutter compensation.</summary>
    internal CompensationRule Compensation => _tables.Compensation;

    /// <summary>What the control refuses in a block.</summary>
    internal RefusalTable Refusals => _tables.RefusalTable;

    /// <summary>Most characters of a block.</summary>
    internal int LongestLine => _tables.LongestLine;

    /// <summary>What the control does with a parenthesis inside a comment.</summary>
    internal NestedComments NestedComments => _tables.NestedComments;

    /// <summary>How a program changes the control's offsets.</summary>
    internal OffsetRule Offsets => _tables.Offsets;

    /// <summary>All statements of the dialect about its control, each with its source, in the order of a manual: settings, codes,
    /// letters, functions, flow, programs, notes.</summary>
    /// <remarks>If it restates something from a dialect that it continues, only its own statement is listed. Created on first
    /// access.</remarks>
    public IReadOnlyList<DialectFact> Facts => _facts.Value;

    /// <summary>Multi-letter words that branch, loop or define programs; compared without regard to case.</summary>
    public IReadOnlySet<string> FlowKeywords => _tables.Flow;

    /// <summary>Miscellaneous functions that call a program.</summary>
    public IReadOnlySet<int> CallFunctions => _callFunctions.Value;

    /// <summary>The same control with another state of its block skip switches.</summary>
    /// <param name="blockSkip">The state; unstated keeps the dialect's own.</param>
    public NcDialect With(BlockSkip blockSkip) => blockSkip == BlockSkip || blockSkip == BlockSkip.Unstated
        ? this
        : new(Name, Description, _tables, Files, () => Facts) { BlockSkip = blockSkip, ToolRadii = ToolRadii, Assumed = Assumed };

    /// <summary>The same control with these radii of its tools.</summary>
    /// <param name="radii">The radii.</param>
    public NcDialect With(ToolRadii radii) => new(Name, Description, _tables, Files, () => Facts)
    {
        BlockSkip = BlockSkip,
        ToolRadii = radii,
        Assumed = Assumed,
    };

    /// <summary>The same control with these values of its variables.</summary>
    /// <param name="assumed">The values.</param>
    public NcDialect With(AssumedValues assumed) => new(Name, Description, _tables, Files, () => Facts)
    {
        BlockSkip = BlockSkip,
        ToolRadii = ToolRadii,
        Assumed = assumed,
    };

    /// <summary>True if a program can call a tool by its name.</summary>
    public bool CallsToolsByName => Ways.CallsToolsByName;

    /// <summary>The number of the offset that a tool usually has: its own, or 1 where each tool has offsets of its own.</summary>
    /// <param name="tool">The number of the tool.</param>
    public int UsualOffsetOf(int tool) => Ways.OffsetsBelongToTools ? 1 : tool;

    /// <summary>Meaning of a G code.</summary>
    /// <param name="tenths">The code times ten: 1 is 10, 54.1 is 541.</param>
    public NcMeaning MeaningOf(int tenths) => (uint)tenths < (uint)_tables.MeaningOf.Length ? _tables.MeaningOf[tenths] : NcMeaning.Unknown;

    /// <summary>Meaning of a multi-letter word as a command. The lookup does not allocate.</summary>
    /// <param name="keyword">The word without arguments or value, in any case: <c>TRANS</c>, <c>CYCLE81</c>, <c>MEAS</c>.</param>
    public NcMeaning MeaningOf(ReadOnlySpan<byte> keyword) => _tables.MeaningOfWord(keyword);

    /// <summary>The family of transformations that a G code begins or ends: an end code ends those of its own family. 0 if the dialect
    /// does not distinguish families.</summary>
    /// <param name="tenths">The code times ten.</param>
    public int FamilyOf(int tenths) => (uint)tenths < (uint)_tables.FamilyOf.Length ? _tables.FamilyOf[tenths] : 0;

    /// <summary>The family of transformations that a keyword begins or ends: an end keyword ends those of its own family. 0 if the
    /// dialect does not distinguish families.</summary>
    /// <param name="keyword">The word without arguments or value, in any case.</param>
    public int FamilyOf(ReadOnlySpan<byte> keyword) => _tables.FamilyOfWord(keyword);

    /// <summary>Whether a code that selects inches or millimeters also applies to feeds; true for every other code.</summary>
    /// <param name="tenths">The code times ten.</param>
    public bool ScalesFeed(int tenths) => (uint)tenths >= (uint)_tables.IsForLengthsOnly.Length || !_tables.IsForLengthsOnly[tenths];

    /// <summary>Role of an upper-case letter or an address of <see cref="NcAddress"/>.</summary>
    public LetterRole RoleOf(byte letter) => letter switch
    {
        >= (byte)'A' and <= (byte)'Z' => _tables.RoleOf[letter - 'A'],
        NcAddress.CircleRadius => LetterRole.Radius,
        NcAddress.OpeningAngle => LetterRole.OpeningAngle,
        NcAddress.Turn => LetterRole.MoreTurns,
        NcAddress.ThroughX or NcAddress.ThroughY or NcAddress.ThroughZ => LetterRole.IntermediatePoint,
        _ => LetterRole.Unknown,
    };

    /// <summary>Role of a multi-letter address. The lookup does not allocate.</summary>
    /// <param name="address">The word before the equals sign, in any case: <c>CR</c>, <c>TURN</c>, <c>I1</c>.</param>
    public LetterRole RoleOf(ReadOnlySpan<byte> address) => _tables.RoleOfAddress(address);

    /// <summary>Effect of an M function on the run of the program.</summary>
    /// <param name="function">Its number.</param>
    public FunctionRole FunctionOf(int function) =>
        (uint)function < DialectTables.Functions ? _tables.FunctionOf[function] : FunctionRole.Unknown;

    /// <summary>Whether a word branches, loops or defines programs. The lookup does not allocate.</summary>
    /// <param name="keyword">The word without arguments, in any case.</param>
    public bool IsFlow(ReadOnlySpan<byte> keyword) => _tables.Flow.GetAlternateLookup<ReadOnlySpan<byte>>().Contains(keyword);

    /// <summary>Whether a program with this number is known to be in the machine: a call to it makes positions and modes unknown, but it
    /// is not missing.</summary>
    public bool IsMachineProgram(int number) => _tables.MachineNumbers.Exists(r => r.First <= number && number <= r.Last);

    /// <summary>Whether a program with this name is known to be in the machine.</summary>
    /// <param name="name">The name without arguments, in any case: <c>L9810</c>.</param>
    public bool IsMachineProgram(ReadOnlySpan<byte> name) => _tables.MachineNames.GetAlternateLookup<ReadOnlySpan<byte>>().Contains(name);

    /// <summary>What a G10 block writes; null if the dialect does not say it.</summary>
    /// <param name="table">Its L word.</param>
    internal OffsetTable? OffsetTableOf(int table) => _tables.OffsetTables.GetValueOrDefault(table);

    /// <summary>The name of a work offset that stands for all its names, and whether one of the tables that G10 writes has it.</summary>
    /// <param name="offset">The code times ten, and the number beside it.</param>
    internal ((int Code, int Number) Offset, bool IsInTable) WorkOffsetOf((int Code, int Number) offset)
    {
        foreach (var table in _tables.OffsetTables.Values)
        {
            if (table.TryFind(offset, out var index))
            {
                return (table.Offset(index + 1) ?? offset, true);
            }
        }

        return (offset, false);
    }

    private static bool Calls(FunctionRole role) => role is FunctionRole.Call or FunctionRole.LocalCall or FunctionRole.OpaqueCall;
}

/// <summary>What a control does with a parenthesis inside a comment in parentheses.</summary>
internal enum NestedComments : byte
{
    /// <summary>Not stated: it is taken to read to the last one that fits.</summary>
    Accepted,

    /// <summary>The control refuses the block.</summary>
    Refused,

    /// <summary>The first closing parenthesis ends the comment, and a second one is refused.</summary>
    EndAtFirst,
}

/// <summary>By what a control names the programs that it has.</summary>
public enum ProgramNaming : byte
{
    /// <summary>By what is at a program's head (<c>O0100</c>), under whatever name its file was sent.</summary>
    ByHead,

    /// <summary>By the program's file alone.</summary>
    ByFile,

    /// <summary>By the program's file, and the head has the same name (<c>%_N_P100_MPF</c>, <c>BEGIN PGM P100</c>).</summary>
    ByBoth,
}
