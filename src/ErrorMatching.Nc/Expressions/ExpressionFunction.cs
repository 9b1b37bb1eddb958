namespace ErrorMatching.Nc;

/// <summary>Functions in expressions. Angles are degrees.</summary>
internal enum ExpressionFunction : byte
{
    Sine,
    Cosine,
    Tangent,

    /// <summary>From -90 to 90.</summary>
    ArcSine,

    /// <summary>From 270 through 360 to 90.</summary>
    ArcSineOfTurn,
    ArcCosine,

    /// <summary>From -90 to 90.</summary>
    ArcTangent,

    /// <summary>Of a point (second argument along the first axis), from -180 to 180.</summary>
    ArcTangentOfPoint,

    /// <summary>The same from 0 to 360.</summary>
    ArcTangentOfTurn,
    SquareRoot,
    Square,
    Absolute,

    /// <summary>To the nearest whole number, halves away from zero.</summary>
    Round,

    /// <summary>Towards zero.</summary>
    Truncate,

    /// <summary>Away from zero.</summary>
    AwayFromZero,
    Floor,
    Ceiling,
    Logarithm,
    Exponential,
    Power,

    /// <summary>From binary-coded decimal to a number.</summary>
    FromDecimalCode,

    /// <summary>From a number to binary-coded decimal.</summary>
    ToDecimalCode,

    /// <summary>The argument itself.</summary>
    Same,
    Minimum,
    Maximum,

    /// <summary>The third argument, limited to the range from the first to the second.</summary>
    Bound,
}
