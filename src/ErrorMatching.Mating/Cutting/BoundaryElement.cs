namespace ErrorMatching.Mating;

/// <summary>A stretch of a pass that deviates as one: a line, a flank, an arc or a curve.</summary>
/// <param name="Pass">The pass.</param>
/// <param name="First">Position of its first motion in the path.</param>
/// <param name="Last">Position of its last motion in the path.</param>
/// <param name="Form">What its cut can follow.</param>
internal sealed record BoundaryElement(FeaturePass Pass, int First, int Last, ElementForm Form) : Stretch(Form)
{
    /// <summary>Number of key points that determine its shape without a rest: more of them say something about its form.</summary>
    public int PointsOfShape => Form == ElementForm.Arc ? 3 : 2;

    /// <summary>Number of its key points that are beside it, not on a corner.</summary>
    public int OwnPoints => Pass.Feet.Count(f => !f.OnCorner && Contains(f.Motion));

    /// <summary>Length of the boundary from the start of the pass to its start, mm.</summary>
    public override double FromMm => Pass.Starts[First - Pass.First];

    /// <summary>Length of the boundary from the start of the pass to its end, mm.</summary>
    public override double ToMm => Pass.Starts[Last - Pass.First + 1];

    /// <summary>True if a motion is part of it.</summary>
    public bool Contains(int motion) => motion >= First && motion <= Last;
}
