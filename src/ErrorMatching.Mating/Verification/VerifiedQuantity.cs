namespace ErrorMatching.Mating;

/// <summary>What of the counterpart is compared with the part.</summary>
public enum VerifiedQuantity
{
    /// <summary>The largest deviation along the normals, without sign, in millimetres; wanted is none.</summary>
    Deviation,

    /// <summary>The largest deviation along the first axis of the plane, without sign, in millimetres; wanted is none.</summary>
    DeviationX,

    /// <summary>The length of a line, in millimetres; wanted is the part's.</summary>
    Length,

    /// <summary>The angle inside a corner, in degrees; wanted is the part's.</summary>
    Angle,
}
