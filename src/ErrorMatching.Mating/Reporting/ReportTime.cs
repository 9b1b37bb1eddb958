namespace ErrorMatching.Mating;

/// <summary>Measuring and calculating times.</summary>
/// <param name="MeasuringS">Measuring time by equation (7) of Wang 2021.</param>
/// <param name="CalculatingS">Measured time from reading the files to the written program; null if it was not timed.</param>
public readonly record struct ReportTime(double MeasuringS, double? CalculatingS);
