using ErrorMatching.Json;
using ErrorMatching.Nc;

namespace ErrorMatching.Jobs;

/// <summary>Says what is wrong with the program and the blocks of a draft that is not whole yet: no motion that cuts, blocks that are not there, blocks of two features.</summary>
internal static class DraftBlocks
{
    // The word of the mapping, which says the same once everything else is right.
    private const string BlocksOverlap = "blocks-overlap";

    /// <summary>Checks the blocks of each feature that has some.</summary>
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
        catch (Exception e) when (e is InputException or JsonDocumentException or NcException)
        {
            // The job's reader says which control there is none of.
            yield break;
        }

        if (!NcInterpreter.Run(program, dialect).Motions.Any(m => m is { IsCut: true, MovesInPlane: true }))
        {
            yield return new(MatingDraftCheck.Program, "no-cutting-motion", "", $"{Path.GetFileName(draft.Counterpart.Program)} has no motion that cuts in its plane; expected the NC program of the counterpart.");
            yield break;
        }

        var owners = new Dictionary<int, string>();
        for (var feature = 0; feature < draft.Features.Count; feature++)
        {
            if (Find(program, draft.Features[feature]) is not { } found)
            {
                continue;
            }

            var field = DraftPaths.Feature(feature, "blocks");
            if (!found.IsUsable)
            {
                yield return new(field, found.Refusal.Code, "", found.Refusal.Message);
                continue;
            }

            foreach (var block in found.Value)
            {
                if (!owners.TryAdd(block, draft.Features[feature].Name) && owners[block] != draft.Features[feature].Name)
                {
                    yield return new(field, BlocksOverlap, "", $"{program.NameOf(program[block])}: it belongs to {owners[block]} and to {draft.Features[feature].Name}. Name each block once.");
                    break;
                }
            }
        }
    }

    // Null where nothing is named yet, or where the job's reader says what is wrong with a name.
    private static NcOutcome<int[]>? Find(NcProgram program, FeatureDraft feature)
    {
        try
        {
            return feature.BlockList.Count == 0 ? null : BlockSelector.Select(program, [.. feature.BlockList.Select(BlockSelector.Parse)]);
        }
        catch (NcException)
        {
            return null;
        }
    }
}
