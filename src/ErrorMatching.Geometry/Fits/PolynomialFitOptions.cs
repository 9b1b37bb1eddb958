namespace ErrorMatching.Geometry;

/// <summary>What a polynomial fit is told and what it chooses itself. The default chooses the degree and does not regularize.</summary>
public sealed record PolynomialFitOptions
{
    /// <summary>The degree, or null to choose it by the leave-one-out error.</summary>
    public int? Degree { get; init; }

    /// <summary>The highest degree that may be chosen; what the points allow (one less than their number less one, at most) limits it further.</summary>
    public int MaxDegree { get; init; } = 10;

    /// <summary>
    /// The ridge weight, without dimension: the coefficient of the orthonormal basis polynomial of degree k is divided by <c>1 + weight k^4</c>.
    /// Zero is plain least squares; null chooses zero or one of 10^-6, 10^-5.5 .. 1 by the leave-one-out error.
    /// </summary>
    public double? Ridge { get; init; } = 0;

    /// <summary>Standard uncertainty of a point's ordinate that the gauge states, in millimetres. Standard errors use it where it exceeds what the residuals show.</summary>
    public double PointUncertaintyMm { get; init; }
}
