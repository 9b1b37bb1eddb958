namespace ErrorMatching.Freeform;

/// <summary>What kind of function describes a field best.</summary>
public enum FieldModelKind
{
    /// <summary>Few terms of a polynomial, with breaks of the second derivative where there are any.</summary>
    Polynomial,

    /// <summary>A Gaussian process with a squared-exponential kernel about a low polynomial: waves.</summary>
    GaussianProcess,

    /// <summary>A smoothed cubic spline: what neither of the others describes.</summary>
    CubicSpline,
}
