namespace ErrorMatching.Nc;

/// <summary>A control's language as data: what its codes and letters mean, its increments and tolerances. No rule of a control lives in code elsewhere.</summary>
public sealed class NcDialect
{
    private readonly NcMeaning[] _codes = new NcMeaning[10_000];
    private readonly LetterRole[] _letters = new LetterRole[26];

    internal NcDialect(string name, string description) => (Name, Description) = (name, description);

    /// <summary>Name as in jobs and on the command line.</summary>
    public string Name { get; }

    /// <summary>What it is for, in a sentence.</summary>
    public string Description { get; }

    /// <summary>How its programs are spelled.</summary>
    public NcSyntax Syntax { get; internal init; }

    /// <summary>True if a coordinate without a point counts least increments (<c>X100</c> is 0.1 mm), false if it counts millimetres or inches.</summary>
    public bool IntegersAreIncrements { get; internal init; }

    /// <summary>Decimals of the least increment in millimetres.</summary>
    public int MetricDecimals { get; internal init; } = 3;

    /// <summary>Decimals of the least increment in inches.</summary>
    public int InchDecimals { get; internal init; } = 4;

    /// <summary>Largest difference of an arc's two radii that the control is taken to accept, mm.</summary>
    public double ArcMismatchMm { get; internal init; } = 0.02;

    /// <summary>The same as a fraction of the radius: whichever is larger counts.</summary>
    public double ArcMismatchOfRadius { get; internal init; }

    /// <summary>Everything the dialect states about its control, with sources.</summary>
    public IReadOnlyList<DialectFact> Facts { get; internal init; } = [];

    /// <summary>Words of several letters that branch, loop or define programs.</summary>
    public IReadOnlySet<string> FlowKeywords { get; internal init; } = new HashSet<string>(StringComparer.Ordinal);

    /// <summary>Miscellaneous functions that call a program.</summary>
    public IReadOnlySet<int> CallFunctions { get; internal init; } = new HashSet<int>();

    /// <summary>Letter that gives the number of turns of an arc, the first included; 0 where the control has none.</summary>
    public byte TurnsLetter { get; internal init; }

    /// <summary>What a G code means.</summary>
    /// <param name="tenths">The code times ten: 1 is 10, 54.1 is 541.</param>
    public NcMeaning MeaningOf(int tenths) => (uint)tenths < (uint)_codes.Length ? _codes[tenths] : NcMeaning.Unknown;

    /// <summary>What an upper-case letter stands for.</summary>
    public LetterRole RoleOf(byte letter) => _letters[letter - 'A'];

    internal NcDialect Code(NcMeaning meaning, params ReadOnlySpan<double> values)
    {
        foreach (var value in values)
        {
            _codes[(int)Math.Round(value * 10)] = meaning;
        }

        return this;
    }

    internal NcDialect Codes(NcMeaning meaning, int first, int last)
    {
        for (var code = first; code <= last; code++)
        {
            _codes[code * 10] = meaning;
        }

        return this;
    }

    internal NcDialect Letters(LetterRole role, string which)
    {
        foreach (var letter in which)
        {
            _letters[letter - 'A'] = role;
        }

        return this;
    }
}
