namespace ErrorMatching.Geometry;

/// <summary>Options of a polynomial fit. The default selects the degree and does not regularize.</summary>
public sealed record PolynomialFitOptions
{
    /// <summary>The degree; null selects the one whose error over the whole curve is expected to be the least, or together with the ridge
    /// weight, if that is null too, the pair with the least leave-one-out error.</summary>
    public int? Degree { get; init; }

    /// <summary>The highest degree to select. The points limit it further: to the number of different abscissae minus one, and with an
    /// automatic ridge minus two.</summary>
    public int MaxDegree { get; init; } = 10;

    /// <summary>The dimensionless ridge weight: the coefficient of the orthonormal basis polynomial of degree k is divided by <c>1 +
    /// weight k^4</c>. Zero is plain least squares; null selects zero or one of 10^-6, 10^-5.5 .. 1 by the leave-one-out error.</summary>
    public double? Ridge { get; init; } = 0;

    /// <summary>The gauge's standard uncertainty of a point's ordinate, in millimeters; 0 if it is not known. It tells noise from shape
    /// where a degree is selected. Standard errors use it if it exceeds the deviation of the residuals.</summary>
    public double PointUncertaintyMm { get; init; }
}
