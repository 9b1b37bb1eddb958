using System.Globalization;

namespace ErrorMatching.Jobs;

/// <summary>Paths of the fields of a draft: the JSON paths of the job, and similar paths for the theoretical points, which have a file of
/// their own.</summary>
public static class DraftPaths
{
    /// <summary>Where an editor finds the schema.</summary>
    public const string Schema = "$.$schema";

    /// <summary>The job's name.</summary>
    public const string Name = "$.name";

    /// <summary>The shop's order number.</summary>
    public const string WorkOrder = "$.workOrder";

    /// <summary>The piece that has been cut and measured.</summary>
    public const string Part = "$.part";

    /// <summary>The file of the theoretical points.</summary>
    public const string Theoretical = Part + ".theoretical";

    /// <summary>The default file of the measured part.</summary>
    public const string Measured = Part + ".measured";

    /// <summary>The gauge.</summary>
    public const string Gauge = "$.gauge";

    /// <summary>The format of the gauge's files: a name, or a description as an object.</summary>
    public const string Format = Gauge + ".format";

    /// <summary>The rule or the order of the labels in the gauge's files.</summary>
    public const string GaugeLabels = Gauge + ".labels";

    /// <summary>The gauge's standard uncertainty, mm, or the list of contributions to it.</summary>
    public const string Uncertainty = Gauge + ".uncertaintyMm";

    /// <summary>The key of the value of a contribution to the uncertainty, mm.</summary>
    public const string ContributionValue = "valueMm";

    /// <summary>What the gauge's files hold: points of contact or centers of the stylus ball.</summary>
    public const string Reports = Gauge + ".reports";

    /// <summary>Diameter of the stylus ball, mm.</summary>
    public const string StylusDiameter = Gauge + ".stylusDiameterMm";

    /// <summary>The terms of the measuring time.</summary>
    public const string Measuring = Gauge + ".measuring";

    /// <summary>The kind of alignment.</summary>
    public const string AlignmentKind = Alignment + ".kind";

    /// <summary>What a best fit leaves as it is: the list of <c>x</c>, <c>y</c> and <c>rotation</c>.</summary>
    public const string Locked = Alignment + ".locked";

    /// <summary>Label of a datum's origin.</summary>
    public const string DatumOrigin = Alignment + ".origin";

    /// <summary>Label of the point that gives a datum's direction.</summary>
    public const string DatumDirection = Alignment + ".direction";

    /// <summary>Label of the point that must be measured where it is designed.</summary>
    public const string OriginPoint = OriginCheck + ".point";

    /// <summary>Its allowed distance, mm.</summary>
    public const string OriginLimit = OriginCheck + ".limitMm";

    /// <summary>The piece to be cut.</summary>
    public const string Counterpart = "$.counterpart";

    /// <summary>The counterpart's program.</summary>
    public const string Program = Counterpart + ".program";

    /// <summary>The control that it is written for.</summary>
    public const string Dialect = Counterpart + ".dialect";

    /// <summary>Diameter of the tool, mm.</summary>
    public const string ToolDiameter = Counterpart + ".toolDiameterMm";

    /// <summary>The file of an earlier measured counterpart.</summary>
    public const string CounterpartMeasured = MissingMeasured.Path;

    /// <summary>Translation of the part's frame to the program's along the first axis, mm.</summary>
    public const string TranslateX = Frame + ".translateMm[0]";

    /// <summary>Translation along the second axis, mm.</summary>
    public const string TranslateY = Frame + ".translateMm[1]";

    /// <summary>Allowed distance of a key point from the path of its blocks, mm.</summary>
    public const string Map = Counterpart + ".mapMm";

    /// <summary>How the switch for block skip stands.</summary>
    public const string BlockSkip = Counterpart + ".blockSkip";

    /// <summary>SHA-256 of the program for which the blocks were chosen.</summary>
    public const string ProgramSha256 = Counterpart + ".programSha256";

    /// <summary>How deviations are compensated.</summary>
    public const string Compensation = "$.compensation";

    /// <summary>The piece whose deviations are compensated.</summary>
    public const string From = Compensation + ".from";

    /// <summary>How points are accepted near their limits.</summary>
    public const string Decision = "$.decision";

    /// <summary>The rule that decides near limits.</summary>
    public const string Rule = Decision + ".rule";

    /// <summary>The tolerance chain.</summary>
    public const string Chain = "$.toleranceChain";

    /// <summary>The rules that tell measurements of the part from the counterpart's.</summary>
    public const string Recognition = "$.recognition";

    /// <summary>Comparisons in addition to those that every feature has.</summary>
    public const string Comparisons = "$.verify";

    /// <summary>The key of the quantity that a comparison compares.</summary>
    public const string Quantity = "quantity";

    /// <summary>Points without a feature, which only the theoretical points' file has.</summary>
    public const string OtherPoints = "$.otherPoints";

    /// <summary>The list of features.</summary>
    public const string Features = "$." + MatingDraft.FeaturesKey;

    /// <summary>The alignment of measured points.</summary>
    public const string Alignment = "$.alignment";

    /// <summary>The check of the origin.</summary>
    public const string OriginCheck = "$.originCheck";

    /// <summary>Key points that are left out.</summary>
    internal const string LeftOut = "$.without";

    /// <summary>The way from the part's frame to the program's.</summary>
    public const string Frame = Counterpart + ".frame";

    /// <summary>Values of variables that only the machine knows.</summary>
    internal const string Assumed = Counterpart + ".assume";

    /// <summary>Folders with called programs.</summary>
    internal const string Libraries = Counterpart + ".libraries";

    /// <summary>A field of an item of a list, such as <c>$.toleranceChain[0].name</c>.</summary>
    public static string Item(string list, int index, string field) =>
        string.Create(CultureInfo.InvariantCulture, $"{list}[{index}].{field}");

    /// <summary>A field of a feature, such as <c>$.features[0].blocks</c>.</summary>
    public static string Feature(int feature, string field) => Item(Features, feature, field);

    /// <summary>The label of a feature's point.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="feature">Index of the feature, from 0.</param>
    /// <param name="flank">Index of the flank, from 0.</param>
    /// <param name="point">Index of the point in it, from 0.</param>
    public static string Label(MatingDraft draft, int feature, int flank, int point)
    {
        ArgumentNullException.ThrowIfNull(draft);
        var field = Feature(feature, FeatureDraft.PointsKey);
        return draft.Features[feature].Flanks.Count > 1
            ? string.Create(CultureInfo.InvariantCulture, $"{field}[{flank}][{point}]")
            : string.Create(CultureInfo.InvariantCulture, $"{field}[{point}]");
    }

    /// <summary>The label of a point without a feature.</summary>
    public static string OtherLabel(int point) => string.Create(CultureInfo.InvariantCulture, $"{OtherPoints}[{point}]");

    /// <summary>A coordinate of the point with that label: <c>x</c>, <c>y</c> or <c>z</c>.</summary>
    public static string Coordinate(string label, string axis) => $"{label}/{axis}";

    /// <summary>The labels of all points, in the order of <see cref="MatingDraft.Points"/>.</summary>
    public static IEnumerable<string> Labels(MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(draft);
        for (var f = 0; f < draft.Features.Count; f++)
        {
            for (var k = 0; k < draft.Features[f].Flanks.Count; k++)
            {
                for (var p = 0; p < draft.Features[f].Flanks[k].Count; p++)
                {
                    yield return Label(draft, f, k, p);
                }
            }
        }

        for (var p = 0; p < draft.OtherPoints.Count; p++)
        {
            yield return OtherLabel(p);
        }
    }
}
