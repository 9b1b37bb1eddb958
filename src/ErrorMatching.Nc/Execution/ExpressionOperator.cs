namespace ErrorMatching.Nc;

/// <summary>What stands between two operands. Where families differ in what a spelling means, each meaning has its own name.</summary>
internal enum ExpressionOperator : byte
{
    Add,
    Subtract,
    Multiply,
    Divide,

    /// <summary>Whole part of the quotient.</summary>
    DivideWhole,

    /// <summary>Remainder of two whole numbers, with the sign of the first.</summary>
    Remainder,

    /// <summary>Remainder that is never negative.</summary>
    PositiveRemainder,
    Power,
    Equal,
    NotEqual,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    BitAnd,
    BitOr,
    BitXor,
    And,
    Or,
    Xor,

    /// <summary>Joins two texts.</summary>
    Join,
}
