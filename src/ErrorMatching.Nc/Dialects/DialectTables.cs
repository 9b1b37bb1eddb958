using ErrorMatching.Json;

namespace ErrorMatching.Nc;

/// <summary>The tables of a dialect while its files are read, from the first base to the requested file: later entries replace earlier
/// ones.</summary>
/// <remarks>Arrays, and dictionaries of plain numbers: they are filled at every start, before the runtime has compiled anything
/// else.</remarks>
internal sealed class DialectTables
{
    /// <summary>Number of distinct G codes: up to 999.9.</summary>
    public const int Codes = 10_000;

    /// <summary>Number of distinct M functions: up to 9999.</summary>
    public const int Functions = 10_000;

    private const int FamilyShift = 8;
    private readonly List<string> _families = [""];
    private RefusalTable? _refusals;

    public NcSyntax Syntax { get; set; }

    public bool IntegersAreIncrements { get; set; }

    public bool NotesNumbersWithoutPoint { get; set; }

    public bool SemicolonEndsBlock { get; set; }

    public BlockSkip BlockSkip { get; set; }

    public int MetricDecimals { get; set; }

    public int InchDecimals { get; set; }

    public double ArcMismatchMm { get; set; }

    public double ArcMismatchOfRadius { get; set; }

    public byte TurnsLetter { get; set; }

    public uint PeckLetters { get; set; }

    public bool SystemLines { get; set; }

    public byte SequenceLetter { get; set; }

    public bool RepeatsInNumber { get; set; } = true;

    public byte WorkOffsetLetter { get; set; } = (byte)'P';

    public bool HasMacros { get; set; } = true;

    public bool CommentCapitals { get; set; }

    public int CommentLength { get; set; }

    public ProgramNaming ProgramNaming { get; set; }
    public int LongestLine { get; set; } = int.MaxValue;

    public NestedComments NestedComments { get; set; }

    /// <summary>What the control refuses: entries of the files, each name once.</summary>
    public List<JsonItem> Refusals { get; } = [];

    /// <summary>The same, compiled at first use.</summary>
    public RefusalTable RefusalTable => _refusals ??= Refusals.Count == 0 ? RefusalTable.Empty : new(Refusals);

    public OffsetRule Offsets { get; } = new();

    /// <summary>What G10 writes, by its L word.</summary>
    public Dictionary<int, OffsetTable> OffsetTables { get; } = [];

    /// <summary>The work offset that is active before a program chooses one, its code times ten.</summary>
    public int FirstWorkOffset { get; set; } = 540;

    public CompensationRule Compensation { get; } = new();

    public NcMeaning[] MeaningOf { get; } = new NcMeaning[Codes];

    public int[] FamilyOf { get; } = new int[Codes];

    public bool[] IsForLengthsOnly { get; } = new bool[Codes];

    public LetterRole[] RoleOf { get; } = new LetterRole[26];

    /// <summary>Multi-letter addresses; the values are <see cref="LetterRole"/>.</summary>
    public Dictionary<string, int> Addresses { get; } = new(KeywordComparer.Instance);

    public FunctionRole[] FunctionOf { get; } = new FunctionRole[Functions];

    public HashSet<string> Flow { get; } = new(KeywordComparer.Instance);

    public List<SubjectRange> MachineNumbers { get; } = [];

    public HashSet<string> MachineNames { get; } = new(KeywordComparer.Instance);

    /// <summary>Keywords; the values are an <see cref="NcMeaning"/> and, in the higher bits, the number of a family.</summary>
    private Dictionary<string, int> Words { get; } = new(KeywordComparer.Instance);

    public void SetWord(string word, NcMeaning meaning, int family) => Words[word] = (int)meaning | (family << FamilyShift);

    public NcMeaning MeaningOfWord(ReadOnlySpan<byte> word) => (NcMeaning)(byte)Find(Words, word);

    public int FamilyOfWord(ReadOnlySpan<byte> word) => Find(Words, word) >> FamilyShift;

    public LetterRole RoleOfAddress(ReadOnlySpan<byte> address) => (LetterRole)Find(Addresses, address);

    /// <summary>Number of a family; equal for equal names.</summary>
    public int FamilyNumber(string name)
    {
        var index = _families.IndexOf(name);
        if (index < 0)
        {
            index = _families.Count;
            _families.Add(name);
        }

        return index;
    }

    private static int Find(Dictionary<string, int> table, ReadOnlySpan<byte> word) =>
        table.GetAlternateLookup<ReadOnlySpan<byte>>().TryGetValue(word, out var value) ? value : 0;
}
