namespace ErrorMatching.Hmi;

/// <summary>Statistics of surface errors; lengths in µm.</summary>
/// <param name="Name">Name of the errors.</param>
/// <param name="Count">Number of points.</param>
/// <param name="Mean">Mean with its sign.</param>
/// <param name="Deviation">Standard deviation.</param>
/// <param name="Profile">Profile of a surface by ISO 1101.</param>
/// <param name="Range">Largest minus smallest.</param>
/// <param name="IsChosen">True for the chosen way of compensation.</param>
internal sealed record StatisticsRow(string Name, string Count, string Mean, string Deviation, string Profile, string Range, bool IsChosen);
