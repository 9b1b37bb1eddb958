namespace ErrorMatching.Nc;

/// <summary>What a defined variable holds (Siemens DEF).</summary>
internal enum VariableType : byte
{
    Real,

    /// <summary>Whole: what is assigned is rounded.</summary>
    Integer,

    /// <summary>1 or 0.</summary>
    Truth,
    Text,

    /// <summary>Axes and frames: what they hold is not followed.</summary>
    Opaque,
}
