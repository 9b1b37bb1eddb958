namespace ErrorMatching.Freeform;

/// <summary>What an attribute of a STEP instance is.</summary>
internal enum StepValueKind
{
    /// <summary>Left out: $ or *.</summary>
    Omitted,

    /// <summary>A whole or real number.</summary>
    Number,

    /// <summary>A string.</summary>
    Text,

    /// <summary>A word between points, such as .T.</summary>
    Word,

    /// <summary>A reference to an instance.</summary>
    Reference,

    /// <summary>Values in brackets.</summary>
    List,

    /// <summary>A value with its type's name.</summary>
    Typed,
}
