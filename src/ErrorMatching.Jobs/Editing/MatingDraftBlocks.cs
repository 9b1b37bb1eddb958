using ErrorMatching.Mating;
using ErrorMatching.Nc;

namespace ErrorMatching.Jobs;

/// <summary>Finds the blocks that cut the features of a draft by their key points (<see cref="BoundarySearch"/>):
/// a proposal for a person to look at.</summary>
public static class MatingDraftBlocks
{
    /// <summary>The blocks of the features that have none yet. None are found for a feature of which a point has no coordinates, that no
    /// cut follows, or whose blocks have no name that tells them from others.</summary>
    /// <param name="draft">The draft; it may be wrong elsewhere.</param>
    /// <param name="path">Its program, interpreted.</param>
    public static IReadOnlyList<ProposedBlocks> Propose(MatingDraft draft, NcPath path)
    {
        ArgumentNullException.ThrowIfNull(draft);
        ArgumentNullException.ThrowIfNull(path);

        // What has its blocks is sought as well: they are nobody else's.
        var places = MatingDraftPlaces.Of(draft).ToLookup(p => p.Feature);
        var sought = draft.Features.Select(f => new SoughtBoundary(
            f.Name,
            places[f.Name].FirstOrDefault()?.Plane ?? default,
            places[f.Name].Count() == f.Points.Count() ? [.. places[f.Name].Select(p => (p.Label, p.At))] : [])
        {
            Kind = f.Kind,
        }).ToArray();
        return [
            .. BlockProposal.Of(
                path,
                sought,
                DraftNumber.Value(draft.Counterpart.ToolDiameter),
                DraftNumber.Value(draft.Counterpart.Map) ?? JobCounterpart.DefaultMapMm)
            .Where(p => draft.Features[p.Feature].BlockList.Count == 0)];
    }
}
