namespace ErrorMatching.Nc;

/// <summary>Expression syntax of a family of controls: brackets, operators with their rank, functions. Operators of the same rank are
/// computed from left to right.</summary>
/// <remarks>
/// Sources: Fanuc Series 0i-MF operator's manual B-64604EN, custom macro (parameter 6004#0 = 0, which gives the ranges of ASIN and ATAN);
/// LinuxCNC 2.9, G-code overview, with the ranks and the tolerance of EQ as rs274 shows them;
/// SINUMERIK 840D sl programming manual Job Planning, priority of the operations.
/// </remarks>
internal sealed class ExpressionSyntax
{
    private static readonly ExpressionSyntax Iso = new()
    {
        Syntax = NcSyntax.Iso,
        Operators =
        [
            new("*", ExpressionOperator.Multiply, 3), new("/", ExpressionOperator.Divide, 3), new("MOD", ExpressionOperator.Remainder, 3),
            new("AND", ExpressionOperator.BitAnd, 3),
            new("+", ExpressionOperator.Add, 2), new("-", ExpressionOperator.Subtract, 2), new("XOR", ExpressionOperator.BitXor, 2),
            new("OR", ExpressionOperator.BitOr, 2),
            .. Comparisons(1),
        ],
        Functions =
        [
            new("SIN", ExpressionFunction.Sine), new("COS", ExpressionFunction.Cosine), new("TAN", ExpressionFunction.Tangent),
            new("ASIN", ExpressionFunction.ArcSineOfTurn), new("ACOS", ExpressionFunction.ArcCosine),
            new("ATAN", ExpressionFunction.ArcTangentOfTurn, 1, 2), new("ATN", ExpressionFunction.ArcTangentOfTurn, 1, 2),
            new("SQRT", ExpressionFunction.SquareRoot), new("SQR", ExpressionFunction.SquareRoot), new("ABS", ExpressionFunction.Absolute),
            new("ROUND", ExpressionFunction.Round), new("RND", ExpressionFunction.Round), new("FIX", ExpressionFunction.Truncate),
            new("FUP", ExpressionFunction.AwayFromZero),
            new("LN", ExpressionFunction.Logarithm), new("EXP", ExpressionFunction.Exponential), new("POW", ExpressionFunction.Power, 2, 2),
            new("BIN", ExpressionFunction.FromDecimalCode), new("BCD", ExpressionFunction.ToDecimalCode),
            new("ADP", ExpressionFunction.Same),
        ],
    };

    private static readonly ExpressionSyntax LinuxCnc = new()
    {
        Syntax = NcSyntax.LinuxCnc,
        Equality = ExpressionEquality.Close,
        Operators =
        [
            new("**", ExpressionOperator.Power, 5), new("*", ExpressionOperator.Multiply, 4), new("/", ExpressionOperator.Divide, 4),
            new("MOD", ExpressionOperator.PositiveRemainder, 4),
            new("+", ExpressionOperator.Add, 3), new("-", ExpressionOperator.Subtract, 3),
            .. Comparisons(2),
            new("AND", ExpressionOperator.And, 1), new("XOR", ExpressionOperator.Xor, 1), new("OR", ExpressionOperator.Or, 1),
        ],
        Functions =
        [
            new("SIN", ExpressionFunction.Sine), new("COS", ExpressionFunction.Cosine), new("TAN", ExpressionFunction.Tangent),
            new("ASIN", ExpressionFunction.ArcSine), new("ACOS", ExpressionFunction.ArcCosine),
            new("ATAN", ExpressionFunction.ArcTangentOfPoint, 2, 2),
            new("SQRT", ExpressionFunction.SquareRoot), new("ABS", ExpressionFunction.Absolute), new("ROUND", ExpressionFunction.Round),
            new("FIX", ExpressionFunction.Floor), new("FUP", ExpressionFunction.Ceiling), new("LN", ExpressionFunction.Logarithm),
            new("EXP", ExpressionFunction.Exponential),
        ],
    };

