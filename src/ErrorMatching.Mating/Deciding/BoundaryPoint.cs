using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A key point on the counterpart's boundary, in the part's frame: where the program puts the boundary now, and where it should
/// be.</summary>
/// <param name="Label">Name of the key point.</param>
/// <param name="Present">Feed-forward: the theoretical point, because the program is nominal, or where the program cuts instead, if the
/// job wants that corrected. Feedback: the measured point of the counterpart that the program cut.</param>
/// <param name="Wanted">The measured point of the part, aligned, less the gap that the job wants.</param>
/// <param name="Normal">Unit normal of the boundary at the key point, from the counterpart's material to its tool.</param>
public sealed record BoundaryPoint(string Label, Point2 Present, Point2 Wanted, Vector2 Normal)
{
    /// <summary>Required displacement of the boundary: actual - theoretical in feed-forward, part - counterpart in feedback (method:
    /// target = nominal + feedforward - feedback).</summary>
    public Vector2 Displacement => Wanted - Present;

    /// <summary>The gap that the job wants there: how far <see cref="Wanted"/> is behind the measured point, against the normal,
    /// mm.</summary>
    public double GapMm { get; init; }

    /// <summary>What the program does differently there from the theoretical outline, and the job wants corrected: how far
    /// <see cref="Present"/> is beyond the theoretical point, along the normal, mm.</summary>
    public double BaseMm { get; init; }

    /// <summary>From the theoretical point to the place that fits the part with the wanted gap.</summary>
    internal Vector2 FromTheoretical => Displacement + (Normal * BaseMm);

    /// <summary>What was measured: the deviation along the normal, whatever gap is wanted and whatever the program does, mm.</summary>
    internal double MeasuredMm => NormalMm + BaseMm + GapMm;

    /// <summary>What is not followed, because the part may be as designed there and only its measurement off: the part's deviation along
    /// the normal, mm. 0 for a single counterpart, of which the whole displacement is judged.</summary>
    public double IgnoredMm { get; init; }

    /// <summary>Signed length of what may be followed along the normal.</summary>
    public double FollowedMm => NormalMm - IgnoredMm;

    /// <summary>Signed length of the displacement along the normal; positive if the counterpart must keep more material.</summary>
    public double NormalMm => Displacement.Dot(Normal);
}
