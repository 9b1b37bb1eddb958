namespace ErrorMatching.Freeform;

/// <summary>What is made of the measured error.</summary>
/// <param name="Mirror">True: each place is moved by its own error, mirrored. False: the whole surface by the mean error, as if the tool's radius were modified.</param>
/// <param name="Gain">Share of the error that is compensated; 1 is the pure mirror.</param>
/// <param name="LimitMm">Largest compensation that is plausible; beyond it the job stops.</param>
public sealed record JobMirror(bool Mirror, double Gain, double LimitMm)
{
    /// <summary>The pure mirror, at most 0.2 mm.</summary>
    public static JobMirror Default { get; } = new(true, 1, 0.2);
}