    private static readonly ExpressionSyntax Siemens = new()
    {
        Syntax = NcSyntax.Siemens,
        Open = (byte)'(',
        Close = (byte)')',
        Equality = ExpressionEquality.Relative,
        Operators =
        [
            new("*", ExpressionOperator.Multiply, 10), new("/", ExpressionOperator.Divide, 10),
            new("DIV", ExpressionOperator.DivideWhole, 10), new("MOD", ExpressionOperator.Remainder, 10),
            new("+", ExpressionOperator.Add, 9), new("-", ExpressionOperator.Subtract, 9),
            new("B_AND", ExpressionOperator.BitAnd, 8), new("B_XOR", ExpressionOperator.BitXor, 7),
            new("B_OR", ExpressionOperator.BitOr, 6),
            new("AND", ExpressionOperator.And, 5), new("XOR", ExpressionOperator.Xor, 4), new("OR", ExpressionOperator.Or, 3),
            new("<<", ExpressionOperator.Join, 2),
            new("==", ExpressionOperator.Equal, 1), new("<>", ExpressionOperator.NotEqual, 1),
            new(">=", ExpressionOperator.GreaterOrEqual, 1),
            new("<=", ExpressionOperator.LessOrEqual, 1), new(">", ExpressionOperator.Greater, 1), new("<", ExpressionOperator.Less, 1),
        ],
        Functions =
        [
            new("SIN", ExpressionFunction.Sine), new("COS", ExpressionFunction.Cosine), new("TAN", ExpressionFunction.Tangent),
            new("ASIN", ExpressionFunction.ArcSine), new("ACOS", ExpressionFunction.ArcCosine),
            new("ATAN2", ExpressionFunction.ArcTangentOfPoint, 2, 2),
            new("SQRT", ExpressionFunction.SquareRoot), new("ABS", ExpressionFunction.Absolute), new("POT", ExpressionFunction.Square),
            new("TRUNC", ExpressionFunction.Truncate), new("ROUND", ExpressionFunction.Round), new("LN", ExpressionFunction.Logarithm),
            new("EXP", ExpressionFunction.Exponential),
            new("MINVAL", ExpressionFunction.Minimum, 2, 2), new("MAXVAL", ExpressionFunction.Maximum, 2, 2),
            new("BOUND", ExpressionFunction.Bound, 3, 3),
        ],
    };

    public NcSyntax Syntax { get; private init; }

    public byte Open { get; private init; } = (byte)'[';

    public byte Close { get; private init; } = (byte)']';

    public ExpressionEquality Equality { get; private init; }

    /// <summary>Of spellings with the same start, the longest is first.</summary>
    public required OperatorSpelling[] Operators { get; init; }

    public required FunctionSpelling[] Functions { get; init; }

    public static ExpressionSyntax Of(NcSyntax syntax) => syntax switch
    {
        NcSyntax.LinuxCnc => LinuxCnc,
        NcSyntax.Siemens => Siemens,
        _ => Iso,
    };

    private static OperatorSpelling[] Comparisons(int rank) =>
    [
        new("EQ", ExpressionOperator.Equal, rank), new("NE", ExpressionOperator.NotEqual, rank),
        new("GT", ExpressionOperator.Greater, rank),
        new("GE", ExpressionOperator.GreaterOrEqual, rank), new("LT", ExpressionOperator.Less, rank),
        new("LE", ExpressionOperator.LessOrEqual, rank),
    ];
}

/// <summary>The name of a function and its number of arguments.</summary>
/// <param name="Name">Its upper-case ASCII name.</param>
/// <param name="Meaning">What it computes.</param>
/// <param name="Least">Minimum number of arguments.</param>
/// <param name="Most">Maximum number of arguments.</param>
internal sealed record FunctionSpelling(string Name, ExpressionFunction Meaning, int Least = 1, int Most = 1);

/// <summary>The spelling of an operator and its precedence.</summary>
/// <param name="Spelling">Its upper-case ASCII text.</param>
/// <param name="Meaning">What it computes.</param>
/// <param name="Rank">Operators of a higher rank are computed first.</param>
internal sealed record OperatorSpelling(string Spelling, ExpressionOperator Meaning, int Rank)
{
    public bool IsWord => char.IsAsciiLetter(Spelling[0]);
}

/// <summary>When two numbers are equal.</summary>
internal enum ExpressionEquality : byte
{
    /// <summary>If they are identical.</summary>
    Exact,

    /// <summary>If they differ by less than 0.00001; only for equality, not for order (LinuxCNC).</summary>
    Close,

    /// <summary>If they differ by at most 1e-12 of the larger; for order too (Siemens).</summary>
    Relative,
}
