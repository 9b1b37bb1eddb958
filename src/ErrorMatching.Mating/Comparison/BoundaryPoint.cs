using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A key point on the counterpart's boundary: where the program puts the boundary at present, and where the part wants it.
/// All in the part's frame.</summary>
/// <param name="Label">Name of the key point.</param>
/// <param name="Present">
/// Feed-forward: the theoretical point, since the program is the nominal one. Feedback:
/// the measured point of the counterpart that the program cut.
/// </param>
/// <param name="Wanted">The measured point of the part, aligned.</param>
/// <param name="Normal">Unit normal of the boundary at the key point, from the counterpart's material to its tool.</param>
public sealed record BoundaryPoint(string Label, Point2 Present, Point2 Wanted, Vector2 Normal)
{
    /// <summary>By what the boundary has to move: feed-forward actual - theoretical, feedback part - counterpart (method:
    /// target = nominal + feedforward - feedback).</summary>
    public Vector2 Displacement => Wanted - Present;

    /// <summary>Signed length of the displacement along the normal: positive where the counterpart must keep more material.</summary>
    public double NormalMm => Displacement.Dot(Normal);
}
