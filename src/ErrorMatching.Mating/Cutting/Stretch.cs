namespace ErrorMatching.Mating;

/// <summary>A stretch of a boundary that deviates as one.</summary>
/// <param name="Form">What its cut can follow.</param>
internal abstract record Stretch(ElementForm Form)
{
    /// <summary>Degree of the polynomial that its course must be; null for a Gaussian process. Only for
    /// <see cref="ElementForm.Free"/>.</summary>
    public int? Degree { get; init; }

    /// <summary>Weight against overfitting of that polynomial.</summary>
    public double Ridge { get; init; }

    /// <summary>Angle that the arc turns, radians; 0 unless <see cref="ElementForm.Arc"/>.</summary>
    public double Sweep { get; init; }

    /// <summary>Standard deviation of its form error, as the job states it, mm; null if its points are to tell it.</summary>
    public double? FormMm { get; init; }

    /// <summary>Length of the boundary at its start, mm.</summary>
    public abstract double FromMm { get; }

    /// <summary>Length of the boundary at its end, mm.</summary>
    public abstract double ToMm { get; }

    /// <summary>A place on it, from -1 at its start to 1 at its end.</summary>
    public double Relative(double along) => ((2 * along) - FromMm - ToMm) / Math.Max(ToMm - FromMm, 1e-9);
}

/// <summary>What the cut of an element can follow.</summary>
internal enum ElementForm
{
    /// <summary>One line: a shift and a tilt.</summary>
    Straight,

    /// <summary>One circle: a shift of its center and a growth.</summary>
    Arc,

    /// <summary>Any smooth course.</summary>
    Free,
}
