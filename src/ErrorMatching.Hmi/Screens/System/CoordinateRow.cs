using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A theoretical point in the system setup.</summary>
/// <param name="Feature">Name of its feature; empty if it has none.</param>
/// <param name="Label">Its label.</param>
/// <param name="X">Its first coordinate.</param>
/// <param name="Y">Its second coordinate.</param>
/// <param name="Z">Its third coordinate, or null.</param>
internal sealed record CoordinateRow(string Feature, TextField Label, TextField X, TextField Y, TextField? Z)
{
    public bool HasZ => Z is not null;

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
                        (d, now) => d.WithFeature(
                            feature, x => x with { Flanks = x.Flanks.Replaced(flank, x.Flanks[flank].Replaced(point, now)) }));
                }
            }
        }

        for (var p = 0; p < draft.OtherPoints.Count; p++)
        {
            var point = p;
            yield return Row(
                editing,
                "",
                DraftPaths.OtherLabel(p),
                hasZ,
                d => d.OtherPoints[point],
                (d, now) => d with { OtherPoints = d.OtherPoints.Replaced(point, now) });
        }
    }

    private static CoordinateRow Row(
        JobEditing editing,
        string feature,
        string path,
        bool hasZ,
        Func<MatingDraft, PointDraft> get,
        Func<MatingDraft, PointDraft, MatingDraft> set)
    {
        var label = new TextField(editing, path, "System.Label", d => get(d).Label, (d, t) => set(d, get(d) with { Label = t }))
        {
            Row = () => feature
        };
        return new(
            feature,
            label,
            Coordinate("x", "System.X", p => p.X, (p, t) => p with { X = t }),
            Coordinate("y", "System.Y", p => p.Y, (p, t) => p with { Y = t }),
            hasZ ? Coordinate("z", "System.Z", p => p.Z, (p, t) => p with { Z = t }) : null);

        TextField Coordinate(string axis, string name, Func<PointDraft, string> of, Func<PointDraft, string, PointDraft> with) =>
            new(editing, DraftPaths.Coordinate(path, axis), name, d => of(get(d)), (d, t) => set(d, with(get(d), t)))
            {
                Row = () => $"{feature} {label.Text}".Trim(),
            };
    }
}
