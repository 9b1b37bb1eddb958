namespace ErrorMatching.Nc;

/// <summary>Kind of a value computed by a program.</summary>
internal enum NcValueKind : byte
{
    /// <summary>Never assigned: Fanuc's null. A word with a vacant value counts as not written.</summary>
    Vacant,

    /// <summary>A number; true is 1 and false is 0.</summary>
    Number,

    /// <summary>Only the machine knows it, or it was computed from such a value.</summary>
    Unknown,

    /// <summary>Text (Siemens).</summary>
    Text,
}
