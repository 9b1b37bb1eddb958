namespace ErrorMatching.Nc;

/// <summary>A block of a program, and what is left of it without the words that may differ. One serves block after block.</summary>
internal sealed class BlockRemainder(NcProgram program)
{
    /// <summary>Stands for a value that changed; no program has this byte in a word.</summary>
    private const byte ChangedValue = 0xFF;

    private readonly NcNumber[] _numbers = new NcNumber[32];
    private NcToken[] _tokens = new NcToken[16];
    private byte[] _rest = new byte[128];
    private NcBlock _block;
    private int _count;

    /// <summary>Letters that have a word with a plain number, one bit each, A first.</summary>
    public uint Letters { get; private set; }

    /// <summary>The number of a letter that has one, of its last word.</summary>
    public NcNumber Number(int letter) => _numbers[letter];

    /// <summary>Takes a block.</summary>
    public void Read(int block)
    {
        _block = program[block];
        (_count, Letters) = (0, 0);
        foreach (ref readonly var token in program.Tokens(_block))
        {
            if (_count == _tokens.Length)
            {
                Array.Resize(ref _tokens, _count * 2);
            }

            _tokens[_count++] = token;
            if (token.Kind == NcTokenKind.Word)
            {
                Letters |= 1u << (token.Letter - 'A');
                _numbers[token.Letter - 'A'] = token.Number;
            }
        }
    }

    /// <summary>The block with the changed values masked, and words that only one program has left out together with the one space that
    /// separates them.</summary>
    /// <param name="changed">Letters whose value changed.</param>
    /// <param name="leftOut">Letters whose words the other program does not have.</param>
    public ReadOnlySpan<byte> Without(uint changed, uint leftOut)
    {
        // A value that changed is one byte at least, and so is the mask.
        if (_rest.Length < _block.FullLength)
        {
            _rest = new byte[_block.FullLength];
        }

        var bytes = program.Bytes.Span;
        var (length, skipSpace) = (0, false);
        for (var i = 0; i < _count; i++)
        {
            ref readonly var token = ref _tokens[i];
            var letter = token.Kind == NcTokenKind.Word ? 1u << (token.Letter - 'A') : 0;
            if ((letter & changed) != 0)
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
