using ErrorMatching.Measurement;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The forms of report warnings, each named by its warning's code. The cell's records state them, too.</summary>
public static class WarningForms
{
    /// <summary>Feature, count of key points, length and recommended spacing in mm.</summary>
    public static SentenceForm SparsePoints { get; } = new(
        "sparse-points", "{0} has {1} key points on {2} mm; one per {3} mm is recommended.");

    /// <summary>Feature.</summary>
    public static SentenceForm FoldedCurve { get; } = new(
        "folded-curve", "{0} turns back over its chord, so no polynomial describes it; its compensation does not need one.");

    /// <summary>Point and block.</summary>
    public static SentenceForm PointOnCorner { get; } = new(
        "point-on-corner",
        "Point {0} lies on a rounded corner at an end of {1}: it says something about both elements together, so each of them is less "
            + "certain. For the next parts, choose a key point further from the corner in the job.");

    /// <summary>Point, the distance in mm at which the tool passes it, and block.</summary>
    public static SentenceForm PointNotReached { get; } = new(
        "point-not-reached",
        "Under cutter compensation the tool passes the point {0} at {1} mm: it leaves a round of its own radius in the inside corner of "
            + "{2}. What is corrected there cannot be cut. For the next parts, choose a key point that the tool touches.");

    /// <summary>The blocks before and after the corner, radius, overlap and diameter of the largest tool, mm.</summary>
    public static SentenceForm InsideCorner { get; } = new(
        "inside-corner",
        "In the inside corner of {0} and {1} the tool leaves a round of {2} mm. A part with a sharp corner would overlap there by {3} mm, "
            + "and no correction changes that. Round the part's corner by as much, relieve the corner in the program, or cut it with a "
            + "tool of at most {4} mm diameter.");

    /// <summary>Feature, and the largest difference in mm, positive where too much material stands.</summary>
    public static SentenceForm BaseDiffers { get; } = new(
        "base-differs",
        "The program cuts {0} elsewhere than the theoretical points are: {1} mm (positive: too much "
            + "material). That stays, and is counted in what is left over. If the program is wrong, or already leaves the gap that "
            + "you write as gapMm, write \"base\": \"correct\" at the feature.");

    /// <summary>Block, the radius that the program gives, and that of the job's tool, mm.</summary>
    public static SentenceForm ToolRadiusDiffers { get; } = new(
        "tool-radius-differs",
        "For {0} the program itself gives a tool radius of {1} mm, and the tool of the job has {2} mm: under cutter compensation the cut "
            + "lies beside the programmed contour by the difference. Correct the job's toolDiameterMm, or the program.");

    /// <summary>Lines as the job names them, and SHA-256 of the program.</summary>
    public static SentenceForm LinesWithoutHash { get; } = new(
        "lines-without-hash",
        "The job names blocks by lines ({0}) and does not state their program: once a line is inserted or removed before them, other "
            + "blocks are meant. If they are right, write \"programSha256\": \"{1}\" under counterpart: then an edited program is "
            + "refused.");

    /// <summary>Kind of alignment, and its residual in mm.</summary>
    public static SentenceForm Aligned { get; } = new(
        "aligned",
        "The part was aligned ({0}) before it was compared: what the alignment took away is not compensated. {1} mm (root mean square) "
            + "are left.");

    /// <summary>The file of the measured counterpart, as the job names it.</summary>
    public static SentenceForm MeasuredNotThere { get; } = new(
        "measured-not-there",
        "The measured counterpart \"{0}\" is not there; expected the file of the one that was cut without compensation, or no key "
            + "counterpart.measured: as it is, no counterpart can be compared in a cell.");

    /// <summary>Feature, the gauge's expanded uncertainty and the width of the limits in mm, and their ratio in percent.</summary>
    public static SentenceForm GaugeCoarse { get; } = new(
        "gauge-coarse",
        "The gauge is coarse for {0}: its uncertainty (k = 2) is {1} mm, and the limits are {2} mm apart: {3} %. At most a third is "
            + "usual. A point near a limit may be decided wrongly: use a better gauge or wider limits.");

    /// <summary>How many times the stated uncertainty the points scatter, and the ends of its 95 % interval.</summary>
    public static SentenceForm UncertaintyContradicted { get; } = new(
        "stated-uncertainty",
        "The points scatter by {0} times the uncertainty that the job states ({1} to {2}, 95 %): the intervals and the risk are wrong by "
            + "as much. Is uncertaintyMm right, or is the surface rough?");

    /// <summary>All of them.</summary>
    public static IReadOnlyList<SentenceForm> All { get; } =
        [
            SparsePoints, FoldedCurve, PointOnCorner, PointNotReached, InsideCorner, BaseDiffers, ToolRadiusDiffers, LinesWithoutHash,
            Aligned, MeasuredNotThere, GaugeCoarse, UncertaintyContradicted, LotWords.Outlier, LotWords.Moved,
        ];

    /// <summary>The warning as a statement; its sentence as words if its code has no form.</summary>
    /// <param name="warning">The warning of a report.</param>
    public static Statement StatementOf(ReportWarning warning)
    {
        ArgumentNullException.ThrowIfNull(warning);
        return All.FirstOrDefault(f => f.Name == warning.Code && f.Kinds.Count == warning.Values.Count) is { } form
            ? form.With([.. warning.Values])
            : warning.Message;
    }

    internal static ReportWarning Warning(SentenceForm form, params string[] values) => new(form.Name, form.With(values).Sentence, values);
}
