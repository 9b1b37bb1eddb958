using System.Globalization;
using System.Text;

namespace ErrorMatching.Nc;

/// <summary>Reads variables, numbers and formulas of Okuma OSP: multiplication before addition before comparison, functions with
/// brackets, angles in degrees. Where sources disagree or none was found, the value is unknown, or the formula is refused.</summary>
internal ref struct OkumaFormula(ReadOnlySpan<byte> text, int at, NcVariables variables)
{
    private const int Deepest = 50;
    private const int LongestName = 16;

    /// <summary>Difference up to which two unequal values could be equal on the control.</summary>
    private const double Close = 1e-9;

    private readonly ReadOnlySpan<byte> _text = text;
    private int _depth;
    private bool _hasEmpty;

    /// <summary>The position, from the start of the block.</summary>
    public int At { get; set; } = at;

    /// <summary>What is wrong; null if nothing is.</summary>
    public string? Error { get; private set; }

    /// <summary>Where it is wrong, from the start of the block.</summary>
    public int ErrorAt { get; private set; }

    private readonly byte Next => At < _text.Length ? _text[At] : (byte)0;

    /// <summary>True if only spaces follow.</summary>
    public bool IsAtEnd
    {
        get
        {
            SkipSpaces();
            return At >= _text.Length;
        }
    }

    /// <summary>The name here, in capitals; empty if none is.</summary>
    public string Name()
    {
        SkipSpaces();
        var length = BlockHead.NameLength(_text, At);
        var name = NcText.Decode(_text.Slice(At, length)).ToUpperInvariant();
        At += length;
        return name;
    }

    /// <summary>A variable: VC1, V1 and VC[..] are common to all programs, other names with V belong to the machine, the rest to the
    /// program that runs.</summary>
    public VariablePlace Place()
    {
        var start = At;
        var name = Name();
        start = At - name.Length;
        var letters = name.TrimEnd("0123456789".ToCharArray());
        var isCommon = letters is "V" or "VC";
        if (isCommon && letters.Length < name.Length)
        {
            return int.TryParse(name.AsSpan(letters.Length), NumberStyles.None, CultureInfo.InvariantCulture, out var number)
                ? Common(letters, number) : Refuse(start, "the number of a variable is too large");
        }

        if (isCommon)
        {
            var index = Next == '[' ? Bracket() : Fail("the number of a variable is expected here");
            return !index.IsNumber ? VariablePlace.Machine
                : index.Number != Math.Floor(index.Number) || index.Number is < 0 or > int.MaxValue
                ? Refuse(start, "the number of a variable must be a whole number")
                : Common(letters, (int)index.Number);
        }

        if (name.Length < 2 || name.Length > LongestName || name is "EMPTY" or "NOT" or "AND" or "OR" or "EOR" or "MOD")
        {
            return Refuse(start, "a variable is expected here");
        }

        if (name[0] == 'V')
        {
            At = Next == '[' ? SyntaxBytes.BehindBracket(_text, At, _text.Length) : At;
            return VariablePlace.Machine;
        }

        return Next == '[' ? Refuse(start, "no function of this name is known") : VariablePlace.Named(name);
    }

    /// <summary>What a variable is set to. Whether it becomes empty by another one that is, has no source.</summary>
    public NcValue Value()
    {
        _hasEmpty = false;
        var value = Sum();
        return value.IsVacant && !_hasEmpty ? NcValue.Unknown : value;
    }

    /// <summary>Q2 or Q=VC1, if it is here.</summary>
    public bool TakeRepeats(out NcValue repeats)
    {
        SkipSpaces();
        repeats = NcValue.Unknown;
        var behind = SyntaxBytes.SkipSpaces(_text, At + 1, _text.Length);
        if ((Next | 0x20) != 'q' || behind >= _text.Length || !(SyntaxBytes.IsDigit(_text[behind]) || _text[behind] == '='))
        {
            return false;
        }

        At = _text[behind] == '=' ? behind + 1 : behind;
        repeats = Used(Sum());
        return true;
    }

    /// <summary>A sum of products.</summary>
    public NcValue Sum()
    {
        if (++_depth > Deepest)
        {
            Fail("the formula is nested too deep");
            return NcValue.Unknown;
        }

        var value = Product();
        for (SkipSpaces(); Error is null && Next is (byte)'+' or (byte)'-'; SkipSpaces())
        {
            var what = _text[At++] == '+' ? ExpressionOperator.Add : ExpressionOperator.Subtract;
            value = Apply(what, value, Product());
        }

        _depth--;
        return value;
    }

    /// <summary>A formula in brackets; here, values can be compared.</summary>
    public NcValue Bracket()
    {
        Expect((byte)'[');
        if (Error is not null || ++_depth > Deepest)
        {
            return Fail("the formula is nested too deep");
        }

        var left = Sum();
        while (Error is null && Operator() is { } what)
        {
            // Which of two such operators comes first has no source: both sides are in brackets, or are values.
            var isLogic = what is ExpressionOperator.BitAnd or ExpressionOperator.BitOr or ExpressionOperator.BitXor;
            var right = isLogic ? Operand() : Sum();
            left = isLogic ? Apply(what, left, right) : Compare(what, left, right);
            SkipSpaces();
            if (Error is null && Next != ']' && !isLogic)
            {
                Fail("\"]\" is expected here: put each comparison in brackets");
            }
        }

        _depth--;
        Expect((byte)']');
        return Error is null ? left : NcValue.Unknown;
    }

    public bool TakeWord(string word)
    {
        SkipSpaces();
        var stands = _text.Length - At >= word.Length && Ascii.EqualsIgnoreCase(_text.Slice(At, word.Length), word)
            && !(At + word.Length < _text.Length && SyntaxBytes.IsNamePart(_text[At + word.Length]));
        At += stands ? word.Length : 0;
        return stands;
    }

    public void Expect(byte c)
    {
        SkipSpaces();
        if (Next == c && At < _text.Length)
        {
            At++;
        }
        else
        {
            Fail($"\"{(char)c}\" is expected here");
        }
    }

    /// <summary>Stops reading with an error at the current position.</summary>
    public NcValue Fail(string why)
    {
        if (Error is null)
        {
            (Error, ErrorAt) = (why, At);
        }

        return NcValue.Unknown;
    }

    private void SkipSpaces() => At = SyntaxBytes.SkipSpaces(_text, At, _text.Length);

    private static VariablePlace Common(string letters, int number) =>
        VariablePlace.Named(string.Create(CultureInfo.InvariantCulture, $"_{letters}{number}"));

    private VariablePlace Refuse(int start, string why)
    {
        At = start;
        Fail(why);
        return VariablePlace.Machine;
    }

    private NcValue Product()
    {
        var value = Operand();
        for (SkipSpaces(); Error is null && Next is (byte)'*' or (byte)'/'; SkipSpaces())
        {
            var what = _text[At++] == '*' ? ExpressionOperator.Multiply : ExpressionOperator.Divide;
            value = Apply(what, value, Operand());
        }

        return value;
    }

    private NcValue Operand()
    {
        SkipSpaces();
        if (Error is not null || ++_depth > Deepest)
        {
            return Fail("the formula is nested too deep");
        }

        var value = Next switch
        {
            (byte)'+' or (byte)'-' => Signed(),
            (byte)'[' => Bracket(),
            (byte)'#' => Hexadecimal(),
            (byte)'\'' => Quoted(),
            (byte)'.' or (>= (byte)'0' and <= (byte)'9') => Number(),
            var c when SyntaxBytes.IsLetter(c) => Word(),
            _ => Fail("a value is expected here"),
        };
        _depth--;
        return value;
    }

    private NcValue Signed()
    {
        var negative = _text[At++] == '-';
        var value = Used(Operand());
        return value.IsNumber && negative ? NcValue.Of(-value.Number) : value;
    }

    private NcValue Number()
    {
        if (!new BlockScanner(_text, _text.Length, NcSyntax.Okuma).ReadNumber(At, out var next, out var number))
        {
            return Fail("this is no number");
        }

        At = next;
        return NcValue.Of(number.Value);
    }

    private NcValue Hexadecimal()
    {
        var digits = _text[(At + 1)..];
        var length = 0;
        while (length < digits.Length && char.IsAsciiHexDigit((char)digits[length]))
        {
            length++;
        }

        if (length is 0 or > 8 || length == digits.Length || (digits[length] | 0x20) != 'h')
        {
            return Fail("a hexadecimal number such as #81H is expected here");
        }

        At += length + 2;
        return NcValue.Of(long.Parse(NcText.Decode(digits[..length]), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture));
    }

    private NcValue Quoted()
    {
        var length = _text[(At + 1)..].IndexOf((byte)'\'');
        if (length < 0)
        {
            return Fail("a text is not closed: an apostrophe is missing");
        }

        var value = NcValue.Of(NcText.Decode(_text.Slice(At + 1, length)));
        At += length + 2;
        return value;
    }

    private NcValue Word()
    {
        var start = At;
        var name = Name();
        if (name == "EMPTY")
        {
            _hasEmpty = true;
            return NcValue.Vacant;
        }

        if (Next == '[' && OkumaFunctions.Exists(name))
        {
            return Call(name);
        }

        At = start;
        var place = Place();
        if (Error is not null || place.Kind == VariableKind.Machine)
        {
            return NcValue.Unknown;
        }

        // A common variable has the value of an earlier program. A name without a value is empty, unless a caller has it: whether that
        // is seen here was not found written.
        return variables.Assumed(place) is { } stated ? stated
            : variables.Find(place.Name!) is { } known ? known.Values[0]
            : place.Name![0] == '_' || variables.KnowsOutside(place.Name) ? NcValue.Unknown
            : NcValue.Vacant;
    }

    private NcValue Call(string name)
    {
        At++;
        var a = Used(Sum());
        var hasTwo = OkumaFunctions.HasTwo(name);
        if (hasTwo)
        {
            Expect((byte)',');
        }

        var b = hasTwo ? Used(Sum()) : NcValue.Zero;
        Expect((byte)']');
        if (Error is not null || !a.IsNumber || !b.IsNumber)
        {
            return NcValue.Unknown;
        }

        var value = OkumaFunctions.Apply(name, a, b, out var error);
        return error is null ? value : Fail(error);
    }

    // Computing with an empty variable has no source.
    private static NcValue Used(NcValue value) => value.IsNumber ? value : NcValue.Unknown;

    private NcValue Apply(ExpressionOperator what, NcValue a, NcValue b)
    {
        if (!a.IsNumber || !b.IsNumber)
        {
            return NcValue.Unknown;
        }

        var value = ExpressionArithmetic.Apply(what, a, b, ExpressionEquality.Exact, out var error);
        return error is null ? value : Fail(error);
    }

    private NcValue Compare(ExpressionOperator what, NcValue a, NcValue b)
    {
        var hasEmpty = _hasEmpty;
        _hasEmpty = false;
        if (a.IsUnknown || b.IsUnknown)
        {
            return NcValue.Unknown;
        }

        if (a.IsVacant || b.IsVacant)
        {
            // Only EMPTY itself tells an empty variable from a zero.
            return hasEmpty && what is ExpressionOperator.Equal or ExpressionOperator.NotEqual
                ? NcValue.Of(a.IsVacant == b.IsVacant == (what == ExpressionOperator.Equal)) : NcValue.Unknown;
        }

        var difference = Math.Abs(a.Number - b.Number);
        return !a.IsNumber || !b.IsNumber || (difference != 0 && difference < Close * Math.Max(1, Math.Abs(a.Number)))
            ? NcValue.Unknown : Apply(what, a, b);
    }

    private ExpressionOperator? Operator()
    {
        SkipSpaces();
        return TakeWord("EQ") ? ExpressionOperator.Equal
            : TakeWord("NE") ? ExpressionOperator.NotEqual
            : TakeWord("LT") ? ExpressionOperator.Less
            : TakeWord("LE") ? ExpressionOperator.LessOrEqual
            : TakeWord("GT") ? ExpressionOperator.Greater
            : TakeWord("GE") ? ExpressionOperator.GreaterOrEqual
            : TakeWord("AND") ? ExpressionOperator.BitAnd
            : TakeWord("OR") ? ExpressionOperator.BitOr
            : TakeWord("EOR") ? ExpressionOperator.BitXor
            : null;
    }
}
