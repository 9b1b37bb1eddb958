namespace ErrorMatching.Freeform;

/// <summary>The kind of an attribute of a STEP instance.</summary>
internal enum StepValueKind
{
    /// <summary>Omitted: $ or *.</summary>
    Omitted,

    /// <summary>An integer or real number.</summary>
    Number,

    /// <summary>A string.</summary>
    Text,

    /// <summary>A word between periods, such as .T.</summary>
    Word,

    /// <summary>A reference to an instance.</summary>
    Reference,

    /// <summary>Values in parentheses.</summary>
    List,

    /// <summary>A value with a type name.</summary>
    Typed,
}
