using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Finds problems with the program and blocks of an incomplete draft: no cutting motion, missing blocks, blocks of two
/// features.</summary>
internal static class DraftBlocks
{
    // The code of the mapping, which reports the same once everything else is right.
    private const string BlocksOverlap = "blocks-overlap";

    private const string BlocksBackwards = "blocks-backwards";

    /// <summary>Checks the blocks of each feature that names some.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="file">The job's file, for relative paths.</param>
    /// <param name="bytes">The program.</param>
    public static IEnumerable<DraftProblem> Check(MatingDraft draft, string file, ReadOnlyMemory<byte> bytes)
    {
        NcDialect dialect;
        NcProgram program;
        try
        {
            dialect = MatingDraftCheck.DialectOf(draft, file);
            program = NcProgram.Read(bytes, dialect.Syntax);
        }
        catch (InputException)
        {
            // The job's reader reports an unknown control.
            yield break;
        }

        if (!NcInterpreter.Run(program, dialect).Motions.Any(m => m is { IsCut: true, MovesInPlane: true }))
        {
            yield return new(
                DraftPaths.Program,
                "no-cutting-motion",
                "",
                $"{Path.GetFileName(draft[DraftPaths.Program])} has no motion that cuts in its plane; expected the NC program of the "
                    + $"counterpart.");
            yield break;
        }

        var owners = new Dictionary<int, string>();
        for (var feature = 0; feature < draft.Features.Count; feature++)
        {
            if (Find(program, draft.Features[feature]) is not { } found)
            {
                continue;
            }

            var field = DraftPaths.Feature(feature, FeatureDraft.BlocksKey);
            if (!found.IsUsable)
            {
                yield return draft.Features[feature].BlockList.Select(b => Turned(
                    program, b)).FirstOrDefault(b => b is not null) is { } turned
                    ? new(field, BlocksBackwards, turned, found.Refusal.Message)
                    : new(
                        field,
                        found.Refusal.Code,
                        found.Refusal.Place.Block
                            ?? string.Join(", ", draft.Features[feature].BlockList.Where(b => b.StartsWith('/'))),
                        found.Refusal.Message);
                continue;
            }

            foreach (var block in found.Result)
            {
                if (!owners.TryAdd(block, draft.Features[feature].Name) && owners[block] != draft.Features[feature].Name)
                {
                    yield return new(
                        field,
                        BlocksOverlap,
                        program.NameOf(program[block]),
                        $"{program.NameOf(program[block])}: it belongs to {owners[block]} and to {draft.Features[feature].Name}. Name "
                            + $"each block once.");
                    break;
                }
            }
        }
    }

    // The reversed range; null if the range does not run backward.
    private static string? Turned(NcProgram program, string selector) =>
        !selector.StartsWith('/') && selector.Split("..") is [var first, var last] && PlaceOf(program, last) < PlaceOf(program, first)
            ? $"{last}..{first}"
            : null;

    // Null for a block that does not exist, or exists twice.
    private static int? PlaceOf(NcProgram program, string name) =>
        BlockSelector.Select(program, [BlockSelector.Parse(name)]) is { IsUsable: true } found ? found.Result[0] : null;

    // Null if nothing is named yet, or if the job's reader reports a problem with a name.
    private static Outcome<int[]>? Find(NcProgram program, FeatureDraft feature)
    {
        try
        {
            return feature.BlockList.Count == 0 ? null : BlockSelector.Select(program, [.. feature.BlockList.Select(BlockSelector.Parse)]);
        }
        catch (InputException)
        {
            return null;
        }
    }
}
