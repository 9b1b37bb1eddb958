namespace ErrorMatching.Nc;

/// <summary>Reads an expression from a block's bytes and computes it while reading: precedence climbing over the operators of
/// <see cref="ExpressionSyntax"/>. The first error stops it; from then on every value is unknown and nothing more is read.</summary>
internal ref partial struct ExpressionReader
{
    /// <summary>Deepest nesting of brackets, functions, signs and variables.</summary>
    public const int MaxDepth = 64;

    private readonly ReadOnlySpan<byte> _text;
    private readonly ExpressionSyntax _syntax;
    private readonly NcVariables _variables;
    private int _at;
    private int _depth;

    /// <param name="text">The bytes of the block.</param>
    /// <param name="at">Position of the first byte to read.</param>
    /// <param name="syntax">Expression syntax of the family.</param>
    /// <param name="variables">Values of variables.</param>
    public ExpressionReader(ReadOnlySpan<byte> text, int at, ExpressionSyntax syntax, NcVariables variables)
    {
        _text = text;
        _at = at;
        _syntax = syntax;
        _variables = variables;
    }

    /// <summary>Decimals to which ROUND rounds: 0 in a computation; in an address, Fanuc rounds to the least increment.</summary>
    public int RoundDecimals { get; init; }

    /// <summary>The first byte not read.</summary>
    public int At
    {
        readonly get => _at;
        set => _at = value;
    }

    /// <summary>The error message; null if there is no error.</summary>
    public string? Error { get; private set; }

    /// <summary>Position of the error, from the start of the block.</summary>
    public int ErrorAt { get; private set; }

    private readonly bool IsSiemens => _syntax.Syntax == NcSyntax.Siemens;

    /// <summary>Reads the longest expression from here.</summary>
    public NcValue Expression() => Expression(0);

    /// <summary>Reads one operand: a number, variable, function or bracket, with its sign.</summary>
    public NcValue Operand()
    {
        SkipSpaces();
        if (Error is not null || !Deeper())
        {
            return NcValue.Unknown;
        }

        var value = Peek() switch
        {
            (byte)'+' => Signed(negative: false),
            (byte)'-' => Signed(negative: true),
            (byte)'#' when !IsSiemens => ReadVariable(),
            (byte)'.' or (>= (byte)'0' and <= (byte)'9') => Number(),
            (byte)'"' when IsSiemens => Quoted(),
            (byte)'\'' when IsSiemens => Coded(),
            (byte)'$' when IsSiemens => ReadVariable(),
            var c when c == _syntax.Open => Bracket(),
            var c when BeginsName(c) => Word(),
            0 when _at >= _text.Length => Fail("a value is missing at the end"),
            _ => Fail("a value is expected here"),
        };
        _depth--;
        return value;
    }

    /// <summary>Reads a bracketed expression.</summary>
    public NcValue Bracket()
    {
        if (!Take(_syntax.Open))
        {
            return Fail($"\"{(char)_syntax.Open}\" is expected here");
        }

        var value = Expression(0);
        return Close() ? value : NcValue.Unknown;
    }

    /// <summary>Stops reading with an error at the current position.</summary>
    public NcValue Fail(string why) => FailAt(_at, why);

    public void SkipSpaces()
    {
        while (_at < _text.Length && _text[_at] is (byte)' ' or (byte)'\t')
        {
            _at++;
        }
    }

    /// <summary>Reads a character after spaces, if it is here.</summary>
    public bool Take(byte c)
    {
        SkipSpaces();
        if (Error is null && Peek() == c && _at < _text.Length)
        {
            _at++;
            return true;
        }

        return false;
    }

    private static bool BeginsName(byte c) => SyntaxBytes.IsLetter(c) || c == '_';

    private readonly byte Peek(int ahead = 0) => _at + ahead < _text.Length ? _text[_at + ahead] : (byte)0;

    private NcValue Expression(int rank)
    {
        var left = Operand();
        while (Error is null && Operator(out var length) is { } found && found.Rank >= rank)
        {
            var place = _at;
            _at += length;
            if (!Deeper())
            {
                return NcValue.Unknown;
            }

            var right = Expression(found.Rank + 1);
            _depth--;
            if (Error is not null)
            {
                return NcValue.Unknown;
            }

            left = ExpressionArithmetic.Apply(found.Meaning, left, right, _syntax.Equality, out var error);
            if (error is not null)
            {
                return FailAt(place, error);
            }
        }

        return Error is null ? left : NcValue.Unknown;
    }

    // The operator here, after spaces; reads nothing yet.
    private OperatorSpelling? Operator(out int length)
    {
        SkipSpaces();
        foreach (var candidate in _syntax.Operators)
        {
            if (StandsHere(candidate.Spelling) && !(IsSiemens && candidate.IsWord && IsNamePart(Peek(candidate.Spelling.Length))))
            {
                length = candidate.Spelling.Length;
                return candidate;
            }
        }

        length = 0;
        return null;
    }

    private NcValue Signed(bool negative)
    {
        _at++;
        var value = Operand();
        if (value.Kind == NcValueKind.Text)
        {
            return Fail("a text has no sign");
        }

        return negative && value.IsNumber ? NcValue.Of(-value.Number) : value;
    }

    private NcValue Word()
    {
        foreach (var function in _syntax.Functions)
        {
            if (StandsHere(function.Name)
                && BehindSpaces(function.Name.Length) is var open
                && open < _text.Length
                && _text[open] == _syntax.Open)
            {
                var place = _at;
                _at = open;
                return Call(function, place);
            }
        }

        if (_syntax.Syntax == NcSyntax.LinuxCnc && StandsHere("EXISTS"))
        {
            return Exists();
        }

        if (!IsSiemens)
        {
            return Fail("no function of this name is known");
        }

        return Prefixed(out var value) ? value : ReadVariable();
    }

    private NcValue Call(FunctionSpelling function, int place)
    {
        _at++;
        var arguments = new ArgumentList();
        do
        {
            if (arguments.Count == function.Most)
            {
                return Fail($"{function.Name} takes no further argument");
            }

            arguments.Add(Expression(0));
        }
        while (Take((byte)','));

        if (!Close())
        {
            return NcValue.Unknown;
        }

        // ATAN[y]/[x]: the second argument has its own bracket.
        if (!IsSiemens
            && function.Most == 2
            && arguments.Count == 1
            && BehindSpaces(0) is var slash
            && slash < _text.Length
            && _text[slash] == '/'
            && function.Meaning is ExpressionFunction.ArcTangentOfPoint or ExpressionFunction.ArcTangentOfTurn)
        {
            var back = _at;
            _at = slash + 1;
            SkipSpaces();
            if (Peek() == _syntax.Open)
            {
                arguments.Add(Bracket());
            }
            else
            {
                _at = back;
            }
        }

        if (Error is not null)
        {
            return NcValue.Unknown;
        }

        if (arguments.Count < function.Least)
        {
            return FailAt(place, $"{function.Name} needs {function.Least} arguments");
        }

        var value = ExpressionArithmetic.Apply(function.Meaning, arguments.Values, RoundDecimals, out var error);
        return error is null ? value : FailAt(place, error);
    }

    private bool Close() => Take(_syntax.Close) || Fail($"a bracket is not closed: \"{(char)_syntax.Close}\" is expected here").IsNumber;

    private readonly int BehindSpaces(int ahead)
    {
        var at = _at + ahead;
        while (at < _text.Length && _text[at] is (byte)' ' or (byte)'\t')
        {
            at++;
        }

        return at;
    }

    private readonly bool StandsHere(string spelling)
    {
        if (_text.Length - _at < spelling.Length)
        {
            return false;
        }

        for (var i = 0; i < spelling.Length; i++)
        {
            var c = _text[_at + i];
            if (((uint)(c - 'a') < 26 ? c & ~0x20 : c) != spelling[i])
            {
                return false;
            }
        }

        return true;
    }

    private bool Deeper()
    {
        if (_depth < MaxDepth)
        {
            _depth++;
            return true;
        }

        Fail($"brackets, signs or variables are nested more than {MaxDepth} deep");
        return false;
    }

    private NcValue FailAt(int place, string why)
    {
        if (Error is null)
        {
            (Error, ErrorAt) = (why, place);
        }

        return NcValue.Unknown;
    }
}
