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
