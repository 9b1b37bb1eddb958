using System.Globalization;
using ErrorMatching.Mating;
using ErrorMatching.Nc;

namespace ErrorMatching.Jobs;

/// <summary>Valid but probably unintended input, queried at its field; it can still be saved.</summary>
internal static class DraftDoubts
{
    /// <summary>Blocks at an end of a feature's cut that turn away beyond the last key point, with no cut after them: the lead-in or
    /// lead-out.</summary>
    /// <param name="match">The draft's match.</param>
    public static IEnumerable<DraftProblem> OfBlocks(MatchResult match)
    {
        var (path, program) = (match.Before, match.Before.Program);
        for (var i = 0; i < match.Maps.Count; i++)
        {
            var ways = match.Maps[i].Passes.SelectMany(p => Ways(path, p))
                .Select(m => path.Motions[m].Block)
                .Distinct()
                .Order()
                .Select(b => program.NameOf(program[b]))
                .ToArray();
            if (ways.Length > 0)
            {
                var found = string.Join(", ", ways);
                yield return new(
                    DraftPaths.Feature(i, FeatureDraft.BlocksKey),
                    "blocks-lead",
                    found,
                    $"{found}: no key point of {match.Maps[i].Feature.Name} lies there. Is it the lead-in or lead-out?");
            }
        }
    }

    /// <summary>Key points on rounded corners, whose measured deviation says something about both elements together. A match that
    /// compensates warns of the same points.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="match">Its match.</param>
    public static IEnumerable<DraftProblem> OfCorners(MatingDraft draft, MatchResult match)
    {
        var fields = DraftPaths.Labels(draft)
            .Zip(draft.Points)
            .DistinctBy(p => p.Second.Label.Trim())
            .ToDictionary(p => p.Second.Label.Trim(), p => p.First, StringComparer.Ordinal);
        foreach (var foot in match.OnCorners.Where(f => fields.ContainsKey(f.Label)))
        {
            // Round up: at a smaller distance the question would come again.
            var mm = string.Create(CultureInfo.InvariantCulture, $"{Math.Ceiling(foot.BeyondEndMm * 10) / 10:0.0} mm");
            yield return new(
                fields[foot.Label], WarningForms.PointOnCorner.Name, foot.Label,
                $"Point {foot.Label} lies on a rounded corner at an end of its blocks, where the boundary follows both elements: it "
                    + $"says something about both elements together, so each is less certain. Choose it at least {mm} further from the "
                    + "corner.")
            {
                Amount = mm,
            };
        }
    }

    // The motions of a pass from the first bend beyond its key points, if the pass is at the end of the cut.
    private static IEnumerable<int> Ways(NcPath path, FeaturePass pass)
    {
        var moving = Enumerable.Range(pass.First, pass.Last - pass.First + 1).Where(m => path.Motions[m].MovesInPlane).ToArray();
        var (first, last) = (Array.IndexOf(moving, pass.Feet.Min(f => f.Motion)), Array.IndexOf(moving, pass.Feet.Max(f => f.Motion)));
        var into = Cuts(path, pass.First - 1)
            ? []
            : Enumerable.Range(0, first).Where(m => Bends(path, moving[m], moving[m + 1])).TakeLast(1).SelectMany(m => moving[..(m + 1)]);
        var outOf = Cuts(path, pass.Last + 1)
            ? []
            : Enumerable.Range(last + 1, moving.Length - last - 1)
                .Where(m => Bends(path, moving[m - 1], moving[m]))
                .Take(1)
                .SelectMany(m => moving[m..]);
        return into.Concat(outOf);
    }

    private static bool Cuts(NcPath path, int motion) =>
        motion >= 0 && motion < path.Motions.Length && path.Motions[motion] is { IsCut: true, MovesInPlane: true };

    private static bool Bends(NcPath path, int before, int behind) =>
        path.Motions[before].TangentAt(1).Dot(path.Motions[behind].TangentAt(0)) < BoundarySearch.BendCosine;
}
