namespace ErrorMatching.Jobs;

/// <summary>Limits for reading DXF files. A broken or hostile file must end in a message, not exhaust time or memory.</summary>
internal static class DxfLimits
{
    /// <summary>Maximum size of a file, bytes.</summary>
    public const int MaxBytes = 1 << 26;

    /// <summary>Maximum number of entities with curves in the file.</summary>
    public const int MaxEntities = 400_000;

    /// <summary>Maximum number of entities looked at while blocks are inserted, and of the copies of one INSERT. Blocks of blocks could
    /// otherwise be without a curve and without an end.</summary>
    public const int MaxVisits = 1_000_000;

    /// <summary>Maximum nesting of blocks.</summary>
    public const int MaxDepth = 32;

    /// <summary>Maximum degree of a spline, as in the programs that the format comes from.</summary>
    public const int MaxDegree = 11;

    /// <summary>Maximum number of kinds of entities and of layers that a note counts by name.</summary>
    public const int MaxNamed = 12;
}
