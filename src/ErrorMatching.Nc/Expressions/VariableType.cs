namespace ErrorMatching.Nc;

/// <summary>Type of a defined variable (Siemens DEF).</summary>
internal enum VariableType : byte
{
    Real,

    /// <summary>Integer: assigned values are rounded.</summary>
    Integer,

    /// <summary>1 or 0.</summary>
    Truth,
    Text,

    /// <summary>Axes and frames: their values are not followed.</summary>
    Opaque,
}
