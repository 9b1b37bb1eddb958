namespace ErrorMatching.Freeform;

/// <summary>The kind of function that describes a field best.</summary>
public enum FieldModelKind
{
    /// <summary>A sparse polynomial, with breaks of the second derivative if needed.</summary>
    Polynomial,

    /// <summary>A Gaussian process with a squared-exponential kernel about a low-degree polynomial, for waves.</summary>
    GaussianProcess,

    /// <summary>A smoothing cubic spline, if neither of the others fits.</summary>
    CubicSpline,
}
