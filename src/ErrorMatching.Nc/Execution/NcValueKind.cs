namespace ErrorMatching.Nc;

/// <summary>What is known of a value that a program computes.</summary>
internal enum NcValueKind : byte
{
    /// <summary>Never assigned: Fanuc's null. A word whose value is vacant is as if not written.</summary>
    Vacant,

    /// <summary>A number; truth is 1 or 0.</summary>
    Number,

    /// <summary>Only the machine knows it, or it was computed from something that only the machine knows.</summary>
    Unknown,

    /// <summary>Text, as Siemens has it.</summary>
    Text,
}
