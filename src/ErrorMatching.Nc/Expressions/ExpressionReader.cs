using System.Diagnostics.CodeAnalysis;
using System.Runtime.CompilerServices;

namespace ErrorMatching.Nc;

/// <summary>Reads an expression from a block's bytes and computes it while reading: precedence climbing over the operators of
/// <see cref="ExpressionSyntax"/>. The first error stops it; from then on every value is unknown and nothing more is read.</summary>
internal ref struct ExpressionReader
{
    private readonly ExpressionSyntax _syntax;

    /// <summary>The bytes, and how far they have been read.</summary>
    public ExpressionText Text;

    /// <param name="text">The bytes of the block.</param>
    /// <param name="at">Position of the first byte to read.</param>
    /// <param name="syntax">Expression syntax of the family.</param>
    /// <param name="variables">Values of variables.</param>
    public ExpressionReader(ReadOnlySpan<byte> text, int at, ExpressionSyntax syntax, NcVariables variables)
    {
        Text = new(text, at);
        _syntax = syntax;
        Variables = variables;
    }

    /// <summary>Decimals to which ROUND rounds: 0 in a computation; in an address, Fanuc rounds to the least increment.</summary>
    public int RoundDecimals { get; init; }

    /// <summary>Values of variables.</summary>
    public NcVariables Variables { get; }

    /// <summary>Syntax of the family.</summary>
    public readonly NcSyntax Syntax => _syntax.Syntax;

    /// <summary>The first byte not read.</summary>
    public int At
    {
        readonly get => Text.At;
        set => Text.At = value;
    }

    /// <summary>The error message; null if there is no error.</summary>
    public readonly string? Error => Text.Error;

    /// <summary>Position of the error, from the start of the block.</summary>
    public readonly int ErrorAt => Text.ErrorAt;

    private readonly bool IsSiemens => Syntax == NcSyntax.Siemens;

    /// <summary>Reads the longest expression from here.</summary>
    public NcValue Expression() => Expression(0);

    /// <summary>Reads one operand: a number, variable, function or bracket, with its sign.</summary>
    public NcValue Operand()
    {
        SkipSpaces();
        if (Error is not null || !Text.Deeper())
        {
            return NcValue.Unknown;
        }

        var value = Text.Peek() switch
        {
            (byte)'+' => Signed(negative: false),
            (byte)'-' => Signed(negative: true),
            (byte)'#' when !IsSiemens => Variable(),
            (byte)'.' or (>= (byte)'0' and <= (byte)'9') => ExpressionLiterals.Number(ref Text, Syntax),
            (byte)'"' when IsSiemens => ExpressionLiterals.Quoted(ref Text),
            (byte)'\'' when IsSiemens => ExpressionLiterals.Coded(ref Text),
            (byte)'$' when IsSiemens => Variable(),
            var c when c == _syntax.Open => Bracket(),
            var c when ExpressionText.BeginsName(c) => Word(),
            0 when Text.IsAtEnd => Fail("a value is missing at the end"),
            _ => Fail("a value is expected here"),
        };
        Text.Leave();
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
        return Text.Close(_syntax.Close) ? value : NcValue.Unknown;
    }

    /// <summary>Reads the variable here: <c>#1</c>, <c>#[#2+1]</c>, <c>##3</c>, <c>#&lt;name&gt;</c>, <c>R1</c>, <c>R[..]</c>,
    /// <c>NAME</c>, <c>NAME[i, j]</c>, <c>$..</c>.</summary>
    public VariablePlace Place() => VariableReader.Place(ref this);

    /// <summary>Reads a variable and returns its value.</summary>
    public NcValue Variable()
    {
        var start = At;
        var place = Place();
        if (Error is not null)
        {
            return NcValue.Unknown;
        }

        var value = Variables.Read(place, out var error);
        return error is null ? value : Text.FailAt(start, error);
    }

    /// <summary>Stops reading with an error at the current position.</summary>
    public NcValue Fail(string why) => Text.Fail(why);

    public void SkipSpaces() => Text.SkipSpaces();

    /// <summary>Reads a character after spaces, if it is here.</summary>
    public bool Take(byte c) => Text.Take(c);

    private NcValue Expression(int rank)
    {
        var left = Operand();
        while (Error is null && Operator(out var length) is { } found && found.Rank >= rank)
        {
            var place = At;
            At += length;
            if (!Text.Deeper())
            {
                return NcValue.Unknown;
            }

            var right = Expression(found.Rank + 1);
            Text.Leave();
            if (Error is not null)
            {
                return NcValue.Unknown;
            }

            left = ExpressionArithmetic.Apply(found.Meaning, left, right, _syntax.Equality, out var error);
            if (error is not null)
            {
                return Text.FailAt(place, error);
            }
        }

        return Error is null ? left : NcValue.Unknown;
    }

    // The operator here, after spaces; reads nothing yet.
    private OperatorSpelling? Operator(out int length)
    {
        SkipSpaces();
        length = 0;
        if (Text.Peek() is 0 or (byte)']' or (byte)')' or (byte)',')
        {
            // Nearly every expression ends so, and no operator begins so.
            return null;
        }

        foreach (var candidate in _syntax.Operators)
        {
            if (IsSiemens && candidate.IsWord ? Text.StandsAlone(candidate.Spelling) : Text.StandsHere(candidate.Spelling))
            {
                length = candidate.Spelling.Length;
                return candidate;
            }
        }

        return null;
    }

    private NcValue Signed(bool negative)
    {
        At++;
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
            if (Text.StandsHere(function.Name)
                && Text.BehindSpaces(function.Name.Length) is var open
                && Text.Peek(open) == _syntax.Open)
            {
                var place = At;
                At += open;
                return Call(function, place);
            }
        }

        if (Syntax == NcSyntax.LinuxCnc && Text.StandsHere("EXISTS"))
        {
            return Exists();
        }

        if (!IsSiemens)
        {
            return Fail("no function of this name is known");
        }

        return Prefixed(out var value) ? value : Variable();
    }

    private NcValue Call(FunctionSpelling function, int place)
    {
        At++;
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

        if (!Text.Close(_syntax.Close))
        {
            return NcValue.Unknown;
        }

        // ATAN[y]/[x]: the second argument has its own bracket.
        if (!IsSiemens
            && function.Most == 2
            && arguments.Count == 1
            && Text.BehindSpaces(0) is var slash
            && Text.Peek(slash) == '/'
            && function.Meaning is ExpressionFunction.ArcTangentOfPoint or ExpressionFunction.ArcTangentOfTurn)
        {
            var back = At;
            At += slash + 1;
            SkipSpaces();
            if (Text.Peek() == _syntax.Open)
            {
                arguments.Add(Bracket());
            }
            else
            {
                At = back;
            }
        }

        if (Error is not null)
        {
            return NcValue.Unknown;
        }

        if (arguments.Count < function.Least)
        {
            return Text.FailAt(place, $"{function.Name} needs {function.Least} arguments");
        }

        var value = ExpressionArithmetic.Apply(function.Meaning, arguments.Values, RoundDecimals, out var error);
        return error is null ? value : Text.FailAt(place, error);
    }

    private NcValue Exists()
    {
        At += "EXISTS".Length;
        if (!Take((byte)'['))
        {
            return Fail("EXISTS is followed by a variable in brackets");
        }

        // Measured with rs274. Whether a value of the machine's configuration exists, only the machine knows.
        var place = Place();
        return !Text.Close(_syntax.Close) ? NcValue.Unknown : place.Kind switch
        {
            VariableKind.Numbered => NcValue.Of(place.Number is > 0 and <= LinuxCncNames.LastNumber),
            VariableKind.Named when Variables.Knows(place.Name!) || LinuxCncNames.IsPredefined(place.Name!) => NcValue.Of(true),
            VariableKind.Named => LinuxCncNames.IsOfMachine(place.Name!) ? NcValue.Unknown : NcValue.Of(false),
            _ => NcValue.Unknown,
        };
    }

    // NOT x, B_NOT x, TRUE, FALSE: words in the place of an operand.
    private bool Prefixed(out NcValue value)
    {
        value = default;
        var isBits = Text.StandsAlone("B_NOT");
        if (isBits || Text.StandsAlone("NOT"))
        {
            At += isBits ? 5 : 3;
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

        var isTrue = Text.StandsAlone("TRUE");
        if (isTrue || Text.StandsAlone("FALSE"))
        {
            At += isTrue ? 4 : 5;
            value = NcValue.Of(isTrue);
            return true;
        }

        return false;
    }
}

/// <summary>The arguments of one function, stored without allocating.</summary>
internal struct ArgumentList
{
    private Storage _storage;

    public int Count { get; private set; }

    [UnscopedRef]
    public readonly ReadOnlySpan<NcValue> Values => ((ReadOnlySpan<NcValue>)_storage)[..Count];

    public void Add(NcValue value) => _storage[Count++] = value;

    // No function has more than three.
    [InlineArray(3)]
    private struct Storage
    {
        private NcValue _first;
    }
}
