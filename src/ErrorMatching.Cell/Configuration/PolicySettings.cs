namespace ErrorMatching.Cell;

/// <summary>Who approves what.</summary>
/// <param name="Automatic">True if what stays within the limits is approved by the cell itself; else a person approves each correction.</param>
/// <param name="LimitMm">The largest displacement of one correction in mm: larger ones are refused. Null: the job's own limit alone.</param>
/// <param name="SumLimitMm">The largest sum of displacements since the original program in mm. Null: no other than that of one correction.</param>
/// <param name="Gain">Takes the place of the job's gain; null leaves it.</param>
public sealed record PolicySettings(bool Automatic, double? LimitMm, double? SumLimitMm, double? Gain);
