using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Computes operators and functions. A result is unknown if an operand is unknown. An undefined result gives an error message,
/// never NaN.</summary>
internal static class ExpressionArithmetic
{
    private const double CloseTo = 0.00001;
    private const double RelativeTo = 1e-12;

    // STRING[200] is the longest of Siemens (Job Planning, DEF); texts in between may be somewhat longer.
    private const int LongestText = 400;
    private const double LargestWhole = 9.0e15;

    /// <summary>Applies an operator. The error says why there is no result; it is null if there is one.</summary>
    public static NcValue Apply(ExpressionOperator what, NcValue a, NcValue b, ExpressionEquality equality, out string? error)
    {
        error = null;
        if (a.IsUnknown || b.IsUnknown)
        {
            return NcValue.Unknown;
        }

        if (what == ExpressionOperator.Join)
        {
            var (first, second) = (Text(a), Text(b));
            if (first.Length + second.Length > LongestText)
            {
                error = $"a text of more than {LongestText} characters";
                return NcValue.Unknown;
            }

            return NcValue.Of(first + second);
        }

        if (what is ExpressionOperator.Equal or ExpressionOperator.NotEqual && Differ(a, b) is { } differ)
        {
            return NcValue.Of(differ == (what == ExpressionOperator.NotEqual));
        }

        if (a.Kind == NcValueKind.Text || b.Kind == NcValueKind.Text)
        {
            error = "a text cannot be computed with";
            return NcValue.Unknown;
        }

        return Finite(Compute(what, a.Number, b.Number, equality, ref error), ref error);
    }

    /// <summary>Applies a function to its arguments; <see cref="ExpressionFunction.Round"/> rounds to a number of decimals. The error is
    /// null if there is a result.</summary>
    public static NcValue Apply(ExpressionFunction what, ReadOnlySpan<NcValue> arguments, int decimals, out string? error)
    {
        error = null;
        foreach (var argument in arguments)
        {
            if (argument.Kind == NcValueKind.Text)
            {
                error = "a text cannot be computed with";
                return NcValue.Unknown;
            }
        }

        foreach (var argument in arguments)
        {
            if (argument.IsUnknown)
            {
                return NcValue.Unknown;
            }
        }

        var (a, b) = (arguments[0].Number, arguments.Length > 1 ? arguments[1].Number : 0);
        var value = what switch
        {
            ExpressionFunction.ArcTangentOfTurn when arguments.Length == 1 => Degrees(Elementary.Atan(a)),
            ExpressionFunction.Bound =>
                a > b ? Fail("the bounds are the wrong way round", ref error) : Math.Clamp(arguments[2].Number, a, b),
            _ => Compute(what, a, b, decimals, ref error),
        };
        return Finite(value, ref error);
    }

    // Whether two values differ if at least one is not a number: a vacant value equals only a vacant value, a text only the same text.
    // Null if both are numbers.
    private static bool? Differ(NcValue a, NcValue b) =>
        a.Kind != b.Kind ? true : a.Kind switch
        {
            NcValueKind.Vacant => false,
            NcValueKind.Text => !string.Equals(a.Text, b.Text, StringComparison.OrdinalIgnoreCase),
            _ => null,
        };

    private static string Text(NcValue value) => value.Kind == NcValueKind.Text ? value.Text! : value.ToString();

    private static double Compute(ExpressionOperator what, double a, double b, ExpressionEquality equality, ref string? error)
    {
        switch (what)
        {
            case ExpressionOperator.Add: return a + b;
            case ExpressionOperator.Subtract: return a - b;
            case ExpressionOperator.Multiply: return a * b;
            case ExpressionOperator.Divide: return b == 0 ? Fail("division by zero", ref error) : a / b;
            case ExpressionOperator.DivideWhole: return b == 0 ? Fail("division by zero", ref error) : Math.Truncate(a / b);
            case ExpressionOperator.Remainder:
                var (dividend, divisor) = (Round(a), Round(b));
                return divisor == 0 ? Fail("division by zero", ref error) : dividend % divisor;
            case ExpressionOperator.PositiveRemainder:
                var rest = b == 0 ? Fail("division by zero", ref error) : a % b;
                return rest < 0 ? rest + Math.Abs(b) : rest;
            case ExpressionOperator.Power: return Power(a, b, ref error);
            case ExpressionOperator.BitAnd: return Whole(a, ref error) & Whole(b, ref error);
            case ExpressionOperator.BitOr: return Whole(a, ref error) | Whole(b, ref error);
            case ExpressionOperator.BitXor: return Whole(a, ref error) ^ Whole(b, ref error);
            case ExpressionOperator.And: return a != 0 && b != 0 ? 1 : 0;
            case ExpressionOperator.Or: return a != 0 || b != 0 ? 1 : 0;
            case ExpressionOperator.Xor: return a != 0 != (b != 0) ? 1 : 0;
            default: return Compare(what, a, b, equality) ? 1 : 0;
        }
    }

