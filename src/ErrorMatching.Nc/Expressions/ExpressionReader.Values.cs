using System.Buffers.Text;

namespace ErrorMatching.Nc;

/// <content>Numbers, texts and variables.</content>
internal ref partial struct ExpressionReader
{
    private const double Nearly = 0.0001;

    /// <summary>Reads the variable here: <c>#1</c>, <c>#[#2+1]</c>, <c>##3</c>, <c>#&lt;name&gt;</c>, <c>R1</c>, <c>R[..]</c>,
    /// <c>NAME</c>, <c>NAME[i, j]</c>, <c>$..</c>.</summary>
    public VariablePlace Place()
    {
        SkipSpaces();
        if (IsSiemens)
        {
            return SiemensPlace();
        }

        if (!Take((byte)'#'))
        {
            Fail("a variable is expected here");
            return VariablePlace.Machine;
        }

        SkipSpaces();
        if (_syntax.Syntax == NcSyntax.LinuxCnc && Peek() == '<')
        {
            return NamedPlace();
        }

        if (!Deeper())
        {
            return VariablePlace.Machine;
        }

        var start = _at;
        var number = Peek() switch
        {
            (byte)'#' => ReadVariable(),
            (byte)'[' => Bracket(),
            (byte)'.' or (>= (byte)'0' and <= (byte)'9') => Number(),
            _ => Fail("the number of a variable is expected here"),
        };
        _depth--;
        return Position(number, start) is { } position ? VariablePlace.Numbered(position) : VariablePlace.Machine;
    }

    private static bool IsNamePart(byte c) => BeginsName(c) || SyntaxBytes.IsDigit(c);

    private NcValue ReadVariable()
    {
        var start = _at;
        var place = Place();
        if (Error is not null)
        {
            return NcValue.Unknown;
        }

        var value = _variables.Read(place, out var error);
        return error is null ? value : FailAt(start, error);
    }

    // The whole number of a variable or an array element; null if only the machine knows it.
    private int? Position(NcValue value, int start)
    {
        if (Error is not null || value.IsUnknown)
        {
            return null;
        }

        var whole = Math.Round(value.Number);
        if (value.Kind == NcValueKind.Text || Math.Abs(value.Number - whole) > Nearly || whole is < 0 or > 99_999_999)
        {
            FailAt(start, "the number of a variable must be a whole number");
            return null;
        }

        return (int)whole;
    }

    private VariablePlace NamedPlace()
    {
        var length = _text[_at..].IndexOf((byte)'>');
        if (length < 0)
        {
            Fail("the name of a variable is not closed: \">\" is missing");
            return VariablePlace.Machine;
        }

        var name = _variables.Names.Of(_text.Slice(_at + 1, length - 1));
        if (string.IsNullOrEmpty(name))
        {
            Fail("the name of a variable is empty or too long");
            return VariablePlace.Machine;
        }

        _at += length + 1;
        return VariablePlace.Named(name);
    }

    private NcValue Exists()
    {
        _at += "EXISTS".Length;
        if (!Take((byte)'['))
        {
            return Fail("EXISTS is followed by a variable in brackets");
        }

        var place = Place();
        return Close()
            ? NcValue.Of(place.Kind != VariableKind.Named || _variables.Knows(place.Name!) || LinuxCncNames.IsOfMachine(place.Name!))
            : NcValue.Unknown;
    }

    private VariablePlace SiemensPlace()
    {
        var start = _at;
        var machine = Peek() == '$';
        _at += machine ? 1 : 0;
        while (IsNamePart(Peek()) || (machine && Peek() == '$'))
        {
            _at++;
        }

        var spelling = _text[start.._at];
        if (spelling.Length == 0)
        {
            Fail("a variable is expected here");
            return VariablePlace.Machine;
        }

        if ((spelling[0] | 0x20) == 'r' && spelling.Length is > 1 and < 9 && spelling[1..].IndexOfAnyExceptInRange((byte)'0', (byte)'9') < 0
            && Utf8Parser.TryParse(spelling[1..], out int number, out _))
        {
            return VariablePlace.Numbered(number);
        }

        var name = machine ? null : _variables.Names.Known(spelling);
        var known = name is null ? null : _variables.Find(name);
        var isParameter = known is null && spelling.Length == 1 && (spelling[0] | 0x20) == 'r';
        if (Peek() == '[' && (known is not null || isParameter))
        {
            return Indexed(name, known);
        }

        return known is null ? BehindMachineVariable() : VariablePlace.Named(name!);
    }

    // The brackets of machine variables (axes, keywords) are not computed.
    private VariablePlace BehindMachineVariable()
    {
        while (Peek() is (byte)'[' or (byte)'(')
        {
            var (open, close, depth) = (Peek(), Peek() == '[' ? (byte)']' : (byte)')', 0);
            do
            {
                depth += Peek() == open ? 1 : Peek() == close ? -1 : 0;
                _at++;
            }
            while (depth > 0 && _at < _text.Length);

            if (depth > 0)
            {
                Fail("a bracket is not closed");
            }
        }

        return VariablePlace.Machine;
    }

    private VariablePlace Indexed(string? name, VariableArray? array)
    {
        var start = ++_at;
        if (!Deeper())
        {
            return VariablePlace.Machine;
        }

        var row = Position(Expression(0), start);
        var column = Take((byte)',') ? Position(Expression(0), start) : 0;
        _depth--;
        if (!Take((byte)']'))
        {
            Fail("a bracket is not closed: \"]\" is expected here");
        }

        if (Error is not null || row is null || column is null)
        {
            return VariablePlace.Machine;
        }

        if (array is null)
        {
            return VariablePlace.Numbered(row.Value);
        }

        var position = ((long)row.Value * array.Columns) + column.Value;
        if (column >= array.Columns || position >= array.Values.Length)
        {
            FailAt(start, $"{name} has no element of this number");
            return VariablePlace.Machine;
        }

        return VariablePlace.Element(name!, (int)position);
    }

    // NOT x, B_NOT x, TRUE, FALSE: words in the place of an operand.
    private bool Prefixed(out NcValue value)
    {
        value = default;
        var isBits = StandsAlone("B_NOT");
        if (isBits || StandsAlone("NOT"))
        {
            _at += isBits ? 5 : 3;
            var operand = Operand();
            value = operand.Kind switch
            {
                NcValueKind.Unknown => NcValue.Unknown,
                NcValueKind.Text => Fail("a text is neither true nor false"),
                _ when !isBits => NcValue.Of(operand.Number == 0),
                _ =>
                    Math.Abs(operand.Number) < int.MaxValue
                        ? NcValue.Of(~(int)Math.Round(operand.Number))
                        : Fail("the number is too large for an operation on its bits"),
            };
            return true;
        }

        var isTrue = StandsAlone("TRUE");
        if (isTrue || StandsAlone("FALSE"))
        {
            _at += isTrue ? 4 : 5;
            value = NcValue.Of(isTrue);
            return true;
        }

        return false;
    }

    private readonly bool StandsAlone(string word) => StandsHere(word) && !IsNamePart(Peek(word.Length));

    private NcValue Number()
    {
        Span<byte> digits = stackalloc byte[64];
        var (start, length, points) = (_at, 0, 0);
        for (; SyntaxBytes.IsDigit(Peek()) || Peek() == '.' || (_syntax.Syntax == NcSyntax.LinuxCnc && SpaceInNumber()); _at++)
        {
            if (Peek() is (byte)' ' or (byte)'\t')
            {
                continue;
            }

            points += Peek() == '.' ? 1 : 0;
            if (length == digits.Length || points > 1)
            {
                return FailAt(start, points > 1 ? "a number has two points" : "a number has too many digits");
            }

            digits[length++] = Peek();
        }

        if (IsSiemens && StandsHere("EX") && length < digits.Length - 8)
        {
            digits[length++] = (byte)'E';
            _at += 2;
            for (var first = _at; (SyntaxBytes.IsDigit(Peek()) || (_at == first && Peek() is (byte)'-' or (byte)'+'))
                && _at - first < 5; _at++)
            {
                digits[length++] = Peek();
            }
        }

        return Utf8Parser.TryParse(digits[..length], out double value, out var read) && read == length && double.IsFinite(value)
            ? NcValue.Of(value)
            : FailAt(start, "this is no number");
    }

    // LinuxCNC ignores spaces in numbers: 1 2 is 12.
    private readonly bool SpaceInNumber()
    {
        var behind = BehindSpaces(0);
        return behind > _at && behind < _text.Length && (SyntaxBytes.IsDigit(_text[behind]) || _text[behind] == '.');
    }

    private NcValue Quoted()
    {
        var length = _text[(_at + 1)..].IndexOf((byte)'"');
        if (length < 0)
        {
            return Fail("a text is not closed: a quotation mark is missing");
        }

        var text = NcText.Decode(_text.Slice(_at + 1, length));
        _at += length + 2;
        return NcValue.Of(text);
    }

    // 'H1F' is hexadecimal, 'B101' binary.
    private NcValue Coded()
    {
        var length = _text[(_at + 1)..].IndexOf((byte)'\'');
        var digits = length < 2 ? default : _text.Slice(_at + 2, length - 1);
        var (radix, value) = ((Peek(1) | 0x20) == 'h' ? 16 : (Peek(1) | 0x20) == 'b' ? 2 : 0, 0.0);
        if (digits.Length is 0 or > 32 || radix == 0)
        {
            return Fail("this is no number");
        }

        foreach (var c in digits)
        {
            var digit = SyntaxBytes.IsDigit(c) ? c - '0' : (c | 0x20) is >= 'a' and <= 'f' ? (c | 0x20) - 'a' + 10 : radix;
            if (digit >= radix)
            {
                return Fail("this is no number");
            }

            value = (value * radix) + digit;
        }

        _at += length + 2;
        return NcValue.Of(value);
    }
}
