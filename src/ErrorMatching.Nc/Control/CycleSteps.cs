namespace ErrorMatching.Nc;

/// <summary>Counts the holes and pecks of one program.</summary>
internal sealed class CycleSteps
{
    /// <summary>Maximum number that is followed: a block of a few bytes can request any number.</summary>
    public const int Most = 100_000;

    public double Count { get; set; }
}
