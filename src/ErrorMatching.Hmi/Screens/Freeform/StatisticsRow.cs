namespace ErrorMatching.Hmi;

/// <summary>What errors of a surface come to, as it is shown: lengths in µm.</summary>
/// <param name="Name">Of what.</param>
/// <param name="Count">How many points.</param>
/// <param name="Mean">Their mean, with its sign.</param>
/// <param name="Deviation">Their standard deviation.</param>
/// <param name="Profile">The profile of a surface by ISO 1101.</param>
/// <param name="Range">Largest minus smallest.</param>
/// <param name="IsChosen">True for the way of compensating that was chosen.</param>
public sealed record StatisticsRow(string Name, string Count, string Mean, string Deviation, string Profile, string Range, bool IsChosen);
