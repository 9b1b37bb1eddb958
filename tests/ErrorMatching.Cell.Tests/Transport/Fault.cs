namespace ErrorMatching.Cell.Tests;

/// <summary>How an operation at a machine fails.</summary>
internal enum Fault
{
    None,

    /// <summary>Nothing happens, and the connection is gone.</summary>
    Before,

    /// <summary>Half a file is written, and the connection is gone.</summary>
    InPart,

    /// <summary>All happens, and the answer is lost.</summary>
    After,

    /// <summary>All happens, and a byte of what is read back is another.</summary>
    Corrupt,

    /// <summary>Nothing happens, and the server says 550.</summary>
    Denied,

    /// <summary>Nothing happens, and the server says 552.</summary>
    Full,
}
