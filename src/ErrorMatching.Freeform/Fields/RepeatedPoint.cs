namespace ErrorMatching.Freeform;

/// <summary>A point that was measured once or several times.</summary>
/// <param name="Mean">The point with the mean of its errors.</param>
/// <param name="Count">Number of measurements.</param>
/// <param name="StandardDeviationMm">Standard deviation of its measurements with n - 1, in millimeters; NaN for one measurement.</param>
/// <param name="StandardErrorMm">Standard uncertainty of the mean, the standard deviation divided by the root of n, in millimeters; NaN
/// for one measurement.</param>
public sealed record RepeatedPoint(ErrorSample Mean, int Count, double StandardDeviationMm, double StandardErrorMm);
