namespace ErrorMatching.Nc;

/// <summary>The bytes of an expression, how far they have been read, and the first error: nothing is read after it.</summary>
internal ref struct ExpressionText
{
    /// <summary>Deepest nesting of brackets, functions, signs and variables.</summary>
    public const int MaxDepth = 64;

    private readonly ReadOnlySpan<byte> _bytes;
    private int _depth;

    /// <param name="bytes">The bytes of the block.</param>
    /// <param name="at">Position of the first byte to read.</param>
    public ExpressionText(ReadOnlySpan<byte> bytes, int at)
    {
        _bytes = bytes;
        At = at;
    }

    /// <summary>The first byte not read.</summary>
    public int At { get; set; }

    /// <summary>The error message; null if there is no error.</summary>
    public string? Error { get; private set; }

    /// <summary>Position of the error, from the start of the block.</summary>
    public int ErrorAt { get; private set; }

    /// <summary>True if all bytes have been read.</summary>
    public readonly bool IsAtEnd => At >= _bytes.Length;

    /// <summary>The bytes that have not been read.</summary>
    public readonly ReadOnlySpan<byte> Rest => _bytes[At..];

    /// <summary>The bytes from a position up to the first that has not been read.</summary>
    public readonly ReadOnlySpan<byte> Since(int start) => _bytes[start..At];

    /// <summary>The next byte, or one after it; 0 behind the end.</summary>
    public readonly byte Peek(int ahead = 0) => At + ahead < _bytes.Length ? _bytes[At + ahead] : (byte)0;

    /// <summary>True for the first byte of a name.</summary>
    public static bool BeginsName(byte c) => SyntaxBytes.IsLetter(c) || c == '_';

    /// <summary>True for any byte of a name.</summary>
    public static bool IsNamePart(byte c) => BeginsName(c) || SyntaxBytes.IsDigit(c);

    public void SkipSpaces()
    {
        while (At < _bytes.Length && _bytes[At] is (byte)' ' or (byte)'\t')
        {
            At++;
        }
    }

    /// <summary>Reads a character after spaces, if it is here.</summary>
    public bool Take(byte c)
    {
        SkipSpaces();
        if (Error is null && Peek() == c && At < _bytes.Length)
        {
            At++;
            return true;
        }

        return false;
    }

    /// <summary>Reads a closing bracket, or fails.</summary>
    public bool Close(byte bracket) => Take(bracket) || Fail($"a bracket is not closed: \"{(char)bracket}\" is expected here").IsNumber;

    /// <summary>How far it is to the first byte after some bytes and the spaces that follow them.</summary>
    public readonly int BehindSpaces(int ahead)
    {
        while (At + ahead < _bytes.Length && _bytes[At + ahead] is (byte)' ' or (byte)'\t')
        {
            ahead++;
        }

        return ahead;
    }

    /// <summary>True if a word in upper case is here, in any case.</summary>
    public readonly bool StandsHere(string spelling)
    {
        if (_bytes.Length - At < spelling.Length)
        {
            return false;
        }

        for (var i = 0; i < spelling.Length; i++)
        {
            var c = _bytes[At + i];
            if (((uint)(c - 'a') < 26 ? c & ~0x20 : c) != spelling[i])
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>True if a word is here and is no part of a longer name.</summary>
    public readonly bool StandsAlone(string word) => StandsHere(word) && !IsNamePart(Peek(word.Length));

    /// <summary>Begins a nested part; fails if it is nested too deep.</summary>
    public bool Deeper()
    {
        if (_depth < MaxDepth)
        {
            _depth++;
            return true;
        }

        Fail($"brackets, signs or variables are nested more than {MaxDepth} deep");
        return false;
    }

    /// <summary>Ends a nested part.</summary>
    public void Leave() => _depth--;

    /// <summary>Stops reading with an error at the current position.</summary>
    public NcValue Fail(string why) => FailAt(At, why);

    /// <summary>Stops reading with an error at a position.</summary>
    public NcValue FailAt(int place, string why)
    {
        if (Error is null)
        {
            (Error, ErrorAt) = (why, place);
        }

        return NcValue.Unknown;
    }
}
