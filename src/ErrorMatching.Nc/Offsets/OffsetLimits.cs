namespace ErrorMatching.Nc;

/// <summary>How far corrections by offsets may go.</summary>
/// <param name="StepMm">Largest change of one offset by one program, mm.</param>
/// <param name="TotalMm">Largest correction of one offset in all, mm.</param>
/// <param name="StepDegrees">Largest change of a rotation by one program, degrees.</param>
/// <param name="TotalDegrees">Largest rotation in all, degrees.</param>
public sealed record OffsetLimits(decimal StepMm, decimal TotalMm, decimal StepDegrees, decimal TotalDegrees)
{
    /// <summary>0.05 mm and 0.02 degrees in a step, four times that in all.</summary>
    public static OffsetLimits Default { get; } = new(0.05m, 0.2m, 0.02m, 0.08m);
}
