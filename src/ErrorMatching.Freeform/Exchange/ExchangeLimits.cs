namespace ErrorMatching.Freeform;

/// <summary>How much of a surface file is read: files come from anywhere, and a broken or a hostile one must end in a sentence, not in a machine without memory.</summary>
internal static class ExchangeLimits
{
    /// <summary>Largest file in bytes.</summary>
    public const int MaxBytes = 1 << 28;

    /// <summary>Most poles of one surface or curve.</summary>
    public const int MaxPoles = 4_000_000;

    /// <summary>Deepest nesting of entities that refer to one another, and of lists in lists.</summary>
    public const int MaxDepth = 32;

    /// <summary>Most curves that the limits of one surface are made of.</summary>
    public const int MaxCurves = 100_000;

    /// <summary>Most points of the polygons that the limits of one surface become.</summary>
    public const int MaxLoopPoints = 200_000;

    /// <summary>Longest text that is quoted in a message.</summary>
    public const int MaxQuoted = 40;

    /// <summary>A piece of a file as it is quoted in a message.</summary>
    public static string Quote(string text) => "\"" + (text.Length <= MaxQuoted ? text : text[..MaxQuoted] + "...") + "\"";
}
