using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Finds the blocks that cut a draft's features by their key points (<see cref="BoundarySearch"/>). The result is a proposal for
/// the user to check.</summary>
public static class MatingDraftBlocks
{
    /// <summary>The blocks of features that have none yet. None are found if a point lacks coordinates, or no cut follows the
    /// feature.</summary>
    /// <param name="draft">The draft; it may have other problems.</param>
    /// <param name="path">Its program, interpreted.</param>
    public static IReadOnlyList<ProposedBlocks> Propose(MatingDraft draft, NcPath path)
    {
        ArgumentNullException.ThrowIfNull(draft);
        ArgumentNullException.ThrowIfNull(path);

        // Search for features with blocks too, so that their blocks are not proposed for others.
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

    /// <summary>The draft that says for which program its blocks were chosen, if they are named by lines: in an edited program, other
    /// blocks would be meant.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="program">The program for which they were chosen.</param>
    public static MatingDraft Pinned(MatingDraft draft, NcProgram program)
    {
        ArgumentNullException.ThrowIfNull(draft);
        ArgumentNullException.ThrowIfNull(program);
        return !draft.Features.Any(f => f.BlockList.Any(IsByLine)) ? draft : draft with
        {
            Counterpart = draft.Counterpart with { ProgramSha256 = DraftProgram.Of(program.Bytes).Sha256 },
        };
    }

    // As a user types it, a selector may be none.
    private static bool IsByLine(string selector)
    {
        try
        {
            return BlockSelector.Parse(selector).IsByLine;
        }
        catch (InputException)
        {
            return false;
        }
    }
}
