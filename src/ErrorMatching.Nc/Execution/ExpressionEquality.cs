namespace ErrorMatching.Nc;

/// <summary>When two numbers count as equal.</summary>
internal enum ExpressionEquality : byte
{
    /// <summary>When they are the same.</summary>
    Exact,

    /// <summary>When they differ by less than 0.00001; only in equality, not in order (LinuxCNC).</summary>
    Close,

    /// <summary>When they differ by at most 1e-12 of the larger; in order too (Siemens).</summary>
    Relative,
}
