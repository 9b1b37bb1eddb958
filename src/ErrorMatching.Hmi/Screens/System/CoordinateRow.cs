using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A theoretical point in the system set-up.</summary>
/// <param name="Feature">Name of its feature; empty for a point of none.</param>
/// <param name="Label">Its label.</param>
/// <param name="X">Its first coordinate.</param>
/// <param name="Y">Its second coordinate.</param>
/// <param name="Z">Its third coordinate, where points have one; else null.</param>
public sealed record CoordinateRow(string Feature, TextField Label, TextField X, TextField Y, TextField? Z)
{
    /// <summary>True if points have a third coordinate.</summary>
    public bool HasZ => Z is not null;

    /// <summary>Its fields.</summary>
    internal IEnumerable<EditField> Fields => Z is null ? [Label, X, Y] : [Label, X, Y, Z];

    /// <summary>The rows of a draft, in the order of its points.</summary>
    public static IEnumerable<CoordinateRow> Of(JobEditing editing)
    {
        var draft = editing.Draft;
        var hasZ = draft.Points.Any(p => p.Z.Length > 0) || draft.Features.Any(f => f.Plane != "XY");
        for (var f = 0; f < draft.Features.Count; f++)
        {
            for (var k = 0; k < draft.Features[f].Flanks.Count; k++)
            {
                for (var p = 0; p < draft.Features[f].Flanks[k].Count; p++)
                {
                    var (feature, flank, point) = (f, k, p);
                    yield return Row(
                        editing,
                        draft.Features[f].Name,
                        DraftPaths.Label(draft, f, k, p),
                        hasZ,
                        d => d.Features[feature].Flanks[flank][point],
                        (d, now) => d.WithFeature(feature, x => x with { Flanks = x.Flanks.Replaced(flank, x.Flanks[flank].Replaced(point, now)) }));
                }
            }
        }

        for (var p = 0; p < draft.OtherPoints.Count; p++)
        {
            var point = p;
            yield return Row(editing, "", DraftPaths.OtherLabel(p), hasZ, d => d.OtherPoints[point], (d, now) => d with { OtherPoints = d.OtherPoints.Replaced(point, now) });
        }
    }

    private static CoordinateRow Row(JobEditing editing, string feature, string path, bool hasZ, Func<MatingDraft, PointDraft> get, Func<MatingDraft, PointDraft, MatingDraft> set) => new(
        feature,
        new(editing, path, "System.Label", d => get(d).Label, (d, t) => set(d, get(d) with { Label = t })),
        new(editing, DraftPaths.Coordinate(path, "x"), "System.X", d => get(d).X, (d, t) => set(d, get(d) with { X = t })),
        new(editing, DraftPaths.Coordinate(path, "y"), "System.Y", d => get(d).Y, (d, t) => set(d, get(d) with { Y = t })),
        hasZ ? new(editing, DraftPaths.Coordinate(path, "z"), "System.Z", d => get(d).Z, (d, t) => set(d, get(d) with { Z = t })) : null);
}
