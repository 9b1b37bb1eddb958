using System.Globalization;

namespace ErrorMatching.Jobs;

/// <summary>Paths of the fields of a draft: the JSON paths of the job, and similar paths for the theoretical points, which have a file of
/// their own.</summary>
public static class DraftPaths
{
    /// <summary>A field of a feature, such as <c>$.features[0].blocks</c>.</summary>
    public static string Feature(int feature, string field) =>
        string.Create(CultureInfo.InvariantCulture, $"$.features[{feature}].{field}");

    /// <summary>The label of a feature's point.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="feature">Index of the feature, from 0.</param>
    /// <param name="flank">Index of the flank, from 0.</param>
    /// <param name="point">Index of the point in it, from 0.</param>
    public static string Label(MatingDraft draft, int feature, int flank, int point)
    {
        ArgumentNullException.ThrowIfNull(draft);
        var field = Feature(feature, "points");
        return draft.Features[feature].Flanks.Count > 1
            ? string.Create(CultureInfo.InvariantCulture, $"{field}[{flank}][{point}]")
            : string.Create(CultureInfo.InvariantCulture, $"{field}[{point}]");
    }

    /// <summary>The label of a point without a feature.</summary>
    public static string OtherLabel(int point) => string.Create(CultureInfo.InvariantCulture, $"$.otherPoints[{point}]");

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
