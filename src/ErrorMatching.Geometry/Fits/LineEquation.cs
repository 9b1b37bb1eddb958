namespace ErrorMatching.Geometry;

/// <summary>The straight line <c>y = Intercept + Slope x</c> (equation 4 of Wang 2021) with standard errors.</summary>
/// <param name="Intercept">y at x = 0, in millimeters.</param>
/// <param name="InterceptStandardError">Standard error of the intercept, in millimeters.</param>
/// <param name="Slope">Rise of y per x.</param>
/// <param name="SlopeStandardError">Standard error of the slope.</param>
public readonly record struct LineEquation(double Intercept, double InterceptStandardError, double Slope, double SlopeStandardError);
