namespace ErrorMatching.Nc;

/// <summary>What a letter stands for in a dialect.</summary>
public enum LetterRole : byte
{
    /// <summary>Not in the table.</summary>
    Unknown,

    /// <summary>Changes no position: spindle, tool, offset numbers, parameters.</summary>
    Harmless,

    /// <summary>X, Y or Z.</summary>
    Axis,

    /// <summary>I, J or K.</summary>
    Center,

    /// <summary>Radius of an arc.</summary>
    Radius,

    /// <summary>Feed.</summary>
    Feed,

    /// <summary>Preparatory code.</summary>
    G,

    /// <summary>Miscellaneous function.</summary>
    M,

    /// <summary>Block number.</summary>
    Number,

    /// <summary>Program number.</summary>
    Program,

    /// <summary>A rotary or secondary axis.</summary>
    OtherAxis,
}
