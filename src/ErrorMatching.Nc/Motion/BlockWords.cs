namespace ErrorMatching.Nc;

/// <summary>The words of one block, sorted by letter: reused from block to block so that interpreting allocates nothing.</summary>
internal sealed class BlockWords
{
    private readonly NcNumber[] numbers = new NcNumber[26];
    private readonly int[] codes = new int[16];
    private readonly int[] functions = new int[16];

    /// <summary>Letters with a plain number, one bit each, A first.</summary>
    public uint Present { get; private set; }

    /// <summary>Letters with a computed value.</summary>
    public uint Computed { get; private set; }

    /// <summary>Letters that stand twice in the block (G and M aside).</summary>
    public uint Repeated { get; private set; }

    public bool HasCornerWord { get; private set; }

    public int CodeCount { get; private set; }

    public int FunctionCount { get; private set; }

    public NcToken Keyword { get; private set; }

    public NcToken Invalid { get; private set; }

    public ReadOnlySpan<int> Codes => codes.AsSpan(0, CodeCount);

    public ReadOnlySpan<int> Functions => functions.AsSpan(0, FunctionCount);

    public static uint Bit(char letter) => 1u << (letter - 'A');

    public bool Has(char letter) => (Present & Bit(letter)) != 0;

    public double Value(char letter) => numbers[letter - 'A'].Value;

    public NcNumber Number(char letter) => numbers[letter - 'A'];

    /// <summary>Position of the block in its program.</summary>
    public int BlockIndex { get; private set; }

    public void Read(NcProgram program, NcBlock block)
    {
        BlockIndex = block.Index;
        (Present, Computed, Repeated, HasCornerWord, CodeCount, FunctionCount, Keyword, Invalid) = (0, 0, 0, false, 0, 0, default, default);
        foreach (var token in program.Tokens(block))
        {
            switch (token.Kind)
            {
                case NcTokenKind.Word when token.Letter == 'G' && CodeCount < codes.Length:
                    codes[CodeCount++] = Tenths(token.Number);
                    break;
                case NcTokenKind.Word when token.Letter == 'M' && FunctionCount < functions.Length:
                    functions[FunctionCount++] = (int)Math.Min(token.Number.Digits, int.MaxValue);
                    break;
                case NcTokenKind.Word:
                    var bit = 1u << (token.Letter - 'A');
                    Repeated |= Present & bit;
                    Present |= bit;
                    numbers[token.Letter - 'A'] = token.Number;
                    break;
                case NcTokenKind.ExpressionWord:
                    Computed |= 1u << (token.Letter - 'A');
                    break;
                case NcTokenKind.CommaWord:
                    HasCornerWord = true;
                    break;
                case NcTokenKind.Keyword when Keyword.Length == 0:
                    Keyword = token;
                    break;
                case NcTokenKind.Invalid when Invalid.Length == 0:
                    Invalid = token;
                    break;
            }
        }
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