    private static bool Compare(ExpressionOperator what, double a, double b, ExpressionEquality equality)
    {
        var difference = Math.Abs(a - b);
        var equal = equality switch
        {
            ExpressionEquality.Close => difference < CloseTo,
            ExpressionEquality.Relative => difference <= RelativeTo * Math.Max(Math.Abs(a), Math.Abs(b)),
            _ => a == b,
        };
        var same = equality == ExpressionEquality.Close ? a == b : equal;
        return what switch
        {
            ExpressionOperator.Equal => equal,
            ExpressionOperator.NotEqual => !equal,
            ExpressionOperator.Less => !same && a < b,
            ExpressionOperator.LessOrEqual => same || a < b,
            ExpressionOperator.Greater => !same && a > b,
            _ => same || a > b,
        };
    }

    private static double Compute(ExpressionFunction what, double a, double b, int decimals, ref string? error)
    {
        switch (what)
        {
            case ExpressionFunction.Sine: return Sine(a);
            case ExpressionFunction.Cosine: return Sine((a % 360) + 90);
            case ExpressionFunction.Tangent:
                var cosine = Sine((a % 360) + 90);
                return cosine == 0 ? Fail("this angle has no tangent", ref error) : Sine(a) / cosine;
            case ExpressionFunction.ArcSine or ExpressionFunction.ArcSineOfTurn or ExpressionFunction.ArcCosine:
                return Math.Abs(a) > 1
                    ? Fail("the argument of an arc sine or arc cosine is not between -1 and 1", ref error)
                    : ArcOf(what, a);
            case ExpressionFunction.ArcTangent: return Degrees(Elementary.Atan(a));
            case ExpressionFunction.ArcTangentOfPoint: return Degrees(Elementary.Atan2(a, b));
            case ExpressionFunction.ArcTangentOfTurn: return Turn(Degrees(Elementary.Atan2(a, b)));
            case ExpressionFunction.SquareRoot: return a < 0 ? Fail("square root of a negative number", ref error) : Math.Sqrt(a);
            case ExpressionFunction.Square: return a * a;
            case ExpressionFunction.Absolute: return Math.Abs(a);
            case ExpressionFunction.Round: return Round(a * Scale(decimals)) / Scale(decimals);
            case ExpressionFunction.Truncate: return Math.Truncate(a);
            case ExpressionFunction.AwayFromZero: return a < 0 ? Math.Floor(a) : Math.Ceiling(a);
            case ExpressionFunction.Floor: return Math.Floor(a);
            case ExpressionFunction.Ceiling: return Math.Ceiling(a);
            case ExpressionFunction.Logarithm:
                return a <= 0 ? Fail("logarithm of a number that is not positive", ref error) : Elementary.Log(a);
            case ExpressionFunction.Exponential: return Elementary.Exp(a);
            case ExpressionFunction.Power: return Power(a, b, ref error);
            case ExpressionFunction.FromDecimalCode: return Recode(Whole(a, ref error), 16, 10, ref error);
            case ExpressionFunction.ToDecimalCode: return Recode(Whole(a, ref error), 10, 16, ref error);
            case ExpressionFunction.Minimum: return Math.Min(a, b);
            case ExpressionFunction.Maximum: return Math.Max(a, b);
            default: return a;
        }
    }

    private static double ArcOf(ExpressionFunction what, double a) => what switch
    {
        ExpressionFunction.ArcCosine => Degrees(Elementary.Acos(a)),
        ExpressionFunction.ArcSineOfTurn => Turn(Degrees(Elementary.Asin(a))),
        _ => Degrees(Elementary.Asin(a)),
    };

    // Exact at the quarter turns, where a program may check whether a sine is zero.
    private static double Sine(double degrees)
    {
        var angle = degrees % 360;
        angle = angle < 0 ? angle + 360 : angle;
        return angle switch
        {
            0 or 180 or 360 => 0,
            90 => 1,
            270 => -1,
            30 or 150 => 0.5,
            210 or 330 => -0.5,
            _ => Elementary.Sin(angle * Math.PI / 180),
        };
    }

    private static double Degrees(double radians) => radians * 180 / Math.PI;

    private static double Turn(double degrees) => degrees < 0 ? degrees + 360 : degrees;

    private static double Round(double value) => Math.Round(value, MidpointRounding.AwayFromZero);

    private static double Scale(int decimals) => Elementary.Pow(10, decimals);

    private static double Power(double a, double b, ref string? error)
    {
        if (a < 0 && b != Math.Floor(b))
        {
            return Fail("a negative number has no power that is not whole", ref error);
        }

        return a == 0 && b < 0 ? Fail("division by zero", ref error) : Elementary.Pow(a, b);
    }

    private static long Whole(double value, ref string? error)
    {
        if (Math.Abs(value) < LargestWhole)
        {
            return (long)Round(value);
        }

        error = "the number is too large for an operation on its bits";
        return 0;
    }

    private static double Recode(long value, int from, int to, ref string? error)
    {
        var (result, place) = (0.0, 1.0);
        for (var rest = Math.Abs(value); rest != 0; rest /= from)
        {
            if (rest % from > 9)
            {
                return Fail("the number is no binary-coded decimal", ref error);
            }

            result += rest % from * place;
            place *= to;
        }

        return value < 0 ? -result : result;
    }

    private static double Fail(string why, ref string? error)
    {
        error = why;
        return 0;
    }

    private static NcValue Finite(double value, ref string? error)
    {
        if (double.IsFinite(value))
        {
            return error is null ? NcValue.Of(value) : NcValue.Unknown;
        }

        error ??= "the result is too large";
        return NcValue.Unknown;
    }
}
