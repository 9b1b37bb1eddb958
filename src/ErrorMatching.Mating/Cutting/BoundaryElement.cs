namespace ErrorMatching.Mating;

/// <summary>A stretch of a pass that deviates as one: a line, a flank, an arc or a curve.</summary>
/// <param name="Pass">The pass.</param>
/// <param name="First">Position of its first motion in the path.</param>
/// <param name="Last">Position of its last motion in the path.</param>
/// <param name="Form">What its cut can follow.</param>
internal sealed record BoundaryElement(FeaturePass Pass, int First, int Last, ElementForm Form)
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

    /// <summary>Number of key points that determine its shape without a rest: more of them say something about its form.</summary>
    public int PointsOfShape => Form == ElementForm.Arc ? 3 : 2;

    /// <summary>Number of its key points that are beside it, not on a corner.</summary>
    public int OwnPoints => Pass.Feet.Count(f => !f.OnCorner && Contains(f.Motion));

    /// <summary>Length of the boundary from the start of the pass to its start, mm.</summary>
    public double FromMm => Pass.Starts[First - Pass.First];

    /// <summary>Length of the boundary from the start of the pass to its end, mm.</summary>
    public double ToMm => Pass.Starts[Last - Pass.First + 1];

    /// <summary>A place on it, from -1 at its start to 1 at its end.</summary>
    public double Relative(double along) => ((2 * along) - FromMm - ToMm) / Math.Max(ToMm - FromMm, 1e-9);

    /// <summary>True if a motion is part of it.</summary>
    public bool Contains(int motion) => motion >= First && motion <= Last;
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
