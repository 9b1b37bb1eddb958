namespace ErrorMatching.Nc;

/// <summary>A block of a program, and its bytes without the words that may differ. Reusable for many blocks.</summary>
internal sealed class BlockRemainder(NcProgram program)
{
    /// <summary>Marks a changed value; no program has this byte in a word.</summary>
    private const byte ChangedValue = 0xFF;

    private readonly NcNumber[] _numbers = new NcNumber[32];
    private NcToken[] _tokens = new NcToken[16];
    private byte[] _rest = new byte[128];
    private NcBlock _block;
    private int _count;

    /// <summary>Letters that have a word with a plain number, one bit each; bit 0 is A.</summary>
    public uint Letters { get; private set; }

    /// <summary>Letters that have a word with a computed value, one bit each.</summary>
    public uint Computed { get; private set; }

    /// <summary>The text of the computed value of a letter.</summary>
    public ReadOnlySpan<byte> ComputedValue(int letter)
    {
        for (var i = 0; i < _count; i++)
        {
            if (_tokens[i].Kind == NcTokenKind.ExpressionWord && _tokens[i].Letter - 'A' == letter)
            {
                return program.Bytes.Span.Slice(_tokens[i].ValueStart, _tokens[i].ValueLength);
            }
        }

        return default;
    }

    /// <summary>The number of the last word with a letter.</summary>
    public NcNumber Number(int letter) => _numbers[letter];

    /// <summary>The angle of a polar end, degrees; zero if the block has none with a plain number.</summary>
    public NcNumber Angle { get; private set; }

    /// <summary>Reads a block.</summary>
    public void Read(int block)
    {
        _block = program[block];
        (_count, Letters, Computed, Angle) = (0, 0, 0, default);
        foreach (ref readonly var token in program.Tokens(_block))
        {
            if (_count == _tokens.Length)
            {
                Array.Resize(ref _tokens, _count * 2);
            }

            _tokens[_count++] = token;
            Angle = token is { Kind: NcTokenKind.PolarWord, Letter: (byte)'^' } ? token.Number : Angle;
            if (token.Kind == NcTokenKind.Word)
            {
                Letters |= 1u << (token.Letter - 'A');
                _numbers[token.Letter - 'A'] = token.Number;
            }
            else if (token.Kind == NcTokenKind.ExpressionWord && token.Letter is >= (byte)'A' and <= (byte)'Z')
            {
                Computed |= 1u << (token.Letter - 'A');
            }
        }
    }

    /// <summary>The block with changed values masked. Omits words that only one program has, each with the one space that separates
    /// it.</summary>
    /// <param name="changed">Letters whose value changed.</param>
    /// <param name="leftOut">Letters whose words the other program does not have.</param>
    /// <param name="turns">True if the angle of a polar end changed.</param>
    public ReadOnlySpan<byte> Without(uint changed, uint leftOut, bool turns = false)
    {
        // A changed value has at least one byte, and the mask has one.
        if (_rest.Length < _block.FullLength)
        {
            _rest = new byte[_block.FullLength];
        }

        var bytes = program.Bytes.Span;
        var (length, skipSpace) = (0, false);
        for (var i = 0; i < _count; i++)
        {
            ref readonly var token = ref _tokens[i];
            var letter = token.Kind == NcTokenKind.Word
                || (token.Kind == NcTokenKind.ExpressionWord && token.Letter is >= (byte)'A' and <= (byte)'Z')
                ? 1u << (token.Letter - 'A')
                : 0;
            if ((letter & changed) != 0 || (turns && token is { Kind: NcTokenKind.PolarWord, Letter: (byte)'^' }))
            {
                length = Append(bytes[token.Start..token.ValueStart], length);
                _rest[length++] = ChangedValue;
                length = Append(bytes[(token.ValueStart + token.ValueLength)..token.End], length);
            }
            else if ((letter & leftOut) != 0)
            {
                if (length > 0 && _rest[length - 1] == ' ')
                {
                    length--;
                }
                else
                {
                    skipSpace = length == 0;
                    continue;
                }
            }
            else if (!(skipSpace && token is { Kind: NcTokenKind.Space, Length: 1 }))
            {
                length = Append(bytes.Slice(token.Start, token.Length), length);
            }

            skipSpace = false;
        }

        length = Append(bytes[_block.End..(_block.Start + _block.FullLength)], length);
        return _rest.AsSpan(0, length);
    }

    private int Append(ReadOnlySpan<byte> bytes, int length)
    {
        bytes.CopyTo(_rest.AsSpan(length));
        return length + bytes.Length;
    }
}
