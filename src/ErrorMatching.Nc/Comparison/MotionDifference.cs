using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>A motion that differs between two programs.</summary>
/// <param name="Change">How it differs.</param>
/// <param name="Before">Position of the motion in the first program; -1 if it was inserted.</param>
/// <param name="After">Position of the motion in the second program; -1 if it was removed.</param>
/// <param name="Displacement">New end - old end; zero if it was inserted or removed.</param>
/// <param name="CenterDisplacement">New center - old center in the motion's plane; zero for all but arcs.</param>
/// <param name="Functions">Words that move nothing, since the previous motion, if they differ; otherwise null.</param>
public sealed record MotionDifference(
    MotionChange Change, int Before, int After, Vector3 Displacement, Vector2 CenterDisplacement, FunctionChange? Functions = null);

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

/// <summary>Words that move nothing and differ between two programs: tools, spindle, offsets, stops, variables.</summary>
/// <param name="Before">All such words of the first program since its previous motion, normalized (<c>M6</c> for M06), in order.</param>
/// <param name="After">Those of the second program.</param>
public sealed record FunctionChange(IReadOnlyList<string> Before, IReadOnlyList<string> After);
