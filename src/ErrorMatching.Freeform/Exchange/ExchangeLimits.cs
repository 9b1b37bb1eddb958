namespace ErrorMatching.Freeform;

/// <summary>Limits for reading surface files. A broken or hostile file must end in a message, not exhaust memory.</summary>
internal static class ExchangeLimits
{
    public const int MaxBytes = 1 << 26;

    /// <summary>Maximum number of poles of one surface or curve.</summary>
    public const int MaxPoles = 4_000_000;

    /// <summary>Maximum nesting of entities that refer to each other, and of lists in lists.</summary>
    public const int MaxDepth = 32;

    /// <summary>Maximum number of curves that bound one surface.</summary>
    public const int MaxCurves = 100_000;

    /// <summary>Maximum number of points in the boundary polygons of one surface.</summary>
    public const int MaxLoopPoints = 200_000;

    /// <summary>Maximum length of text quoted in a message.</summary>
    public const int MaxQuoted = 40;

    /// <summary>Quotes a piece of a file for a message.</summary>
    public static string Quote(string text) => "\"" + (text.Length <= MaxQuoted ? text : text[..MaxQuoted] + "...") + "\"";
}
