using ErrorMatching.Measurement;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>The forms of warnings about surfaces, each named by its warning's code. The cell's records state them, too.</summary>
public static class SurfaceWarningForms
{
    /// <summary>A program that calls no tool, because the job names none. Everybody is told first.</summary>
    public static SentenceForm NoToolCall { get; } = new(
        "no-tool-call",
        "The program has no tool call, because the job names no tool (toolpath.tool): it begins with a stop and an alarm that Cycle "
            + "Start does not pass. Name the tool and its length offset in the job and write the program again before you cut.");

    /// <summary>File, line, number of the point there, and of the one before.</summary>
    public static SentenceForm OutOfOrder { get; } = new(
        "points-out-of-order",
        "{0}, line {1}: point {2} stands behind point {3}. Points are taken by their numbers; was another order measured?");

    /// <summary>File, point, its place, its error and what the points around it say in um.</summary>
    public static SentenceForm PointOff { get; } = new(
        "outlying-point-measured",
        "{0}: Point {1} (near {2}) is {3} µm off along the normal, where the points around it say {4} µm: a chip, or a touch gone wrong? "
            + "It counts in all figures. Clean the place and the stylus and measure again.");

    /// <summary>The same of the furthest of several points, and the numbers of the others.</summary>
    public static SentenceForm PointsOff { get; } = new(
        "outlying-points-measured",
        "{0}: Point {1} (near {2}) is {3} µm off along the normal, where the points around it say {4} µm; likewise off: {5}: chips, or "
            + "touches gone wrong? They count in all figures. Clean the places and the stylus and measure again.");

    /// <summary>A file and the stage after which it was measured, and the same of the first.</summary>
    public static SentenceForm OtherStages { get; } = new(
        "stages-differ",
        "{0} was measured after {1} and {2} after {3}: what they come to together says nothing of either. Evaluate them apart, or one as "
            + "--before.");

    /// <summary>Point, its difference in um, and the number of the measurement.</summary>
    public static SentenceForm RepeatOutlier { get; } = new(
        "repeat-outlier",
        "Point {0} was {1} µm off its other measurements in measurement {2}. It counts all the same: measure again if that was a chip or "
            + "a touch gone wrong.");

    /// <summary>Repeatability of the measurements, and spread of the error from place to place, in um.</summary>
    public static SentenceForm RepeatsDiffer { get; } = new(
        "repeats-differ",
        "The measurements differ among themselves by {0} µm, more than the error that they show differs from place to place ({1} µm): are "
            + "they of one piece in one clamping?");

    /// <summary>Count of points.</summary>
    public static SentenceForm StructureUnknown { get; } = new(
        "structure-unknown",
        "{0} points that are too few or all alike do not tell whether they have a structure: the error was taken as systematic.");

    /// <summary>A fit through every point.</summary>
    public static SentenceForm FollowsEachPoint { get; } = new(
        "follows-each-point",
        "What every smooth model leaves of the errors has a structure: the compensation follows each point, and so the noise of each. "
            + "Measure the piece again, or more points.");

    /// <summary>Number of points, and the stated uncertainty of one in um.</summary>
    public static SentenceForm FollowsFewPoints { get; } = new(
        "follows-each-of-few",
        "{0} points do not show what is noise; only the stated uncertainty of a point does ({1} µm), and a smooth model leaves more: the "
            + "compensation follows each point. If points repeat less well than that, state measuring.uncertaintyMm. Or measure 30 points "
            + "or more.");

    /// <summary>Mean difference of left-out points and expected uncertainty at a point, in um.</summary>
    public static SentenceForm TooFarApart { get; } = new(
        "points-too-far-apart",
        "The error changes too much from point to point for the points to hold it: where a line of points is left out, the error fitted "
            + "without it is {0} µm off in the mean, and {1} µm are expected at the points. As much may be left between them. Measure "
            + "more points: at least three for each wave.");

    /// <summary>Number of points for each wave.</summary>
    public static SentenceForm FewForWave { get; } = new(
        "few-points-for-wave",
        "The points hold {0} points for each wave of the error: with so few of them, another wave, even a shorter one, would look the "
            + "same at the points, and leave its height between them. Measure more points: at least three for each wave.");

    /// <summary>Shift in X, Y, Z in mm, turn about them in degrees, share in percent, the largest movement of a point and the one that is
    /// expected of a piece, in mm.</summary>
    public static SentenceForm CheckOrigin { get; } = new(
        "check-origin",
        "One motion of the whole piece (x {0}, y {1}, z {2} mm; turned by {3}°, {4}°, {5}° about X, Y, Z) explains {6} % of what was "
            + "measured, and moves a point off the surface by {7} mm, more than {8} mm: is the origin right? If it is, the compensation "
            + "is, too.");

    /// <summary>Probability of noise with its sign of equality, and the compensated mean in um.</summary>
    public static SentenceForm OnlyMean { get; } = new(
        "noise-but-mean",
        "No test finds a structure in the errors (neighbors, plane, quadratic, waves; p {0} of all together): what differs from the mean "
            + "looks like noise and is not mirrored. The mean of {1} µm is compensated.");

    /// <summary>Probability of noise with its sign of equality.</summary>
    public static SentenceForm OnlyNoise { get; } = new(
        "noise-only",
        "No test finds a structure in the errors (neighbors, plane, quadratic, waves; p {0} of all together): what differs from the mean "
            + "looks like noise and is not mirrored. The mean is not significant either: nothing is compensated.");

    /// <summary>Largest error between the points, its standard deviation, and that expected at the points, in um.</summary>
    public static SentenceForm WorseBetween { get; } = new(
        "worse-between-points",
        "Between the points the surface that was fitted to them leaves up to {0} µm, with a standard deviation of {1} µm; at the points "
            + "{2} µm are expected. It does not know the nominal surface between them: fit the error instead (\"of\": \"error\"), or "
            + "measure more points.");

    /// <summary>A program that exists cannot follow a surface through the compensation points.</summary>
    public static SentenceForm FollowsTheError { get; } = new(
        "fit-follows-error",
        "The job's fit.of is points, but an existing program follows the error place by place, not a surface through the compensation "
            + "points: the error was fitted by the best method instead.");

    /// <summary>All but those of lots (<see cref="LotWords"/>), which other kinds of pieces have too.</summary>
    public static IReadOnlyList<SentenceForm> All { get; } =
        [
            NoToolCall, OutOfOrder, PointOff, PointsOff, OtherStages, RepeatOutlier, RepeatsDiffer, StructureUnknown,
            FollowsEachPoint, FollowsFewPoints, TooFarApart, FewForWave, CheckOrigin, OnlyMean, OnlyNoise, WorseBetween, FollowsTheError,
        ];

    /// <summary>The warning as a statement; its sentence as words if its code has no form.</summary>
    /// <param name="warning">The warning of a report.</param>
    public static Statement StatementOf(ReportWarning warning)
    {
        ArgumentNullException.ThrowIfNull(warning);
        return All.Append(LotWords.Outlier).Append(LotWords.Moved)
            .FirstOrDefault(f => f.Name == warning.Code && f.Kinds.Count == warning.Values.Count) is { } form
            ? form.With([.. warning.Values])
            : warning.Message;
    }
}
