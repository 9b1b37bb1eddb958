using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Reads Q parameters, numbers and formulas of Klartext: power before multiplication before addition, functions without
/// parentheses, angles in degrees (iTNC 530 user's manual, rules for formulas). Where the order is not stated, the value is
/// unknown.</summary>
internal ref struct KlartextFormula(ReadOnlySpan<byte> text, int at, NcVariables variables)
{
    private const int Deepest = 50;

    private static readonly string[] Functions =
        ["SQRT", "SQ", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "LN", "LOG", "EXP", "NEG", "INT", "ABS", "FRAC", "SGN"];

    private readonly ReadOnlySpan<byte> _text = text;
    private int _depth;

    /// <summary>The position, from the start of the block.</summary>
    public int At { get; private set; } = at;

    /// <summary>What is wrong; null if nothing is.</summary>
    public string? Error { get; private set; }

    /// <summary>Where it is wrong, from the start of the block.</summary>
    public int ErrorAt { get; private set; }

    /// <summary>True if only spaces follow.</summary>
    public bool IsAtEnd
    {
        get
        {
            SkipSpaces();
            return At >= _text.Length;
        }
    }

    /// <summary>A parameter: Q5, QL5, QR5, QS5. Q, QR and QS are common to all programs, QL belong to one.</summary>
    public VariablePlace Parameter()
    {
        SkipSpaces();
        var end = At < _text.Length && (_text[At] | 0x20) == 'q' ? At + 1 : At;
        end += end > At && end < _text.Length && (_text[end] | 0x20) is 'l' or 'r' or 's' ? 1 : 0;
        var digits = end;
        while (end < _text.Length && SyntaxBytes.IsDigit(_text[end]))
        {
            end++;
        }

        if (end == digits || digits == At || end - digits > 5)
        {
            Fail("a Q parameter is expected here");
            return VariablePlace.Machine;
        }

        var kind = Encoding.ASCII.GetString(_text[At..digits]).ToUpperInvariant();
        var number = int.Parse(_text[digits..end], NumberStyles.None, CultureInfo.InvariantCulture);
        At = end;
        return VariablePlace.Named(string.Create(CultureInfo.InvariantCulture, $"{(kind == "QL" ? "" : "_")}{kind}{number}"));
    }

    /// <summary>True if a parameter holds a text.</summary>
    public static bool IsText(VariablePlace place) => place.Name?.StartsWith("_QS", StringComparison.Ordinal) == true;

    /// <summary>A number or a parameter with a sign or without: +5, -Q1.</summary>
    public NcValue SignedOperand()
    {
        SkipSpaces();
        var negative = At < _text.Length && _text[At] == '-';
        At += At < _text.Length && _text[At] is (byte)'+' or (byte)'-' ? 1 : 0;
        var value = Operand();
        return negative && value.IsNumber ? NcValue.Of(-value.Number) : value;
    }

    /// <summary>A sum of products.</summary>
    public NcValue Formula()
    {
        if (++_depth > Deepest)
        {
            Fail("the formula is nested too deep");
            return NcValue.Unknown;
        }

        var value = Product();
        for (SkipSpaces(); Error is null && At < _text.Length && _text[At] is (byte)'+' or (byte)'-'; SkipSpaces())
        {
            var what = _text[At++] == '+' ? ExpressionOperator.Add : ExpressionOperator.Subtract;
            value = Apply(what, value, Product());
        }

        _depth--;
        return value;
    }

    /// <summary>A function and its argument; fails if another one is there.</summary>
    public NcValue Function(string name)
    {
        ExpectWord(name);
        return Error is null ? Call(name, SignedOperand()) : NcValue.Unknown;
    }

    public NcValue Apply(ExpressionOperator what, NcValue a, NcValue b)
    {
        if (!a.IsNumber || !b.IsNumber)
        {
            return NcValue.Unknown;
        }

        var value = ExpressionArithmetic.Apply(what, a, b, ExpressionEquality.Relative, out var error);
        if (error is not null)
        {
            Fail(error);
        }

        return value;
    }

    /// <summary>A label: 5, "NAME".</summary>
    public string Label()
    {
        SkipSpaces();
        var start = At;
        if (At < _text.Length && _text[At] == '"')
        {
            At = SyntaxBytes.BehindString(_text, At, _text.Length);
            return NcText.Decode(_text[start..At].Trim((byte)'"'));
        }

        while (At < _text.Length && SyntaxBytes.IsDigit(_text[At]))
        {
            At++;
        }

        if (At == start)
        {
            Fail("a label is expected here");
        }

        return NcText.Decode(_text[start..At]);
    }

    public bool Take(byte sign)
    {
        SkipSpaces();
        var found = At < _text.Length && _text[At] == sign;
        At += found ? 1 : 0;
        return found;
    }

    public bool TakeWord(string word)
    {
        SkipSpaces();
        var found = At + word.Length <= _text.Length && Ascii.EqualsIgnoreCase(_text.Slice(At, word.Length), word)
            && (At + word.Length == _text.Length || !SyntaxBytes.IsLetter(_text[At + word.Length])
                || (_text[At + word.Length] | 0x20) == 'q');
        At += found ? word.Length : 0;
        return found;
    }

    public void Expect(byte sign)
    {
        if (Error is null && !Take(sign))
        {
            Fail($"{(char)sign} is expected here");
        }
    }

    public void ExpectWord(string word)
    {
        if (Error is null && !TakeWord(word))
        {
            Fail($"{word} is expected here");
        }
    }

    /// <summary>FN 4 divides by DIV or a slash.</summary>
    public void ExpectDivision()
    {
        if (Error is null && !TakeWord("DIV") && !Take((byte)'/'))
        {
            Fail("DIV is expected here");
        }
    }

    public void Fail(string error)
    {
        (ErrorAt, Error) = Error is null ? (At, error) : (ErrorAt, Error);
    }

    private NcValue Product()
    {
        var value = Power();
        for (SkipSpaces(); Error is null && At < _text.Length && _text[At] is (byte)'*' or (byte)'/' or (byte)'%'; SkipSpaces())
        {
            var sign = _text[At++];
            var right = Power();
            var what = sign == '*' ? ExpressionOperator.Multiply : ExpressionOperator.Divide;

            // 400 % 360 is 40; the remainder of negative numbers is not stated.
            value = sign != '%' ? Apply(what, value, right)
                : value.IsNumber && right.IsNumber && value.Number >= 0 && right.Number > 0 ? NcValue.Of(value.Number % right.Number)
                : NcValue.Unknown;
        }

        return value;
    }

    private NcValue Power()
    {
        var (value, isPlain) = Factor();
        for (SkipSpaces(); Error is null && Take((byte)'^'); SkipSpaces())
        {
            var (exponent, isPlainToo) = Factor();
            value = isPlain && isPlainToo ? Apply(ExpressionOperator.Power, value, exponent) : NcValue.Unknown;
            isPlain = false;
        }

        return value;
    }

    // Plain is what a power can follow without doubt: an operand or parentheses, not a sign or a function.
    private (NcValue Value, bool IsPlain) Factor()
    {
        SkipSpaces();
        if (++_depth > Deepest)
        {
            Fail("the formula is nested too deep");
        }

        var found = (Value: NcValue.Unknown, IsPlain: true);
        if (Error is not null)
        {
            return found;
        }

        if (Take((byte)'('))
        {
            found.Value = Formula();
            Expect((byte)')');
        }
        else if (At < _text.Length && _text[At] is (byte)'+' or (byte)'-')
        {
            var negative = _text[At++] == '-';
            var value = Factor().Value;
            found = (negative && value.IsNumber ? NcValue.Of(-value.Number) : value, false);
        }
        else if (FunctionHere() is { } name)
        {
            found = (Call(name, Factor().Value), false);
        }
        else
        {
            found.Value = TakeWord("PI") ? NcValue.Of(Math.PI) : Operand();
        }

        _depth--;
        return found;
    }

    private string? FunctionHere()
    {
        foreach (var name in Functions)
        {
            // A number may follow at once: SIN30.
            if (TakeWord(name))
            {
                return name;
            }
        }

        return null;
    }

    private NcValue Call(string name, NcValue argument)
    {
        if (!argument.IsNumber)
        {
            return NcValue.Unknown;
        }

        var x = argument.Number;
        if ((name == "SQRT" && x < 0) || (name is "LN" or "LOG" && x <= 0) || (name is "ASIN" or "ACOS" && Math.Abs(x) > 1))
        {
            Fail($"{name} of this value does not exist");
            return NcValue.Unknown;
        }

        const double Degree = Math.PI / 180;
        var value = name switch
        {
            "SQRT" => Math.Sqrt(x),
            "SQ" => x * x,
            "SIN" => Elementary.Sin(x * Degree),
            "COS" => Elementary.Cos(x * Degree),
            "TAN" => Elementary.Tan(x * Degree),
            "ASIN" => Elementary.Asin(x) / Degree,
            "ACOS" => Elementary.Acos(x) / Degree,
            "ATAN" => Elementary.Atan(x) / Degree,
            "LN" => Elementary.Log(x),
            "LOG" => Elementary.Log10(x),
            "EXP" => Elementary.Exp(x),
            "NEG" => -x,
            "INT" => Math.Truncate(x),
            "ABS" => Math.Abs(x),
            "FRAC" => x - Math.Truncate(x),

            // Controls differ in the sign of negative numbers.
            _ => x >= 0 ? 1 : double.NaN,
        };
        return double.IsFinite(value) ? NcValue.Of(value) : NcValue.Unknown;
    }

    private NcValue Operand()
    {
        SkipSpaces();
        if (At < _text.Length && (_text[At] | 0x20) == 'q')
        {
            var place = Parameter();
            return Error is null ? variables.Read(place, out _) : NcValue.Unknown;
        }

        var start = At;
        while (At < _text.Length && (SyntaxBytes.IsDigit(_text[At]) || _text[At] == '.'))
        {
            At++;
        }

        if (double.TryParse(_text[start..At], NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out var number)
            && double.IsFinite(number))
        {
            return NcValue.Of(number);
        }

        Fail("a number or a Q parameter is expected here");
        return NcValue.Unknown;
    }

    private void SkipSpaces() => At = SyntaxBytes.SkipSpaces(_text, At, _text.Length);
}
