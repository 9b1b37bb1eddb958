namespace ErrorMatching.Cell;

/// <summary>Who approves what.</summary>
/// <param name="Automatic">True if the cell itself approves corrections within the limits; otherwise a person approves each one.</param>
/// <param name="LimitMm">The largest displacement of one correction in mm; larger ones are refused. Null: only the job's own limit
/// applies.</param>
/// <param name="SumLimitMm">The largest sum of displacements since the original program in mm. Null: the limit for one correction
/// applies.</param>
/// <param name="Gain">Replaces the job's gain; null keeps the job's.</param>
public sealed record PolicySettings(bool Automatic, double? LimitMm, double? SumLimitMm, double? Gain);
