namespace ErrorMatching.Nc;

/// <summary>The words of one block, sorted by letter. Reused from block to block, so that interpreting allocates nothing.</summary>
internal sealed partial class BlockWords
{
    /// <summary>X, Y and Z.</summary>
    public const uint LinearAxes = (1u << 23) | (1u << 24) | (1u << 25);

    /// <summary>I, J and K.</summary>
    public const uint CenterWords = (1u << 8) | (1u << 9) | (1u << 10);

    /// <summary>All words that determine where a motion goes.</summary>
    public const uint GeometryWords = LinearAxes | CenterWords | (1u << 17) | (0x3Fu << 26);

    private readonly double[] _values = new double[32];
    private readonly int[] _codes = new int[16];
    private readonly int[] _functions = new int[16];
    private NcToken[] _statements = new NcToken[4];
    private int _statementCount;
    private int _codeCount;
    private int _functionCount;

    // True while only what plain words have was set, so that the rest need not be cleared.
    private bool _arePlain = true;

    /// <summary>Number of words of a block of plain words.</summary>
    public int Count { get; private set; }

    /// <summary>Letters with a known value, one bit each; bit 0 is A. The addresses of <see cref="NcAddress"/> follow Z.</summary>
    public uint Present { get; private set; }

    /// <summary>Letters whose value the control computes, whether known or not.</summary>
    public uint Computed { get; private set; }

    /// <summary>Letters whose value only the machine knows.</summary>
    public uint Unknown { get; private set; }

    /// <summary>Letters that occur twice in the block (except G and M).</summary>
    public uint Repeated { get; private set; }

    /// <summary>Letters whose number has no decimal point.</summary>
    public uint Integers { get; private set; }

    /// <summary>Letters whose own words mark them as positions.</summary>
    public uint Absolute { get; private set; }

    /// <summary>Letters whose own words mark them as increments.</summary>
    public uint Incremental { get; private set; }

    /// <summary>Letter of the corner word (R rounding, C chamfer by its legs, F by its width, M modal rounding); 0 if none.</summary>
    public byte Corner { get; private set; }

    /// <summary>Value of the corner word; NaN if it is computed.</summary>
    public double CornerValue { get; private set; }

    /// <summary>True if the corner word's number has no decimal point.</summary>
    public bool CornerIsInteger { get; private set; }

    /// <summary>Angle of a rotation in the plane (RPL=), degrees; NaN if only the machine knows it, null if the block has none.</summary>
    public double? PlaneAngle { get; set; }

    /// <summary>Distance from the origin in the XY plane (@), as programmed; NaN if only the machine knows it, null if the block has
    /// none.</summary>
    public double? PolarDistance { get; private set; }

    /// <summary>Angle about the origin in the XY plane (^), degrees; NaN if only the machine knows it, null if the block has
    /// none.</summary>
    public double? PolarAngle { get; private set; }

    /// <summary>Distance of the end from the pole (RP=), as programmed; NaN if only the machine knows it, null if the block has
    /// none.</summary>
    public double? PoleRadius { get; set; }

    /// <summary>Angle of the end about the pole (AP=), degrees; NaN if only the machine knows it, null if the block has none.</summary>
    public double? PoleAngle { get; set; }

    /// <summary>Angle of a straight line (ANG=), degrees; NaN if only the machine knows it, null if the block has none.</summary>
    public double? LineAngle { get; set; }

    /// <summary>True if the end is given about a pole or by an angle.</summary>
    public bool HasPolarEnd => PoleRadius is not null || PoleAngle is not null || LineAngle is not null;
    /// <summary>True if the distance of a polar end is an increment, by its own word.</summary>
    public bool PolarDistanceGrows { get; private set; }

    /// <summary>True if the angle of a polar end is an increment, by its own word.</summary>
    public bool PolarAngleGrows { get; private set; }

    /// <summary>True if the block has a polar coordinate.</summary>
    public bool IsPolar => PolarDistance is not null || PolarAngle is not null;

    /// <summary>Assignments, words of several letters, strings and separate expressions, in order.</summary>
    public ReadOnlySpan<NcToken> Statements => _statements.AsSpan(0, _statementCount);

    /// <summary>The first bytes that no rule explains; of length 0 if there are none.</summary>
    public NcToken Invalid { get; private set; }

    /// <summary>The semicolon with the rest of its line; of length 0 if there is none.</summary>
    public NcToken Semicolon { get; private set; }

    public ReadOnlySpan<int> Codes => _codes.AsSpan(0, _codeCount);

    public ReadOnlySpan<int> Functions => _functions.AsSpan(0, _functionCount);

    public static uint Bit(char letter) => 1u << (letter - 'A');

    public static uint Bit(byte letter) => 1u << (letter - 'A');

    /// <summary>The linear axes among letters.</summary>
    public static AxisSet AxesOf(uint letters) => (AxisSet)((letters >> 23) & 7);

    public bool Has(char letter) => (Present & Bit(letter)) != 0;

    public bool Has(byte letter) => (Present & Bit(letter)) != 0;

    public double Value(char letter) => _values[letter - 'A'];

    public double Value(byte letter) => _values[letter - 'A'];

    /// <summary>Sets a value for a letter that the block does not have: an argument of a modal call.</summary>
    public void Supply(char letter, double value)
    {
        Present |= Bit(letter);
        _values[letter - 'A'] = value;
    }

    private void Clear()
    {
        (Present, Repeated, Integers, _codeCount, _functionCount) = (0, 0, 0, 0, 0);
        if (!_arePlain)
        {
            (Computed, Unknown, Absolute, Incremental) = (0, 0, 0, 0);
            (Corner, CornerValue, Invalid, Semicolon) = (0, 0, default, default);
            (PlaneAngle, PolarDistance, PolarAngle, PolarDistanceGrows, PolarAngleGrows) = (null, null, null, false, false);
            (PoleRadius, PoleAngle, LineAngle) = (null, null, null);
            (_statementCount, _arePlain) = (0, true);
        }
    }

    // G codes have at most one decimal; more decimals are not a code.
    private void AddCode(long digits, int decimals)
    {
        while (decimals > 1 && digits % 10 == 0)
        {
            (digits, decimals) = (digits / 10, decimals - 1);
        }

        // More codes than fit give a code that no dialect knows.
        var tenths = decimals == 0 ? digits * 10 : digits;
        var isCode = _codeCount < _codes.Length && decimals <= 1 && tenths is >= 0 and < 10_000;
        _codeCount = Math.Min(_codeCount + 1, _codes.Length);
        _codes[_codeCount - 1] = isCode ? (int)tenths : -1;
    }

    // Functions are whole numbers; M30. and M030 are M30.
    private void AddFunction(long digits, int decimals)
    {
        while (decimals > 0 && digits % 10 == 0)
        {
            (digits, decimals) = (digits / 10, decimals - 1);
        }

        var isFunction = _functionCount < _functions.Length && decimals == 0 && digits is >= 0 and < int.MaxValue;
        _functionCount = Math.Min(_functionCount + 1, _functions.Length);
        _functions[_functionCount - 1] = isFunction ? (int)digits : -1;
    }

    private void AddStatement(in NcToken token)
    {
        if (_statementCount == _statements.Length)
        {
            Array.Resize(ref _statements, 2 * _statementCount);
        }

        _statements[_statementCount++] = token;
    }

    private void AddNumber(int letter, double value, bool isInteger)
    {
        var bit = 1u << letter;
        Repeated |= (Present | Computed) & bit;
        Present |= bit;
        Integers |= isInteger ? bit : 0;
        _values[letter] = value;
    }
}
