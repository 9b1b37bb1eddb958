namespace ErrorMatching.Nc;

/// <summary>What the files of a dialect add up to while they are read, from the first base to the file that was asked for:
/// what comes later replaces what came before.</summary>
/// <remarks>Arrays, and dictionaries of plain numbers: they are filled at every start,
/// before the runtime has compiled anything else.</remarks>
internal sealed class DialectTables
{
    /// <summary>G codes up to 999.9 are told apart.</summary>
    public const int Codes = 10_000;

    /// <summary>M functions up to 9999 are.</summary>
    public const int Functions = 10_000;

    private const int FamilyShift = 8;
    private readonly List<string> _families = [""];

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

    public NcMeaning[] MeaningOf { get; } = new NcMeaning[Codes];

    public int[] FamilyOf { get; } = new int[Codes];

    public bool[] IsForLengthsOnly { get; } = new bool[Codes];

    public LetterRole[] RoleOf { get; } = new LetterRole[26];

    /// <summary>Addresses of several letters; the values are <see cref="LetterRole"/>.</summary>
    public Dictionary<string, int> Addresses { get; } = new(KeywordComparer.Instance);

    public FunctionRole[] FunctionOf { get; } = new FunctionRole[Functions];

    public HashSet<string> Flow { get; } = new(KeywordComparer.Instance);

    public List<SubjectRange> MachineNumbers { get; } = [];

    public HashSet<string> MachineNames { get; } = new(KeywordComparer.Instance);

    /// <summary>Keywords; the values are an <see cref="NcMeaning"/> and above it the number of a family.</summary>
    private Dictionary<string, int> Words { get; } = new(KeywordComparer.Instance);

    public void SetWord(string word, NcMeaning meaning, int family) => Words[word] = (int)meaning | (family << FamilyShift);

    public NcMeaning MeaningOfWord(ReadOnlySpan<byte> word) => (NcMeaning)(byte)Find(Words, word);

    public int FamilyOfWord(ReadOnlySpan<byte> word) => Find(Words, word) >> FamilyShift;

    public LetterRole RoleOfAddress(ReadOnlySpan<byte> address) => (LetterRole)Find(Addresses, address);

    /// <summary>Number of a family, the same for the same name.</summary>
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
