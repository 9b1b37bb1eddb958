namespace ErrorMatching.Freeform;

/// <summary>The kind of function that describes a field best.</summary>
public enum FieldModelKind
{
    /// <summary>A sparse polynomial, with breaks of the second derivative if needed.</summary>
    Polynomial,

    /// <summary>A Gaussian process about a low-degree polynomial: smooth in both directions, a sum of functions of each, or a wave of
    /// constant length.</summary>
    GaussianProcess,

    /// <summary>A smoothing cubic spline, if neither of the others fits.</summary>
    CubicSpline,

    /// <summary>A cubic spline through every value, if what all others leave has a structure.</summary>
    Interpolant,
}
