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
        var places = MatingDraftPlaces.Find(draft).ToLookup(p => p.Feature);
        var sought = draft.Features.Select(f => new SoughtBoundary(
            f.Name,
            places[f.Name].FirstOrDefault()?.Plane ?? default,
            places[f.Name].Count() == f.Points.Count() ? [.. places[f.Name].Select(p => (p.Label, p.At))] : [])
        {
            Kind = f.Kind,
        }).ToArray();
        return [
            .. BlockProposal.Propose(
                path,
                sought,
                DraftNumber.Value(draft[DraftPaths.ToolDiameter]),
                DraftNumber.Value(draft[DraftPaths.Map]) ?? JobCounterpart.DefaultMapMm)
            .Where(p => draft.Features[p.Feature].BlockList.Count == 0)];
    }

    /// <summary>The draft with blocks for some of its features. Lines are those of one program: if blocks are named by lines, the draft
    /// says of which, and lines that features have of another program are taken away.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="chosen">Indices of the features, with their selectors.</param>
    /// <param name="program">The program for which they were chosen.</param>
    /// <param name="isMore">True to add them to the blocks that the features have.</param>
    public static MatingDraft WithBlocks(
        MatingDraft draft, IReadOnlyList<(int Feature, IReadOnlyList<string> Blocks)> chosen, NcProgram program, bool isMore = false)
    {
        ArgumentNullException.ThrowIfNull(draft);
        ArgumentNullException.ThrowIfNull(chosen);
        ArgumentNullException.ThrowIfNull(program);
        var (sha256, stated) = (DraftProgram.Of(program.Bytes).Sha256, draft[DraftPaths.ProgramSha256]);
        var before = stated.Length == 0 || IsSame(stated, sha256) ? draft : WithoutLines(draft);

        // Nobody said whose lines those are that stay.
        var isUnknown = stated.Length == 0
            && before.Features.Index().Any(f => HasLines(f.Item) && (isMore || chosen.All(c => c.Feature != f.Index)));
        var after = chosen.Aggregate(before, (to, c) => to.WithFeature(c.Feature, f => f with
        {
            Blocks = string.Join(", ", isMore ? [.. f.BlockList, .. c.Blocks] : c.Blocks),
        }));
        return after.With(
            DraftPaths.ProgramSha256, isUnknown ? "" : after.Features.Any(HasLines) ? sha256 : IsSame(stated, sha256) ? stated : "");
    }

    /// <summary>The draft with another program. Lines of the one before would mean other blocks, and are taken away.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="program">The program.</param>
    /// <param name="name">Its name.</param>
    public static MatingDraft WithProgram(MatingDraft draft, DraftProgram program, string name)
    {
        ArgumentNullException.ThrowIfNull(draft);
        ArgumentNullException.ThrowIfNull(program);
        var stated = draft[DraftPaths.ProgramSha256];
        var isFirst = stated.Length == 0 && draft.Program is null && draft[DraftPaths.Program].Length == 0;
        var isSame = IsSame(stated.Length > 0 ? stated : draft.Program?.Sha256 ?? "", program.Sha256);
        draft = isFirst || isSame ? draft : WithoutLines(draft);
        return (draft with { Program = program }).With(DraftPaths.Program, name).With(DraftPaths.ProgramSha256, isSame ? stated : "");
    }

    private static bool IsSame(string stated, string sha256) => string.Equals(stated, sha256, StringComparison.OrdinalIgnoreCase);

    private static MatingDraft WithoutLines(MatingDraft draft) =>
        draft with { Features = [.. draft.Features.Select(f => HasLines(f) ? f with { Blocks = "" } : f)] };

    private static bool HasLines(FeatureDraft feature) => feature.BlockList.Any(IsByLine);

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
