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

    /// <summary>The draft with blocks for some of its features. Lines are those of one program: if blocks are named by lines, the draft
    /// says of which, and lines that other features have of another program are taken away.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="chosen">Indices of the features, with their selectors.</param>
    /// <param name="program">The program for which they were chosen.</param>
    public static MatingDraft WithBlocks(MatingDraft draft, IReadOnlyList<(int Feature, string Blocks)> chosen, NcProgram program)
    {
        ArgumentNullException.ThrowIfNull(draft);
        ArgumentNullException.ThrowIfNull(chosen);
        ArgumentNullException.ThrowIfNull(program);
        var sha256 = DraftProgram.Of(program.Bytes).Sha256;
        var stated = draft.Counterpart.ProgramSha256;
        draft = chosen.Aggregate(
            stated.Length == 0 || IsSame(stated, sha256) ? draft : WithoutLines(draft),
            (to, c) => to.WithFeature(c.Feature, f => f with { Blocks = c.Blocks }));

        // Nobody said whose lines the others are.
        var isKnown = stated.Length > 0 || draft.Features.Index().All(f => !HasLines(f.Item) || chosen.Any(c => c.Feature == f.Index));
        return !isKnown || !draft.Features.Any(HasLines) ? draft
            : draft with { Counterpart = draft.Counterpart with { ProgramSha256 = sha256 } };
    }

    /// <summary>The draft with another program. Lines of the one before would mean other blocks, and are taken away.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="program">The program.</param>
    /// <param name="name">Its name.</param>
    public static MatingDraft WithProgram(MatingDraft draft, DraftProgram program, string name)
    {
        ArgumentNullException.ThrowIfNull(draft);
        ArgumentNullException.ThrowIfNull(program);
        var isSame = IsSame(draft.Counterpart.ProgramSha256, program.Sha256);
        draft = isSame ? draft : WithoutLines(draft);
        return draft with
        {
            Program = program,
            Counterpart = draft.Counterpart with { Program = name, ProgramSha256 = isSame ? program.Sha256 : "" },
        };
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
