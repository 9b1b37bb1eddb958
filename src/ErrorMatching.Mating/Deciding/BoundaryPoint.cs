using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A key point on the counterpart's boundary, in the part's frame: where the program puts the boundary now, and where it should
/// be.</summary>
/// <remarks>
/// <para>The quantities at a key point have one name from here to the estimate (<c>RunPoint</c>). Lengths are along the normal, positive
/// toward the tool: there the counterpart must keep more material.</para>
/// <list type="table">
/// <listheader><term>name</term><description>from where to where</description></listheader>
/// <item><term>Displacement</term><description>from Present to Wanted, a vector</description></item>
/// <item><term>DecidedMm</term><description>the same along the normal: what the limits are for</description></item>
/// <item><term>GapMm</term><description>from Wanted to the measured point of the part</description></item>
/// <item><term>BaseMm</term><description>from the theoretical point to where the program cuts. Here it is 0 unless the job wants it
/// corrected; in <c>RunPoint</c>, whose passes may differ, it is always told, with CorrectedBaseMm, what is corrected of it</description>
/// </item>
/// <item><term>FromTheoretical</term><description>from the theoretical point (feedback: Present) to Wanted, a vector</description></item>
/// <item><term>MeasuredMm</term><description>from the theoretical point to the measured point of the part; a report's
/// <c>normalMm</c></description></item>
/// <item><term>IgnoredMm</term><description>what of DecidedMm is not followed</description></item>
/// <item><term>FollowedMm</term><description>DecidedMm - IgnoredMm</description></item>
/// <item><term>Correction</term><description>Share of what is followed, a vector: from Present to where the corrected program is to have
/// the boundary (<see cref="PointDecision"/>)</description></item>
/// <item><term>Target</term><description>from the theoretical point to the same place, less what is kept of BaseMm, a vector
/// (<c>RunPoint</c>)</description></item>
/// </list>
/// <para>Mating errors are counterpart - part, so they have the other sign: positive where too much material stands. They are
/// <c>PredictedError.BeforeMm</c> and <c>AfterMm</c>, from Wanted to where the program before or after cuts,
/// and KeptMm, what no correction changes of them (<c>ComparedPlace</c>). BaseMm is the same number as an error.</para>
/// </remarks>
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

    /// <summary>Signed length of the displacement along the normal; positive if the counterpart must keep more material.</summary>
    public double DecidedMm => Displacement.Dot(Normal);

    /// <summary>The gap that the job wants there: how far <see cref="Wanted"/> is behind the measured point, against the normal,
    /// mm.</summary>
    public double GapMm { get; init; }

    /// <summary>What the program does differently there from the theoretical outline, and the job wants corrected: how far
    /// <see cref="Present"/> is beyond the theoretical point, along the normal, mm.</summary>
    public double BaseMm { get; init; }

    /// <summary>From the theoretical point to the place that fits the part with the wanted gap.</summary>
    internal Vector2 FromTheoretical => Displacement + (Normal * BaseMm);

    /// <summary>What was measured: the deviation along the normal, whatever gap is wanted and whatever the program does, mm.</summary>
    internal double MeasuredMm => DecidedMm + BaseMm + GapMm;

    /// <summary>What is not followed, because the part may be as designed there and only its measurement off: the part's deviation along
    /// the normal, mm. 0 for a single counterpart, of which the whole displacement is judged.</summary>
    public double IgnoredMm { get; init; }

    /// <summary>Signed length of what may be followed along the normal.</summary>
    public double FollowedMm => DecidedMm - IgnoredMm;
}
