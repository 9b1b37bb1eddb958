namespace ErrorMatching.Nc;

/// <summary>How a motion of one program differs from its counterpart in another. If several apply, the first one is used.</summary>
public enum MotionChange
{
    /// <summary>Its end differs, or its arc has another center or number of turns.</summary>
    Moved,

    /// <summary>Its kind or plane differs.</summary>
    Replaced,

    /// <summary>Only its feed differs, and perhaps words that move nothing.</summary>
    Feed,

    /// <summary>The first program has no counterpart.</summary>
    Inserted,

    /// <summary>The second program has no counterpart.</summary>
    Removed,

    /// <summary>It is cut with another tool, or the tool is changed at another place (T, M6).</summary>
    Tool,

    /// <summary>The spindle setting before it or in its block differs (S, M3, M4, M5).</summary>
    Spindle,

    /// <summary>Other words that move nothing differ before it or in its block.</summary>
    Words,
}
