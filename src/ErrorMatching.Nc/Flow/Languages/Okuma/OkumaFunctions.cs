namespace ErrorMatching.Nc;

/// <summary>The functions of Okuma OSP. Angles are degrees.</summary>
internal static class OkumaFunctions
{
    private const double LargestWhole = 1e12;

    /// <summary>True for the name of a function, in capitals.</summary>
    public static bool Exists(string name) => Common(name) is not null || IsRounding(name) || HasTwo(name)
        || name is "DROUND" or "DFIX" or "DFUP" or "BIN" or "BCD";

    /// <summary>True for a function of two arguments.</summary>
    public static bool HasTwo(string name) => name is "ATAN2" or "MOD";

    /// <summary>The value of a function; unknown where sources disagree or none was found.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="a">A number.</param>
    /// <param name="b">The second number, if it has two.</param>
    /// <param name="error">Why there is no value; null if there is one.</param>
    public static NcValue Apply(string name, NcValue a, NcValue b, out string? error)
    {
        error = null;
        if (name == "MOD")
        {
            // The remainder of what is not whole or not positive has no source.
            return a.Number < 0 || b.Number <= 0 || a.Number != Math.Floor(a.Number) || b.Number != Math.Floor(b.Number)
                ? NcValue.Unknown : NcValue.Of(a.Number % b.Number);
        }

        if (IsRounding(name))
        {
            // Sources differ in the unit that is rounded to: only a whole number is the same in all.
            return a.Number == Math.Floor(a.Number) && Math.Abs(a.Number) < LargestWhole ? a : NcValue.Unknown;
        }

        // DROUND rounds to a unit that is a setting; of ATAN2, sources differ in the order of the arguments.
        return Common(name) is { } function ? ExpressionArithmetic.Apply(function, [a], 0, out error) : NcValue.Unknown;
    }

    private static bool IsRounding(string name) => name is "ROUND" or "FIX" or "FUP";

    private static ExpressionFunction? Common(string name) => name switch
    {
        "SIN" => ExpressionFunction.Sine,
        "COS" => ExpressionFunction.Cosine,
        "TAN" => ExpressionFunction.Tangent,
        "ASIN" => ExpressionFunction.ArcSine,
        "ACOS" => ExpressionFunction.ArcCosine,
        "ATAN" => ExpressionFunction.ArcTangent,
        "SQRT" => ExpressionFunction.SquareRoot,
        "ABS" => ExpressionFunction.Absolute,
        _ => null,
    };
}
