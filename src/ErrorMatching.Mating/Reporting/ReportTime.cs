namespace ErrorMatching.Mating;

/// <summary>How long it took.</summary>
/// <param name="MeasuringS">By equation (7) of Wang 2021.</param>
/// <param name="CalculatingS">As measured, from reading the files to the written program; null if nobody timed it.</param>
public readonly record struct ReportTime(double MeasuringS, double? CalculatingS);
