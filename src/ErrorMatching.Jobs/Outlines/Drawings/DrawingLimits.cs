namespace ErrorMatching.Jobs;

/// <summary>Limits of drawings of all kinds. A broken or hostile file must end in a message, not exhaust time or memory.</summary>
internal static class DrawingLimits
{
    /// <summary>Maximum number of curves, after blocks are inserted.</summary>
    public const int MaxCurves = 200_000;

    /// <summary>Maximum number of points of all ellipses and splines.</summary>
    public const int MaxPoints = 2_000_000;

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
