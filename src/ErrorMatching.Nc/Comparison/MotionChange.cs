namespace ErrorMatching.Nc;

/// <summary>How a motion of one program differs from its like in another.</summary>
public enum MotionChange
{
    /// <summary>It ends elsewhere, or its arc has another center or another number of turns.</summary>
    Moved,

    /// <summary>It is another kind of motion, or in another plane.</summary>
    Replaced,

    /// <summary>Only its feed differs.</summary>
    Feed,

    /// <summary>The first program has no motion like it.</summary>
    Inserted,

    /// <summary>The second program has no motion like it.</summary>
    Removed,
}
