namespace ErrorMatching.Nc;

/// <summary>How a motion of one program differs from its like in another. Where several hold, the first does.</summary>
public enum MotionChange
{
    /// <summary>It ends elsewhere, or its arc has another center or another number of turns.</summary>
    Moved,

    /// <summary>It is another kind of motion, or in another plane.</summary>
    Replaced,

    /// <summary>Only its feed differs, and perhaps words that move nothing.</summary>
    Feed,

    /// <summary>The first program has no motion like it.</summary>
    Inserted,

    /// <summary>The second program has no motion like it.</summary>
    Removed,

    /// <summary>It is cut with another tool, or the tool is changed elsewhere (T, M6).</summary>
    Tool,

    /// <summary>The spindle is set otherwise before it or in its block (S, M3, M4, M5).</summary>
    Spindle,

    /// <summary>Other words that move nothing differ before it or in its block.</summary>
    Words,
}
