namespace ErrorMatching.Freeform;

/// <summary>A way to lay a surface through a grid of points: the paper's five (Lee 2019, section 2.3), and the one that chooses.</summary>
public enum FitMethod
{
    /// <summary>The method with the lowest error when whole grid lines are left out, curvature breaks found.</summary>
    Best,

    /// <summary>A Gordon surface through both families of curves.</summary>
    ThroughCurveMesh,

    /// <summary>Skinning: a surface through the curves along u.</summary>
    ThroughCurves,

    /// <summary>Least squares on a fixed net of poles.</summary>
    FitSurface,

    /// <summary>A fit smoothed by the bending energy of a thin plate, its weight by cross-validation.</summary>
    StudioSurface,

    /// <summary>Tensor-product interpolation through every point.</summary>
    Tensor,
}
