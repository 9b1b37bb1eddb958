namespace ErrorMatching.Nc;

/// <summary>A correction of the radius with which a control compensates a tool.</summary>
/// <param name="Number">Number of the offset (D; the edge where offsets belong to a tool).</param>
/// <param name="Tool">Number of the tool.</param>
/// <param name="TotalMm">The correction in all, mm; positive moves the tool away from the contour.</param>
/// <param name="BeforeMm">The correction that must be there before; null if any may be.</param>
public sealed record RadiusCorrection(int Number, int Tool, decimal TotalMm, decimal? BeforeMm);
