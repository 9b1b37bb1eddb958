namespace ErrorMatching.Nc;

/// <summary>The words of one block, sorted by letter: reused from block to block so that interpreting allocates nothing.</summary>
internal sealed class BlockWords
{
    private readonly NcNumber[] _numbers = new NcNumber[26];
    private readonly int[] _codes = new int[16];
    private readonly int[] _functions = new int[16];
    private readonly List<NcToken> _keywords = [];

    /// <summary>Letters with a plain number, one bit each, A first.</summary>
    public uint Present { get; private set; }

    /// <summary>Letters with a computed value.</summary>
    public uint Computed { get; private set; }

    /// <summary>Letters that stand twice in the block (G and M aside).</summary>
    public uint Repeated { get; private set; }

    public bool HasCornerWord { get; private set; }

    public int CodeCount { get; private set; }

    public int FunctionCount { get; private set; }

    /// <summary>True if a variable is assigned by which a control keeps its offsets.</summary>
    public bool AssignsSystemVariable { get; private set; }

    public NcToken Invalid { get; private set; }

    public IReadOnlyList<NcToken> Keywords => _keywords;

    public ReadOnlySpan<int> Codes => _codes.AsSpan(0, CodeCount);

    public ReadOnlySpan<int> Functions => _functions.AsSpan(0, FunctionCount);

    public static uint Bit(char letter) => 1u << (letter - 'A');

    public bool Has(char letter) => (Present & Bit(letter)) != 0;

    public double Value(char letter) => _numbers[letter - 'A'].Value;

    public NcNumber Number(char letter) => _numbers[letter - 'A'];

    /// <summary>Position of the block in its program.</summary>
    public int BlockIndex { get; private set; }

    public void Read(NcProgram program, NcBlock block)
    {
        BlockIndex = block.Index;
        (Present, Computed, Repeated, HasCornerWord, AssignsSystemVariable, CodeCount, FunctionCount, Invalid) = (0, 0, 0, false, false, 0, 0, default);
        _keywords.Clear();
        foreach (var token in program.Tokens(block))
        {
            switch (token.Kind)
            {
                case NcTokenKind.Word when token.Letter == 'G' && CodeCount < _codes.Length:
                    _codes[CodeCount++] = Tenths(token.Number);
                    break;
                case NcTokenKind.Word when token.Letter == 'M' && FunctionCount < _functions.Length:
                    _functions[FunctionCount++] = Function(token.Number);
                    break;
                case NcTokenKind.Word:
                    var bit = 1u << (token.Letter - 'A');
                    Repeated |= (Present | Computed) & bit;
                    Present |= bit;
                    _numbers[token.Letter - 'A'] = token.Number;
                    break;
                case NcTokenKind.ExpressionWord:
                    var computed = 1u << (token.Letter - 'A');
                    Repeated |= (Present | Computed) & computed;
                    Computed |= computed;
                    break;
                case NcTokenKind.CommaWord:
                    HasCornerWord = true;
                    break;
                case NcTokenKind.Keyword:
                    _keywords.Add(token);
                    break;
                case NcTokenKind.Assignment:
                    AssignsSystemVariable |= IsSystemVariable(program.Bytes.Span.Slice(token.Start, token.Length));
                    break;
                case NcTokenKind.Invalid when Invalid.Length == 0:
                    Invalid = token;
                    break;
            }
        }
    }

    // Functions are whole numbers; M30. and M030 are M30.
    private static int Function(NcNumber number) => number.Trim() is { Decimals: 0, Digits: >= 0 and < int.MaxValue } whole ? (int)whole.Digits : -1;

    // #1 to #999 and names are the program's own; higher numbers, and numbers that are computed, can be offsets and positions of the control.
    private static bool IsSystemVariable(ReadOnlySpan<byte> assignment)
    {
        var name = assignment[1..];
        var digits = name.IndexOfAnyExceptInRange((byte)'0', (byte)'9');
        return digits switch
        {
            0 => name[0] != '<',
            < 0 => false,
            _ => name[..digits].TrimStart((byte)'0').Length > 3,
        };
    }

    // G codes have at most one decimal; anything finer is no code at all.
    private static int Tenths(NcNumber number)
    {
        var trimmed = number.Trim();
        return trimmed switch
        {
            { Decimals: 0, Digits: >= 0 and < 1000 } => (int)trimmed.Digits * 10,
            { Decimals: 1, Digits: >= 0 and < 10_000 } => (int)trimmed.Digits,
            _ => -1,
        };
    }
}
