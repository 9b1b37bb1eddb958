namespace ErrorMatching.Nc;

/// <summary>When two numbers are equal.</summary>
internal enum ExpressionEquality : byte
{
    /// <summary>If they are identical.</summary>
    Exact,

    /// <summary>If they differ by less than 0.00001; only for equality, not for order (LinuxCNC).</summary>
    Close,

    /// <summary>If they differ by at most 1e-12 of the larger; for order too (Siemens).</summary>
    Relative,
}
