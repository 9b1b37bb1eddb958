namespace ErrorMatching.Jobs;

/// <summary>Limits for reading DXF files. A broken or hostile file must end in a message, not exhaust time or memory.</summary>
internal static class DxfLimits
{
    /// <summary>Maximum size of a file, bytes.</summary>
    public const int MaxBytes = 1 << 26;

    /// <summary>Maximum number of entities with curves in the file.</summary>
    public const int MaxEntities = 400_000;

    /// <summary>Maximum number of curves after blocks are inserted.</summary>
    public const int MaxCurves = 200_000;

    /// <summary>Maximum number of entities looked at while blocks are inserted, and of the copies of one INSERT. Blocks of blocks could
    /// otherwise be without a curve and without an end.</summary>
    public const int MaxVisits = 1_000_000;

    /// <summary>Maximum number of points of all ellipses and splines.</summary>
    public const int MaxPoints = 2_000_000;

    /// <summary>Maximum nesting of blocks.</summary>
    public const int MaxDepth = 32;

    /// <summary>Maximum degree of a spline, as in the programs that the format comes from.</summary>
    public const int MaxDegree = 11;

    /// <summary>Maximum number of kinds of entities and of layers that a note counts by name.</summary>
    public const int MaxNamed = 12;

    /// <summary>Maximum absolute coordinate and maximum radius of a circle, mm. Beyond it, a workpiece is in the wrong unit.</summary>
    public const double MaxMm = 1e6;

    /// <summary>Maximum radius of an arc, mm. CAD systems write nearly straight arcs; beyond this radius, their coordinates lose digits
    /// that matter.</summary>
    public const double MaxArcMm = 1e10;

    /// <summary>Shortest length that is a line, and smallest height of a bulge that is an arc, mm.</summary>
    public const double MinMm = 1e-6;

    /// <summary>Maximum length of text quoted in a message.</summary>
    public const int MaxQuoted = 40;

    /// <summary>Quotes a piece of a file for a message.</summary>
    public static string Quote(string text) =>
        "\"" + PrintedText.OneLine(text.Length <= MaxQuoted ? text : text[..MaxQuoted] + "...") + "\"";
}
