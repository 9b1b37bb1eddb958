namespace ErrorMatching.Freeform;

/// <summary>How the measured error is compensated.</summary>
/// <param name="Mirror">True: each place is moved by its own error, mirrored. False: the whole surface is moved by the mean error, like a
/// modified tool radius.</param>
/// <param name="Gain">Compensated share of the error; 1 is the pure mirror.</param>
/// <param name="LimitMm">Largest plausible compensation. The job stops beyond it.</param>
public sealed record JobMirror(bool Mirror, double Gain, double LimitMm)
{
    /// <summary>The pure mirror, limited to 0.2 mm.</summary>
    public static JobMirror Default { get; } = new(true, 1, 0.2);
}
