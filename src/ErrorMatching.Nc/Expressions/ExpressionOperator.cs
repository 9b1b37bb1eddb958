namespace ErrorMatching.Nc;

/// <summary>Operators in expressions. If a spelling has different meanings in different families, each meaning has its own name.</summary>
internal enum ExpressionOperator : byte
{
    Add,
    Subtract,
    Multiply,
    Divide,

    /// <summary>Integer part of the quotient.</summary>
    DivideWhole,

    /// <summary>Remainder of two integers, with the sign of the first.</summary>
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

    /// <summary>Concatenates two texts.</summary>
    Join,
}
